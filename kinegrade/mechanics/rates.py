"""The rates: what the unknowns of a motion are, each identified by what moves and how."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Literal, NamedTuple

from kinegrade.mechanics.ground import GROUND
from kinegrade.numbers.number import Number

RateKind = Literal["turning", "sliding", "circling", "free-x", "free-y", "added-x", "added-y"]


class Rate(NamedTuple):
    """One unknown of a motion.

    - turning: the angular velocity of `body`.
    - sliding, circling: the motion of `point` of `body` along a line or a circle of the body `of`.
    - free-x, free-y: the components of the velocity of `point` of `body`, which nothing guides.
    - added-x, added-y: what a student's velocity of `point` of `body` differs by.

    `number` tells apart the rates of one point that two joints guide.
    """

    kind: RateKind
    body: str
    point: str = ""
    of: str = GROUND
    number: int = 0

    @property
    def is_guided(self) -> bool:
        """Whether it is the motion of a point that a joint guides."""
        return self.kind in ("sliding", "circling")


Rates = Mapping[Rate, Number]


@cache
def make_turning(body: str) -> Rate:
    """The angular velocity of a body."""
    return Rate("turning", body)
