"""Outputs read by a person once and held since; `pytest --regenerate-golden` writes them anew, to
be read as a diff.
"""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from kinegrade.exam.bank.bank import Bank
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.setting.key_record import make_key_line
from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.figure.sketch import sketch
from kinegrade.press.html.solution import write_blocks
from kinegrade.press.sheet import SolutionSheet
from kinegrade.press.typst.paper import write_paper_source
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.press.word.paper import write_paper_tree
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.golden_files import Hold, papers
from tests.press.solutions import CHINESE_SOLUTION, ENGLISH_SOLUTION


def readable(source: str) -> str:
    """The call of the layout, with its one string of data laid out line by line; the figures have
    their own file.
    """
    (data,) = re.findall(r'bytes\((".*")\)\)\)\n', source, re.DOTALL)
    return source.replace(data, "...") + lay_out(without_figures(json.loads(json.loads(data))))


def without_figures(value: Any) -> Any:
    match value:
        case dict():
            return {
                name: "..." if name == "figure" and held else without_figures(held)
                for name, held in value.items()
            }
        case list():
            return [without_figures(held) for held in value]
        case _:
            return value


def lay_out(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, indent=1, sort_keys=True) + "\n"


def test_the_key_of_a_tiny_exam(golden_bank: Bank, hold: Hold) -> None:
    lines = (encode_line(make_key_line(paper)) for paper in papers(golden_bank))
    hold("key.jsonl", b"".join(lines).decode())


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_paper_for_the_typesetter(golden_bank: Bank, hold: Hold, language: str) -> None:
    page = lay_out_paper(golden_bank, papers(golden_bank)[1], language)  # type: ignore[arg-type]
    hold(f"paper-{language}.txt", readable(write_paper_source(page)))


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_paper_for_word_and_html(golden_bank: Bank, hold: Hold, language: str) -> None:
    page = lay_out_paper(golden_bank, papers(golden_bank)[1], language)  # type: ignore[arg-type]
    tree = json.loads(write_paper_tree(page, {1: "data:image/png;base64,AAAA"}))
    blocks = (json.dumps(block, ensure_ascii=False) for block in tree["blocks"])
    hold(f"paper-{language}.pandoc.jsonl", "".join(f"{block}\n" for block in blocks))


@pytest.mark.parametrize("sheet", [ENGLISH_SOLUTION, CHINESE_SOLUTION])
def test_worked_solutions_for_the_typesetter(sheet: SolutionSheet, hold: Hold) -> None:
    hold(f"solution-{sheet.language}.txt", readable(SolutionLayouts(sheet).write()))


@pytest.mark.parametrize("sheet", [ENGLISH_SOLUTION, CHINESE_SOLUTION])
def test_worked_solutions_as_html(sheet: SolutionSheet, hold: Hold) -> None:
    questions = (write_blocks(each.blocks, sheet.language) for each in sheet.questions)
    hold(f"solution-{sheet.language}.html", "\n".join(questions))


def test_a_figure_for_the_typesetter(hold: Hold) -> None:
    template = load_template("slider-crank")
    motion = solve_template(template, {"r": "1/5", "k": "2", "phi": "45"}, ()).motion
    hold(
        "slider-crank.typ",
        write_typst(sketch(motion.frames.mechanism.map(float), template.figure)),
    )
