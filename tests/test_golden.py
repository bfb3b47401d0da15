"""Outputs read by a person once and held since; `pytest --regenerate-golden` writes them anew, to
be read as a diff.
"""

from __future__ import annotations

import json
import re

import pytest

from kinegrade.exam.bank import Bank
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.key_record import make_key_line
from kinegrade.exam.pages import lay_out_paper
from kinegrade.exam.typst_source import write_paper_source
from kinegrade.figure.sketch import sketch
from kinegrade.figure.typst import write_typst
from kinegrade.mechanics.numeric import convert_to_floats
from kinegrade.problem.library import load_template
from kinegrade.problem.solving import solve_template
from tests.golden_files import Hold, papers


def readable(source: str) -> str:
    """The call of the layout, with its one string of data laid out line by line; the figure has its
    own file.
    """
    (data,) = re.findall(r'bytes\((".*")\)\)\)\n', source, re.DOTALL)
    sheet = json.loads(json.loads(data))
    for question in sheet["questions"]:
        question["figure"] = "..."
    return (
        source.replace(data, "...")
        + json.dumps(sheet, ensure_ascii=False, indent=1, sort_keys=True)
        + "\n"
    )


def test_the_key_of_a_tiny_exam(golden_bank: Bank, hold: Hold) -> None:
    lines = (encode_line(make_key_line(paper)) for paper in papers(golden_bank))
    hold("key.jsonl", b"".join(lines).decode())


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_paper_for_the_typesetter(golden_bank: Bank, hold: Hold, language: str) -> None:
    page = lay_out_paper(golden_bank, papers(golden_bank)[1], language)  # type: ignore[arg-type]
    hold(f"paper-{language}.txt", readable(write_paper_source(page)))


def test_a_figure_for_the_typesetter(hold: Hold) -> None:
    template = load_template("slider-crank")
    motion = solve_template(template, {"r": "1/5", "k": "2", "phi": "45"}, ()).motion
    hold(
        "slider-crank.typ",
        write_typst(sketch(convert_to_floats(motion.frames.mechanism), template.figure)),
    )
