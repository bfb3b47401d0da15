"""Single doubles say what arrays of doubles say."""

from __future__ import annotations

import math
from typing import Any

import pytest

from kinegrade.numbers.doubles import Doubles
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats

NUMBERS = (-2.5, -1e-13, 0.0, 1e-13, 0.3, 4.0)


@pytest.mark.parametrize("number", NUMBERS)
def test_functions_agree_with_those_of_arrays(number: float) -> None:
    one, many = Doubles(), Floats()
    for name in ("sin", "cos", "sign", "is_zero"):
        assert getattr(one, name)(number) == pytest.approx(float(getattr(many, name)(number)))
    assert one.arctangent(number, -1.0) == pytest.approx(float(many.arctangent(number, -1.0)))
    assert one.choose(number > 0, 1, 2) == many.choose(number > 0, 1, 2)
    with many.context():
        assert one.sqrt(number) == pytest.approx(float(many.sqrt(number)), nan_ok=True)
    assert one.fork() is one


@pytest.mark.parametrize(
    ("rows", "right"),
    [
        ([[2.0, 1.0], [1.0, 3.0]], [5.0, 10.0]),
        ([[1e-8]], [2.0]),
        ([[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], [1.0, 2.0, 6.0]),
    ],
)
def test_unknowns_agree_with_those_of_arrays(rows: list[list[Any]], right: list[Any]) -> None:
    assert Doubles().solve(rows, right) == pytest.approx(
        [float(each) for each in Floats().solve(rows, right)]
    )


@pytest.mark.parametrize(
    "rows", [[[1.0, 2.0], [2.0, 4.0]], [[1.0, 2.0]], [[math.nan, 1.0], [1.0, 0.0]], [[0.0]]]
)
def test_what_does_not_determine_every_unknown_is_refused(rows: list[list[Any]]) -> None:
    with pytest.raises(Singular):
        Doubles().solve(rows, [1.0] * len(rows))
