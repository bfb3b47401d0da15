"""The sources for LaTeX, read by a person once and held since; `pytest --regenerate-golden` writes
them anew.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from kinegrade.exam.bank.bank import Bank
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.sketch import sketch
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.latex.document import write_document
from kinegrade.press.latex.key import write_key_body
from kinegrade.press.latex.paper import write_paper_body
from kinegrade.press.latex.solution import write_solution_body
from kinegrade.press.sheet import SolutionSheet
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.golden_files import Hold, papers
from tests.press.papers import key_book
from tests.press.solutions import CHINESE_SOLUTION, ENGLISH_SOLUTION


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_paper_for_latex(golden_bank: Bank, hold: Hold, language: Language) -> None:
    page = lay_out_paper(golden_bank, papers(golden_bank)[1], language)
    words = open_catalogue(language).raw("paper", "layout.")
    hold(
        f"paper-{language}.tex",
        write_document([write_paper_body(page)], language, "a4", words, "fonts"),
    )


@pytest.mark.parametrize("sheet", [ENGLISH_SOLUTION, CHINESE_SOLUTION])
def test_worked_solutions_for_latex(sheet: SolutionSheet, hold: Hold) -> None:
    hold(f"solution-{sheet.language}.tex", write_solution_body(sheet))


def test_a_key_for_latex(hold: Hold) -> None:
    hold("key.tex", write_key_body(replace(key_book(1), course="A & B")))


def test_a_figure_for_latex(hold: Hold) -> None:
    template = load_template("slider-crank")
    motion = solve_template(template, {"r": "1/5", "k": "2", "phi": "45"}, ()).motion
    hold(
        "slider-crank.tex",
        write_tikz(sketch(motion.frames.mechanism.map(float), template.figure)),
    )
