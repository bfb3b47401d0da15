"""Fast arithmetic: doubles, one or thousands at a time (numpy arrays of instances along the last
axis).
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import Any

import numpy as np

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.number import Magnitude
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.surd import Surd
from kinegrade.numbers.units import Scale

# Rows of unit and metre mixed have condition numbers to 1e6; dependent ones leave about 1e-16
DEPENDENT = 1e-13


class Floats(Magnitude):
    """The arithmetic of doubles and arrays of doubles. Never the reference: tests compare it with
    exact values.
    """

    exact = False
    certified = False

    def fork(self) -> Floats:
        """The same arithmetic: floats need no field."""
        return self

    def context(self) -> AbstractContextManager[Any]:
        """Divisions by zero give infinities, which the caller filters out."""
        return np.errstate(all="ignore")

    def embed(self, value: Any) -> Any:
        """The same double: doubles need no conversion."""
        return value

    def number(self, rational: Any) -> Any:
        """A rational or exact number as a double; arrays stay arrays."""
        if isinstance(rational, (np.ndarray, int, float)):
            return rational
        if isinstance(rational, (Surd, PiMultiple)):
            return float(rational)
        return int(rational.p) / int(rational.q)

    def scale(self, scale: Scale) -> float:
        """What a unit is in SI as a double."""
        return float(self.number(scale.rational)) * np.pi**scale.power

    def turns(self, half_turns: Any) -> Any:
        """The angle of `half_turns` times pi, in radians."""
        return self.number(half_turns) * np.pi

    def is_zero(self, number: Any) -> bool:
        """Whether a number is zero to within rounding, in every instance."""
        return bool(np.all(np.abs(number) < 1e-12))

    def sign(self, number: Any) -> Any:
        """-1, 0 or 1, elementwise; values within rounding of zero count as zero."""
        return np.where(np.abs(number) < 1e-12, 0.0, np.sign(number))

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`, elementwise."""
        return np.where(condition, yes, no)

    def sqrt(self, number: Any) -> Any:
        """The positive square root, elementwise; NaN below zero (but zero within rounding of
        zero).
        """
        return np.sqrt(np.where((number < 0) & (number > -1e-12), 0.0, number))

    def cos(self, angle: Any) -> Any:
        """Cosine of an angle in radians, elementwise."""
        return np.cos(angle)

    def sin(self, angle: Any) -> Any:
        """Sine of an angle in radians, elementwise."""
        return np.sin(angle)

    def arctangent(self, y: Any, x: Any) -> Any:
        """The angle from +x to the vector (x, y) in radians, elementwise."""
        return np.arctan2(y, x)

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """The unknowns of rows * unknowns = right for every instance; surplus rows by least
        squares.

        NaN in instances that do not determine them; raises Singular when no instance does.
        """
        shape = np.broadcast_shapes(
            *(np.shape(entry) for row in rows for entry in row), *map(np.shape, right)
        )
        matrix = np.moveaxis(
            np.array([[np.broadcast_to(e, shape) for e in row] for row in rows]), (0, 1), (-2, -1)
        )
        vector = np.moveaxis(np.array([np.broadcast_to(e, shape) for e in right]), 0, -1)
        finite = np.isfinite(matrix).all(axis=(-2, -1))[..., None, None]
        left, sizes, across = np.linalg.svd(np.where(finite, matrix, 0.0), full_matrices=False)
        regular = (sizes.min(axis=-1) > DEPENDENT * sizes.max(axis=-1)) & (
            len(rows) >= len(rows[0])
        )
        if not regular.any():
            raise Singular
        along = (left.swapaxes(-2, -1) @ vector[..., None]) / np.where(
            regular[..., None], sizes, np.nan
        )[..., None]
        solution = across.swapaxes(-2, -1) @ along
        return list(np.moveaxis(solution[..., 0], -1, 0))

    def require_zero(self, number: Any) -> None:
        """Nothing: the exact arithmetics decide whether surplus equations agree."""
