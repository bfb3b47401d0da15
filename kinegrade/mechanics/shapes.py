"""The shapes on which points and circles move: values at the instant, in the common frame (x right,
y up).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number


@dataclass(frozen=True)
class Line:
    """A straight line through `point` along `direction` (any length but zero)."""

    point: Vector
    direction: Vector

    def map(self, number: Callable[[Number], Number]) -> Line:
        """The line with `number` applied to its coordinates."""
        return Line(self.point.map(number), self.direction.map(number))


@dataclass(frozen=True)
class Circle:
    """A circle about the named point `centre`; `radius` in metres, positive."""

    centre: str
    radius: Any

    def map(self, number: Callable[[Number], Number]) -> Circle:
        """The circle with `number` applied to its radius."""
        return Circle(self.centre, number(self.radius))


@dataclass(frozen=True)
class Profile:
    """The profile of `body` where it touches another body: a circle, or `of_curvature` where no
    more than its circle of curvature is known, which takes its place to second order.
    """

    body: str
    of_curvature: bool


Shape = Line | Circle
