"""A class whose quiz goes to Canvas: one unit for all, and no draw that its four decimals cannot
tell right.
"""

from __future__ import annotations

import json
import re
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.students.rounding.kept_decimals import RightRange, find_fitting_factor, round_as_kept
from tests.lms.quiz.packages import files_of
from tests.problem.crank import crank_text
from tests.small_class import kinegrade

SPEED = """title = "Quiz"
course = "Mechanics"
tolerance = { relative = "1 %" }
[[questions]]
template = "crank.toml"
draw = { h = [0], r = ["0.002", "1"], omega = [2] }
asks = { v_y = 1 }
"""
RATE = """title = "Quiz"
course = "Mechanics"
tolerance = { relative = "1 %" }
[[questions]]
template = "crank.toml"
draw = { h = [0], r = ["1", "2"], omega = ["0.0012345", "0.0044499", "0.25", "3"] }
asks = { turning = 1 }
"""
TURNING = (
    "v_y = {",
    'turning = { quantity = "omega(OA)", unit = "rad/s", sign = "ccw", points = 1, '
    'means = { en = "rate", zh = "角速度" } }\nv_y = {',
)
STUDENTS = ("student,name\nS1,Ann\nS2,Bo\n", "student,name\nS1,Ann\nS2,Bo\nS3,Cy\nS4,Di\n")


def set_exam(folder: Path, bank: str, roster: str) -> Path:
    (folder / "bank.toml").write_text(bank, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(TURNING), encoding="utf-8")
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    made = kinegrade("generate", *files, "-o", folder / "EXAM", "--seed", "s")
    assert made.exit_code == 0, made.output
    return folder / "EXAM"


def right_answers(exam: Path, ask: str) -> list[float]:
    lines = (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    return [json.loads(line)["questions"][0]["asks"][ask]["value"] for line in lines]


def test_the_whole_class_is_asked_in_the_same_unit(tmp_path: Path) -> None:
    exam = set_exam(tmp_path, SPEED, STUDENTS[0])
    assert sorted(right_answers(exam, "v_y")) == [0.004, 2]
    put = kinegrade("quiz", exam, "--to", "qti12", "-o", tmp_path / "quiz.zip")
    assert "q1.v_y is asked for in mm/s instead of m/s, in the whole class" in put.stderr
    quizzes = [text for text in files_of(tmp_path / "quiz.zip").values() if "<item " in text]
    assert [re.findall(r"\? (\S+) \(1 point\)", text) for text in quizzes] == [["mm/s"]] * 2
    assert ["mm/s here, not m/s" in text for text in quizzes] == [True, True]
    right = {value for text in quizzes for value in re.findall(r"<varequal[^>]*>([^<]*)", text)}
    assert right == {"4", "2000"}


def test_a_bank_that_goes_to_canvas_draws_nothing_that_canvas_cannot_mark(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    other = set_exam(tmp_path / "other", RATE, STUDENTS[1] + "S5,Ed\nS6,Flo\nS7,Gus\nS8,Hal\n")
    assert {0.0012345, 0.0044499} <= set(right_answers(other, "turning"))
    refused = kinegrade("quiz", other, "--to", "qti12", "-o", tmp_path / "other.zip")
    assert refused.exit_code == 2
    assert "is no longer right with the four decimals that Canvas keeps" in refused.stderr
    exam = set_exam(tmp_path, f'lms = "canvas"\n{RATE}', STUDENTS[1])
    assert set(right_answers(exam, "turning")) == {0.25, 3}
    put = kinegrade("quiz", exam, "--to", "qti12", "-o", tmp_path / "quiz.zip")
    assert put.exit_code == 1, put.stderr


RANGES = st.tuples(
    st.fractions(-10, 10, max_denominator=10**6),
    st.fractions(0, Fraction(1, 100), max_denominator=10**6),
).map(lambda drawn: RightRange(drawn[0], drawn[0] - drawn[1], drawn[0] + drawn[1]))


@given(RANGES, st.sampled_from(["m/s", "km", "cm/s^2", "rad/s"]))
def test_what_fits_in_a_unit_fits_in_every_finer_one(right: RightRange, unit: str) -> None:
    factor = find_fitting_factor(unit, right)
    if factor is None:
        assert not right.typed_fits
        return
    finer = right.times(10 * factor)
    assert finer.typed_fits
    assert finer.fits or not right.times(factor).fits


@given(RANGES)
def test_a_right_answer_that_fits_is_right_with_four_decimals(right: RightRange) -> None:
    if right.fits:
        assert right.typed_fits
    assert (right.low <= round_as_kept(right.value) <= right.high) == right.typed_fits


@pytest.mark.parametrize(
    ("value", "unit", "factor"),
    [("0.0012", "rad/s", 1), ("0.00123", "rad/s", None), ("0.00123", "m/s", 1000), ("2", "m", 1)],
)
def test_the_nearest_unit_that_fits_is_taken(value: str, unit: str, factor: int | None) -> None:
    exact = Fraction(value)
    right = RightRange(exact, exact * 99 / 100, exact * 101 / 100)
    assert find_fitting_factor(unit, right) == factor
