"""The arithmetic of a student who does not notice that equations contradict each other.

Surplus equations are not checked, and where there are more equations than unknowns, the vectors are
projected.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True)
class Unsuspecting:
    """An arithmetic that solves as a student does who does not notice that equations contradict
    each other.
    """

    arithmetic: Arithmetic

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Number]:
        """The unknowns; surplus equations are projected on them. Raises Singular."""
        if len(rows[0]) == 1:
            return [
                self._divide(
                    _sum_products([row[0] for row in rows], right),
                    _sum_products(*([row[0] for row in rows],) * 2),
                )
            ]
        if len(rows) > len(rows[0]):
            columns = list(zip(*rows, strict=True))
            rows, right = (
                [[_sum_products(one, other) for other in columns] for one in columns],
                [_sum_products(one, right) for one in columns],
            )
        return (
            self._solve_pair(rows, right)
            if len(rows) == 2
            else list(self.arithmetic.solve(rows, right))
        )

    def _solve_pair(self, rows: list[list[Any]], right: list[Any]) -> list[Number]:
        """Two unknowns from two equations."""
        (a, b), (c, d) = rows
        area = a * d - b * c
        return [
            self._divide(right[0] * d - b * right[1], area),
            self._divide(a * right[1] - right[0] * c, area),
        ]

    def _divide(self, number: Any, divisor: Any) -> Number:
        """A quotient; Singular, or not a number in some instances, over zero."""
        if self.arithmetic.is_zero(divisor):
            raise Singular
        below = self.arithmetic.number(divisor) if isinstance(divisor, int) else divisor
        return number / below  # type: ignore[no-any-return]

    def require_zero(self, number: Any) -> None:
        """Nothing: surplus equations are not checked."""


def _sum_products(left: Sequence[Number], right: Sequence[Number]) -> Number:
    """The sum of the products."""
    return sum((a * b for a, b in zip(left, right, strict=True)), 0)
