"""What may be drawn for a parameter: lists and ranges, and what is refused."""

from __future__ import annotations

from typing import Any

import pytest

from kinegrade.errors import KinegradeError
from kinegrade.problem.template.domain import read_choices


@pytest.mark.parametrize(
    ("draw", "choices"),
    [
        ("15 .. 60 step 15", ("15", "30", "45", "60")),
        ("0.1 .. 0.25 step 0.05", ("0.1", "0.15", "0.2", "0.25")),
        ("-2 .. 2 step 2", ("-2", "0", "2")),
        ("1 .. 2 step 3", ("1",)),
        ("-2 .. 2 step 1 without 0", ("-2", "-1", "1", "2")),
        ("0 .. 90 step 22.5 without 0,90.0, 22.50", ("45", "67.5")),
        ("4 .. 6 step 1/2", ("4", "4.5", "5", "5.5", "6")),
        ("-1/3 .. 5/3 step 2/3 without 1", ("-1/3", "1/3", "5/3")),
        ([1, "sqrt(3)", "3/2"], ("1", "sqrt(3)", "3/2")),
    ],
)
def test_domains(draw: Any, choices: tuple[str, ...]) -> None:
    assert read_choices(draw) == choices


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        ("1..2", "expected a list, or a range like"),
        ("1 .. 2 step -1", "expected a list, or a range like"),
        ("2 .. 1 step 1", "the last value not before the first"),
        ("0 .. 9999 step 1", "at most 2000 values"),
        (
            "1 .. 3 step 1 without 4",
            "expected values of the range after without, but not all of them",
        ),
        ("1 .. 3 step 1 without 1, 2, 3", "after without, but not all of them"),
        ("1 .. 3 step 1 without 1,,2", "expected a decimal number"),
        ("1 .. 3 step 1 without", "expected a list, or a range like"),
        ("1.2.3 .. 4 step 1", '"1.2.3" - expected a decimal number'),
        ("1 .. 3 step 1/0", '"1/0" - expected a decimal number or a fraction'),
        ("1 .. 3 step 1 without 1/", '"1/" - expected a decimal number or a fraction'),
        ("- .. 4 step 1", "expected a list"),
        (". .. 4 step 1", "expected a decimal number"),
        ([1, 1], "2 values - expected 1 to 2000 of them, each once"),
        (["1+"], "character 3"),
        (list(range(2001)), "1 to 2000"),
        (7, "expected a list"),
        ("." * 100_000, "expected a list, or a range"),
        ("9" * 100 + " .. 1 step 1", "more than 60 digits"),
    ],
)
def test_domains_refused(draw: Any, message: str) -> None:
    with pytest.raises(KinegradeError) as refusal:
        read_choices(draw)
    assert message in str(refusal.value)
