"""Doubles of many poses at once, with the small systems of a plan's steps solved outright."""

from __future__ import annotations

from typing import Any

import numpy as np

from kinegrade.numbers.floats import Floats


class Arrays(Floats):
    """The arithmetic of `Floats` along a path, where a dead point is passed: infinities, or NaN,
    are given there instead of refusals.
    """

    def fork(self) -> Arrays:
        """The same arithmetic: doubles need no field."""
        return self

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """The unknowns of rows * unknowns = right at every pose; more than two of them, or surplus
        rows, as `Floats` finds them. Raises Singular where no pose determines those.
        """
        if len(rows) == len(rows[0]) == 1:
            return [np.divide(right[0], rows[0][0])]
        if len(rows) == len(rows[0]) == 2:
            (a, b), (c, d) = rows
            area = np.asarray(a * d - b * c)
            return [(right[0] * d - b * right[1]) / area, (a * right[1] - right[0] * c) / area]
        return super().solve(rows, right)
