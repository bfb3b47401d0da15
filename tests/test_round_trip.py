"""An exam set and marked: the key's own answers are right in every spelling; right ends exactly at
the tolerance.
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.keyed_exam import read_whole
from tests.small_class import asks_of, kinegrade, table
from tests.spellings import SPELLINGS, Spelling, rounded, type_answers

FULL = "15.5"
TINY = Fraction(1, 10**30)


def marked(small_class: Path, tmp_path: Path, typed: Callable[[str, str], str]) -> Path:
    """The MARKS of a class that types `typed(student, column)`."""
    exam, file = small_class / "EXAM", tmp_path / "answers.csv"
    type_answers(exam, file, typed)
    result = kinegrade("grade", exam, file, "-o", tmp_path / "MARKS")
    assert (result.exit_code, result.stdout) == (0, ""), result.stderr
    return tmp_path / "MARKS"


@pytest.mark.parametrize("spell", SPELLINGS.values(), ids=SPELLINGS)
def test_the_keys_own_answers_get_full_marks(
    small_class: Path, tmp_path: Path, spell: Spelling
) -> None:
    keys = asks_of(small_class / "EXAM")
    grades = table(marked(small_class, tmp_path, lambda *place: spell(keys[place])) / "grades.csv")
    assert [(row["total"], row["out_of"], row["percent"]) for row in grades] == [
        (FULL, FULL, "100")
    ] * 4


def test_every_sign_reversed_is_wrong_but_for_zero(small_class: Path, tmp_path: Path) -> None:
    keys = asks_of(small_class / "EXAM")

    def reverse(*place: str) -> str:
        text = keys[place]["decimal"][:20]
        return text[1:] if text.startswith("-") else f"-{text}"

    marks = table(marked(small_class, tmp_path, reverse) / "marks.csv")
    for mark in marks:
        zero = mark["ask"] == "v_x"
        assert mark["points"] == ("1" if zero else "0")
        assert mark["verdict"] in (("right",) if zero else ("wrong", "mistake"))
        assert mark["ask"] != "alpha_AB" or "sense-reversed" in mark["reason"]


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("beyond", "verdict"), [(-1, "right"), (1, "wrong")])
def test_right_ends_at_the_tolerance_to_the_thirtieth_digit(
    small_class: Path, tmp_path: Path, side: int, beyond: int, verdict: str
) -> None:
    keys = {
        examinee.student: examinee.keys
        for examinee in read_whole(open_exam(small_class / "EXAM")).examinees
    }

    def bound(student: str, column: str) -> str:
        key = keys[student][column]
        return decimal(
            key.value + side * (key.rule.room(key.value) + beyond * TINY), 36, ROUND_FLOOR
        )

    found = {mark["verdict"] for mark in table(marked(small_class, tmp_path, bound) / "marks.csv")}
    carried_on = {"follow-through"} if verdict == "wrong" else set()  # all are off alike
    assert {verdict} <= found <= {verdict} | carried_on


def test_the_bound_itself_is_right(small_class: Path, tmp_path: Path) -> None:
    keys = {
        examinee.student: examinee.keys
        for examinee in read_whole(open_exam(small_class / "EXAM")).examinees
    }
    finite: set[tuple[str, str]] = set()

    def bound(student: str, column: str) -> str:
        key = keys[student][column]
        if exact(key) is None:
            return ""
        finite.add((student, column))
        return str(exact(key))

    marks = table(marked(small_class, tmp_path, bound) / "marks.csv")
    verdicts = {
        (mark["student"], f"{mark['question']}.{mark['ask']}"): mark["verdict"] for mark in marks
    }
    assert {column for _, column in finite} >= {"q2.v_x", "q2.v_y", "q3.omega_AB"}
    assert {verdicts[place] for place in finite} == {"right"}


def exact(key: Key) -> str | None:
    """The upper bound as a decimal, if it has one of few digits."""
    text = decimal(key.value + key.rule.room(key.value), 30, ROUND_CEILING)
    return text if Fraction(text) == key.value + key.rule.room(key.value) else None


def decimal(number: Fraction, digits: int, rounding: str) -> str:
    """A fraction as a decimal, rounded."""
    context = Context(prec=digits, rounding=rounding)
    return f"{context.divide(Decimal(number.numerator), Decimal(number.denominator)):f}"


def test_marking_again_gives_the_same_bytes(small_class: Path, tmp_path: Path) -> None:
    keys = asks_of(small_class / "EXAM")
    marks = marked(small_class, tmp_path, lambda *place: rounded(3)(keys[place]))
    before = {file.name: file.read_bytes() for file in marks.iterdir()}
    assert (
        kinegrade(
            "grade", small_class / "EXAM", tmp_path / "answers.csv", "-o", marks, "--force"
        ).exit_code
        == 0
    )
    assert {file.name: file.read_bytes() for file in marks.iterdir()} == before
    assert sorted(before) == [
        "complaints.csv",
        "exam.csv",
        "grades.csv",
        "marks.csv",
        "moodle.csv",
        "policy.toml",
    ]
