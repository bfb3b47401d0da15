"""A student's value put in: numbers of a motion changed by as little as possible to give it."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import TypeVar

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Number
from kinegrade.students.following.followed_terms import (
    Place,
    Share,
)

NOTHING = 1e-12  # relative: anything smaller is rounding
SAME = 1e-9  # relative: how near a reading must come to the student's value
_STRAIGHT = 1e-4  # relative: the largest miss of one step along a tangent, to be refined


@dataclass(frozen=True)
class OwnValue:
    """A student's value: `read` reads the quantity off a motion, `value` is the number that
    replaces it.

    `read` gives None where the motion does not determine the quantity yet. `place` is the body and
    point whose velocity or acceleration it is, `part` the share of a Coriolis or normal part; both
    None for angular and for relative motions.
    """

    read: Callable[[Motion], float | None]
    value: float
    level: Level
    place: Place | None = None
    part: Share | None = None


_Key = TypeVar("_Key", bound=Hashable)


def measure(wanted: OwnValue, motion: Motion) -> float:
    """The student's quantity in a motion, 0 where it has none."""
    return wanted.read(motion) or 0.0


def measure_slope(
    take: Callable[[Mapping[_Key, Number]], Motion],
    wanted: OwnValue,
    found: Mapping[_Key, Number],
    changed: _Key,
    reach: float,
) -> float:
    """The derivative of the student's quantity with respect to one of the numbers that are
    found; `take` gives the motion with them.
    """
    if not reach:
        return 0.0
    above, below = (
        measure(wanted, take({**found, changed: found[changed] + step})) for step in (reach, -reach)
    )
    return (above - below) / (2 * reach)


def move_to_value(
    take: Callable[[Mapping[_Key, Number]], Motion],
    wanted: OwnValue,
    found: Mapping[_Key, Number],
    reaches: Mapping[_Key, float],
) -> Mapping[_Key, Number]:
    """What is found, with some numbers changed by as little as possible so that the student's
    quantity has the student's value.

    Unchanged where the quantity is not linear in them: an angle, or a magnitude that cannot be
    negative.
    """
    moved, now = found, measure(wanted, take(found))
    change = abs(wanted.value - now)
    for tolerance in (_STRAIGHT, SAME, SAME):
        missing = wanted.value - now
        if not abs(missing) > NOTHING * abs(wanted.value):
            return moved
        slopes = {
            name: measure_slope(take, wanted, moved, name, reach) for name, reach in reaches.items()
        }
        steepness = sum(slope * slope for slope in slopes.values())
        if steepness:
            steps = {name: missing * slope / steepness for name, slope in slopes.items()}
            moved = {**moved, **{name: moved[name] + step for name, step in steps.items()}}
            now = measure(wanted, take(moved))
        if not abs(wanted.value - now) <= tolerance * change:
            return found
    return moved
