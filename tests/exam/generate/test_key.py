"""The key of an exam: its lines, exact texts and tolerances."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.rounded_text import write_decimal
from tests.small_class import (
    STUDENTS,
    asks_of,
    key_lines,
)


def test_key_lines_have_the_promised_shape(exam: Path) -> None:
    lines = key_lines(exam)
    assert [line["student"] for line in lines] == list(STUDENTS)
    for line in lines:
        assert list(line) == ["student", "paper", "place", "questions"]
        assert len(line["questions"]) == 3
        for question in line["questions"]:
            assert list(question) == ["question", "template", "parameters", "drawn", "asks"]
            assert list(question["drawn"]) == list(question["parameters"])
            assert [
                entry
                for entry in question["parameters"].values()
                if list(entry) != ["exact", "value", "unit"]
            ] == []
            for name, entry in question["asks"].items():
                mistakes = [] if name == "v_x" else ["mistakes"]  # which is zero whatever one does
                assert list(entry) == [
                    "exact",
                    "value",
                    "unit",
                    "decimal",
                    "tolerance",
                    "points",
                    *mistakes,
                ]
                assert list(entry["tolerance"]) == ["relative", "absolute"]
    assert asks_of(exam)["007", "q1.a_B"]["points"] == 2.5
    assert asks_of(exam)["007", "q3.omega_AB"]["tolerance"] == {
        "relative": 0.005,
        "absolute": 0.001,
    }
    assert asks_of(exam)["007", "q2.v_y"]["tolerance"] == {"relative": 0, "absolute": 0.25}


def test_exact_texts_of_the_key_read_back_to_their_decimals(exam: Path) -> None:
    arithmetic = Balls(400)
    with arithmetic.context():
        for ask in asks_of(exam).values():
            number = evaluate(
                read_expression(ask["exact"]),
                {"pi": arithmetic.turns(1)},
                make_elementary_functions(arithmetic),
                arithmetic,
            )
            read_back, kept = Fraction(write_decimal(number, 40)), Fraction(ask["decimal"])
            assert abs(read_back - kept) <= abs(kept) / 10**35
            assert ask["value"] == float(kept)


def test_zero_answers_carry_an_absolute_tolerance(exam: Path) -> None:
    for line in key_lines(exam):
        values = line["questions"][1]["parameters"]
        zero = line["questions"][1]["asks"]["v_x"]
        assert (zero["exact"], zero["decimal"], zero["value"]) == ("0", "0", 0.0)
        speed = values["r"]["value"] * values["omega"]["value"]
        assert zero["tolerance"] == {"relative": 0.01, "absolute": pytest.approx(speed / 10**10)}
