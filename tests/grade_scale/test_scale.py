"""Which grade a share of the points earns: bounds are exact and included, curves move them."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kinegrade.errors import BankError
from kinegrade.files.fields.document import FileKind, toml_table
from kinegrade.grade_scale.kinds import make_scale
from kinegrade.grade_scale.scale import Scale
from kinegrade.grade_scale.stated import read_scale
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from tests.said import all_said

_FILE = FileKind("a bank", BankError, 10_000)
_A_HAIR = Fraction(1, 10**12)


def scale_of(text: str, language: str = "en") -> Scale:
    """The scale that a table [scale] states."""
    table = toml_table("bank.toml", f"[scale]\n{text}\n", _FILE)
    stated = read_scale(table)
    table.faults.require_none()
    assert stated is not None
    return make_scale(stated, open_catalogue(Language(language)))


def refused(text: str) -> list[str]:
    """What is said of a table [scale]."""
    with pytest.raises(BankError) as refusal:
        scale_of(text)
    return all_said(refusal.value.faults)


def grade(scale: Scale, percent: Fraction | int | str) -> str:
    return scale.find_step(Fraction(percent) / 100).grade


@pytest.mark.parametrize(
    ("percent", "expected"),
    [(0, "5.0"), (50, "4.0"), (54, "4.0"), (55, "3.7"), (90, "1.3"), (95, "1.0"), (110, "1.0")],
)
def test_german_grades_go_from_the_pass_mark_in_steps_of_a_tenth(
    percent: int, expected: str
) -> None:
    assert grade(scale_of('kind = "german"'), percent) == expected


@pytest.mark.parametrize("text", ['kind = "german"', 'kind = "letters"', 'kind = "five-level"'])
def test_a_bound_is_included_and_a_hair_below_is_the_next_grade(text: str) -> None:
    scale = scale_of(text)
    for better, worse in zip(scale.steps, scale.steps[1:], strict=False):
        assert scale.find_step(better.least) == better
        assert scale.find_step(better.least - _A_HAIR) == worse


def test_half_of_the_points_is_a_pass_however_they_are_written() -> None:
    scale = scale_of('kind = "german"')
    assert scale.find_step(Fraction("4.75") / Fraction("9.5")).passes
    assert not scale.find_step(Fraction("4.7499") / Fraction("9.5")).passes


def test_another_pass_mark_moves_the_german_steps() -> None:
    scale = scale_of('kind = "german"\npass = "40 %"')
    assert [grade(scale, each) for each in (40, 46, 94)] == ["4.0", "3.7", "1.0"]
    assert grade(scale, "39.999") == "5.0"


def test_grades_are_written_in_the_language_of_the_papers() -> None:
    assert grade(scale_of('kind = "german"', "de"), 95) == "1,0"
    assert grade(scale_of('kind = "five-level"', "zh"), 60) == "及格"
    assert grade(scale_of('kind = "five-level"'), 59) == "fail"


def test_a_hundred_rounds_halves_up_and_the_whole_number_passes() -> None:
    scale = scale_of('kind = "hundred"')
    assert [grade(scale, each) for each in ("59.5", "59.4999", 0, 100, 103)] == [
        "60", "59", "0", "100", "100",
    ]  # fmt: skip
    assert scale.find_step(Fraction("0.595")).passes
    assert not scale.find_step(Fraction("0.5949")).passes


def test_grades_of_ones_own_are_given_from_their_bounds_on() -> None:
    scale = scale_of('grades = { top = "7/8", fair = 0.5, out = 0 }\npass = "50 %"')
    assert [grade(scale, each) for each in ("87.5", "87.4", 50, "49.9")] == [
        "top", "fair", "fair", "out",
    ]  # fmt: skip
    assert scale.pass_mark == Fraction(1, 2)


def test_a_curve_is_a_straight_line_through_two_points() -> None:
    """45 % counts as 50 % and 90 % as 95 %, so five points more everywhere."""
    scale = scale_of('kind = "german"\ncurve = { "90 %" = "95 %", "45 %" = "50 %" }')
    assert [grade(scale, each) for each in (45, "44.99", 90, "89.99")] == [
        "4.0", "5.0", "1.0", "1.3",
    ]  # fmt: skip


def test_a_steep_curve_is_exact() -> None:
    """30 % counts as 50 % and 60 % as 80 %: a line through thirds meets 75 % at 55 %."""
    scale = scale_of('kind = "german"\ncurve = { "30 %" = "50 %", "90 %" = "95 %" }')
    bound = next(step.least for step in scale.steps if step.grade == "3.0")  # counts as 65 %
    assert bound == Fraction(3, 10) + Fraction(15, 45) * Fraction(6, 10)
    assert scale.find_step(bound).grade == "3.0"
    assert scale.find_step(bound - _A_HAIR).grade == "3.3"


def test_a_curve_that_lifts_everybody_leaves_no_grade_below() -> None:
    scale = scale_of('kind = "german"\ncurve = { 0 = "60 %", 1 = 1 }')
    assert grade(scale, 0) == "3.3"
    assert scale.steps[-1].least == 0


def test_a_curve_that_takes_points_leaves_the_last_grade_to_all_below() -> None:
    scale = scale_of('kind = "german"\ncurve = { "50 %" = 0, 1 = 1 }')
    assert [grade(scale, each) for each in (0, 50, 75)] == ["5.0", "5.0", "4.0"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "neither a kind nor grades"),
        ('kind = "german"\ngrades = { A = 0.5, B = 0 }\npass = 0.5', "both a kind and grades"),
        ('kind = "french"', '"french"'),
        ('kind = "german"\npass = 1', "100 %"),
        ('kind = "german"\npass = 0', "0 %"),
        ('kind = "letters"\npass = "65 %"', "of the grades begins: 60 %, 70 %, 80 % or 90 %"),
        ("grades = {}\npass = 0.5", "scale.grades"),
        ('kind = "german"\nabsent = ""', '""'),
        ('kind = "german"\nfloor = 1', "scale.floor: unknown key"),
        ("grades = { A = 0.5, B = 0 }", "scale.pass: missing"),
        ("grades = { A = 0 }\npass = 0", "1 grade"),
        ('grades = { A = 0.5, "" = 0 }\npass = 0.5', "a grade without a name"),
        ('kind = "german"\ncurve = { "0.5" = 0.6 }', "1 point"),
        (
            'kind = "german"\ncurve = { "0.4" = 0.6, "0.8" = 0.5 }',
            "more points reached do not count",
        ),
        ('kind = "german"\ncurve = { half = 0.6, "0.8" = 0.9 }', "scale.curve.half"),
        ('kind = "german"\ncurve = { "0.2" = 0.6, "0.8" = 1.9 }', "1.9"),
    ],
)
def test_a_scale_that_cannot_be_is_refused(text: str, expected: str) -> None:
    (fault,) = refused(text)
    assert expected in fault
    assert fault.startswith("bank.toml")
    assert "expected" in fault or "known here" in fault


def test_all_faults_of_a_scale_are_told_at_once() -> None:
    grades = '{ A = "80 %", B = "80 %", C = "90 %", D = "20 %" }'
    faults = refused(f'grades = {grades}\npass = "55 %"\ncurve = {{ "1/2" = 1 }}\nfloor = 1')
    said = "\n".join(faults)
    assert '"B" begins at 80 %, where "A" begins' in said
    assert '"C" begins at 90 %, above the grade "B" before it' in said
    assert "no grade below 20 %" in said
    assert (
        "scale.pass: 55 % - expected the share at which one of the grades begins: 80 %, 90 % or 20 %"
        in said
    )
    assert "scale.curve: 1 point - expected two points" in said
    assert "scale.floor: unknown key" in said
    assert len(faults) == 6


def test_what_an_exam_keeps_of_a_scale_is_the_same_scale() -> None:
    text = 'grades = { A = "2/3", B = 0.1, C = 0 }\npass = 0.1\nabsent = "n.e."\n'
    curve = 'curve = { "1/3" = "1/2", 1 = 1 }'
    table = toml_table("bank.toml", f"[scale]\n{text}{curve}\n", _FILE)
    stated = read_scale(table)
    assert stated is not None
    kept = toml_table("exam.json", "", _FILE)
    again = type(kept)(kept.faults, (), {"scale": stated.record()})
    assert read_scale(again) == stated
    words = open_catalogue(ENGLISH)
    assert make_scale(stated, words).absent == "n.e."
