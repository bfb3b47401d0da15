"""The class report on papers as they were set: whether those were harder that were predicted to be,
and what was lost to rounding. Students of `tests/by_hand` answer, through the command line.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.reports.predictions import find_predictions
from tests.by_hand.class_list import TAUGHT
from tests.by_hand.pad import EXACT, Answers, Pad
from tests.by_hand.school import (
    FOUR_FIGURES,
    Exam,
    Mark,
    Paper,
    Question,
    Typed,
    kinegrade,
    make_exam,
)

pytestmark = pytest.mark.xdist_group("report on papers")  # one worker sets the exam, once
TEMPLATES = ("slider-crank", "pole-four-bar-coupler")
STUDENTS = 48
Places = Mapping[str, list[int]]
Hard = Callable[[int], bool]  # of the place among papers from the easiest to the hardest


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Exam:
    folder = tmp_path_factory.mktemp("papers") / "class"
    return make_exam(folder, TEMPLATES, STUDENTS, FOUR_FIGURES, "papers")


@pytest.fixture(scope="module")
def places(exam: Exam) -> Places:
    """For each question the places of the papers, from the easiest to the hardest."""
    predicted = find_predictions(open_exam(exam.folder)).difficulties
    return {
        question.number: sorted(
            range(STUDENTS),
            key=lambda place: predicted[exam.papers[place].student][question.number],
        )
        for question in exam.papers[0].questions
    }


def said(key: str) -> str:
    return open_catalogue(ENGLISH).text(f"report.{key}")


def answered(exam: Exam, typed: Typed, figures: int = EXACT) -> tuple[list[Mark], Path]:
    """The marks of a class, and their folder."""
    marks = exam.mark(typed, figures)
    return marks, max(exam.folder.parent.glob("*/MARKS"), key=lambda each: each.stat().st_mtime)


def report(folder: Path, marks: Path) -> str:
    file = marks.with_name("report.html")
    kinegrade("report", folder, marks, "-o", file, "--force")
    return file.read_text(encoding="utf-8")


def read_row(html: str, name: str) -> list[str]:
    """The cells of the row that begins so, in the table of predictions."""
    table = html.partition(said("page.predicted-spread"))[2]
    row = re.search(rf"<tr><td>{re.escape(name)}</td>(.*?)</tr>", table)
    assert row, name
    return re.findall(r"<td[^>]*>(.*?)</td>", row[1])


def lost_to_rounding(html: str) -> int:
    name = re.escape(said("reason-rounded"))
    return sum(map(int, re.findall(rf'<td>{name}</td><td class="number">(\d+)', html)))


def miss(question: Question) -> Answers:
    """Answers that no mistake, no guess and no rounding explains."""
    return {
        ask: (1.23 + 0.31 * place) * value
        for place, (ask, value) in enumerate(question.right.items())
    }


def fail(places: Places, hard: Hard) -> Typed:
    """A class that misses a question where its place among the papers is hard."""

    def typed(paper: Paper, question: Question) -> Answers:
        place = places[question.number].index(paper.place)
        return miss(question) if hard(place) else question.right

    return typed


class Found(NamedTuple):
    """What the report says, between which bounds the correlation is, and the advantage of the
    papers predicted easiest over the hardest, in per cent.
    """

    conclusion: str
    correlation: tuple[float, float]
    advantage: tuple[int, int]


@pytest.mark.parametrize(
    ("hard", "expected"),
    [
        (lambda place: place >= STUDENTS / 2, Found("prediction-held", (0.4, 1.0), (30, 100))),
        (lambda place: place < STUDENTS / 2, Found("prediction-reversed", (-1, -0.4), (-100, -30))),
        (lambda place: place % 2 == 0, Found("prediction-not-seen", (-0.3, 0.3), (-50, 50))),
    ],
)
def test_what_was_predicted_is_held_against_the_points_lost(
    exam: Exam, places: Places, hard: Hard, expected: Found
) -> None:
    html = report(exam.folder, answered(exam, fail(places, hard))[1])
    assert said(expected.conclusion) in html
    for number in (1, 2):
        predicted, *thirds, found, _, _ = read_row(html, f"Question {number}")
        shares = [int(re.findall(r"\d+", third)[0]) for third in thirds if third]
        assert re.fullmatch(r"\d+\.\d\d ± \d\.\d\d", predicted)
        lowest, highest = expected.correlation
        assert lowest <= float(found.replace("−", "-")) <= highest
        assert expected.advantage[0] <= shares[0] - shares[-1] <= expected.advantage[1]
    assert len(read_row(html, said("whole-paper"))) == 7
    assert not lost_to_rounding(html)


def test_what_three_figures_cost_is_told_apart_from_what_was_not_understood(exam: Exam) -> None:
    def typed(paper: Paper, question: Question) -> Answers:
        method = next(iter(TAUGHT[question.template].methods.values()))
        return method(question.givens, Pad(3))

    marks, folder = answered(exam, typed, 3)
    lost = [mark for mark in marks if mark.lost and not mark.names]
    assert lost
    html = report(exam.folder, folder)
    assert lost_to_rounding(html) == len(lost)
    assert said("reason-unexplained") not in html
    assert said("reason-close") not in html


def test_an_exam_that_asks_for_three_figures_finds_two_too_coarse(
    exam: Exam, tmp_path: Path
) -> None:
    shutil.copytree(exam.folder, tmp_path / "EXAM")
    bank = tmp_path / "EXAM" / "bank.toml"
    text = bank.read_text(encoding="utf-8").replace("carry = 4", "carry = 3")
    bank.write_text(text, encoding="utf-8")
    three, two = (
        find_predictions(open_exam(folder)).rounding for folder in (exam.folder, tmp_path / "EXAM")
    )
    assert len(three) == STUDENTS
    for student, bounds in three.items():
        assert bounds
        for column, bound in bounds.items():
            assert two[student][column] >= 9.99 * bound


def test_nothing_is_said_where_the_folder_no_longer_says_it(
    exam: Exam, places: Places, tmp_path: Path
) -> None:
    _, marks = answered(exam, fail(places, lambda place: place >= STUDENTS / 2))
    shutil.copytree(exam.folder, tmp_path / "EXAM")
    for file in (tmp_path / "EXAM" / "templates").rglob("slider-crank.toml"):
        file.write_text("schema = 99\n", encoding="utf-8")
    html = report(tmp_path / "EXAM", marks)
    assert said("page.hardness") in html
    assert said("whole-paper") not in html
    assert said("prediction-held") not in html
