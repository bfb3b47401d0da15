"""Branches: which of two common points of circles, or of a line and a circle, is meant."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, assert_never

from kinegrade.mechanics.vector import Vector

Side = str
_SIDES: Mapping[Side, Callable[[Vector], Any]] = {
    "right": lambda p: p.x,
    "left": lambda p: -p.x,
    "upper": lambda p: p.y,
    "lower": lambda p: -p.y,
}
_TURNS: Mapping[Side, int] = {"counterclockwise": 1, "clockwise": -1}
BRANCHES = (*_SIDES, *_TURNS)
DIRECTED = ("left of A->B", "right of A->B")  # with points of the template
_AHEAD: Mapping[str, int] = {"left": 1, "right": -1}


@dataclass(frozen=True)
class Beside:
    """The side of a directed line: to the left of who looks along it, or to the right."""

    axis: Vector
    side: Literal["left", "right"]

    def __str__(self) -> str:
        return self.side


Branch = Side | Beside


def measure_lead(
    first: Vector, second: Vector, axis: Vector, origin: Vector, branch: Branch
) -> Any:
    """How much farther the first of two points lies on the named side than the second."""
    match branch:
        case Beside(across, side):
            return across.cross(first - second) * _AHEAD[side]
        case str() if branch in _TURNS:
            turn = _TURNS[branch]
            return axis.cross(first - origin) * turn - axis.cross(second - origin) * turn
        case str():
            return _SIDES[branch](first) - _SIDES[branch](second)
        case _:
            assert_never(branch)
