"""Outputs read by a person once and held since; `pytest --regenerate-golden` writes them anew, to be read as a diff."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from kinegrade.exam.bank import Bank, read_bank
from kinegrade.exam.generate import key_record
from kinegrade.exam.pages import paper_pages
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.setting import SetPaper, set_exam
from kinegrade.exam.typst_source import paper_source
from kinegrade.figure.sketch import sketch
from kinegrade.figure.typst import to_typst
from kinegrade.mechanics.numeric import drawable_mechanism
from kinegrade.problem.library import load_template
from kinegrade.problem.solving import solve_template
from tests.problem.crank import crank_text
from tests.small_class import VANISHING

GOLDEN = Path(__file__).parent / "golden"
BANK = """title = { en = "Golden exam", zh = "样卷" }
course = { en = "Mechanics", zh = "力学" }
date = 2026-05-01
[[questions]]
template = "crank.toml"
draw = { h = [0, 1], r = [2, 3, 4], omega = [2, 3, "sqrt(2)"] }
asks = { v_x = 1, v_y = { points = 2.5, tolerance = { absolute = 0.05 } } }
"""
Hold = Callable[[str, str], None]


@pytest.fixture
def hold(request: pytest.FixtureRequest) -> Hold:
    """Holds a text against the file of that name, or writes it."""

    def compare(name: str, text: str) -> None:
        if request.config.getoption("--regenerate-golden"):
            (GOLDEN / name).write_text(text, encoding="utf-8", newline="\n")
        assert text == (GOLDEN / name).read_text(encoding="utf-8")

    return compare


@pytest.fixture
def bank(tmp_path: Path) -> Bank:
    (tmp_path / "crank.toml").write_text(crank_text(VANISHING), encoding="utf-8")
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    return read_bank(tmp_path / "bank.toml")


def papers(bank: Bank) -> list[SetPaper]:
    students = Student("007", "王伟", "", "007"), Student("0012", "O'Neil, Zoë", "", "0012")
    return list(set_exam(bank, Roster(students, ()), "golden").papers())


def readable(source: str) -> str:
    """The call of the layout, with its one string of data laid out line by line; the figure has its own file."""
    (data,) = re.findall(r'bytes\((".*")\)\)\)\n', source, re.DOTALL)
    sheet = json.loads(json.loads(data))
    for question in sheet["questions"]:
        question["figure"] = "..."
    return source.replace(data, "...") + json.dumps(sheet, ensure_ascii=False, indent=1, sort_keys=True) + "\n"


def test_the_key_of_a_tiny_exam(bank: Bank, hold: Hold) -> None:
    hold("key.jsonl", "".join(json.dumps(key_record(paper), ensure_ascii=False) + "\n" for paper in papers(bank)))


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_paper_for_the_typesetter(bank: Bank, hold: Hold, language: str) -> None:
    page = paper_pages(bank, papers(bank)[1], language)  # type: ignore[arg-type]
    hold(f"paper-{language}.txt", readable(paper_source(page)))


def test_a_figure_for_the_typesetter(hold: Hold) -> None:
    template = load_template("slider-crank")
    motion = solve_template(template, {"r": "1/5", "k": "2", "phi": "45"}, ()).motion
    hold("slider-crank.typ", to_typst(sketch(drawable_mechanism(motion.frames.mechanism), template.figure)))
