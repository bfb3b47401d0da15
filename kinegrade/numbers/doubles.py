"""The arithmetic of `Floats` for a single instance: plain doubles, without the cost of arrays."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import DEPENDENT, Floats

_ZERO = 1e-12  # `Floats` takes it for zero too


class Doubles(Floats):
    """Single doubles. Never the reference; the results are those of `Floats`."""

    def fork(self) -> Doubles:
        """The same arithmetic: doubles need no field."""
        return self

    def is_zero(self, number: Any) -> bool:
        """Whether a number is zero to within rounding."""
        return bool(abs(number) < _ZERO)

    def sign(self, number: Any) -> float:
        """-1, 0 or 1; a value within rounding of zero counts as zero."""
        return 0.0 if abs(number) < _ZERO else math.copysign(1.0, number)

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`."""
        return yes if condition else no

    def sqrt(self, number: Any) -> float:
        """The positive square root; NaN below zero (but zero within rounding of zero)."""
        return math.sqrt(max(number, 0.0)) if number > -_ZERO else math.nan

    def cos(self, angle: Any) -> float:
        """Cosine of an angle in radians."""
        return math.cos(angle)

    def sin(self, angle: Any) -> float:
        """Sine of an angle in radians."""
        return math.sin(angle)

    def arctangent(self, y: Any, x: Any) -> float:
        """The angle from +x to the vector (x, y) in radians."""
        return math.atan2(y, x)

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """The unknowns of rows * unknowns = right; surplus rows by least squares. Raises
        Singular.
        """
        if len(rows) == len(rows[0]) == 2:
            return _pair(rows, right)
        matrix = np.array(rows, dtype=float)
        if len(rows) < len(rows[0]) or not np.isfinite(matrix).all():
            raise Singular
        left, sizes, across = np.linalg.svd(matrix, full_matrices=False)
        if sizes[-1] <= DEPENDENT * sizes[0]:
            raise Singular
        unknowns: list[Any] = (across.T @ (left.T @ np.array(right, dtype=float) / sizes)).tolist()
        return unknowns


def convert_number(number: Any) -> Any:
    """A number of any arithmetic as a double, angles in radians; arrays of doubles stay what they
    are.
    """
    if isinstance(number, np.ndarray):
        return number
    return float(number.ball() if isinstance(number, Angle) else number)


def _pair(rows: list[list[Any]], right: list[Any]) -> list[Any]:
    """Two unknowns from two equations, as most steps of a plan have them. Raises Singular."""
    (a, b), (c, d) = rows
    area = a * d - b * c
    if not abs(area) > DEPENDENT * (a * a + b * b + c * c + d * d):
        raise Singular
    return [(right[0] * d - b * right[1]) / area, (a * right[1] - right[0] * c) / area]
