"""Checks of a wheel between two parallel tracks that do not turn: from one point of contact to the
other, without its centre, only its rotation changes what they have along the tracks.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, Side, compare
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.vectors import UNITS


def list_track_checks(level: Level, case: Case) -> Iterator[Check]:
    """The checks of all wheels between two tracks, unless the wheel does not turn at this level."""
    found = (one.source.find_rolling() for one in case.motion.frames.relations if one.source)
    rolls = [
        (roll, roll.on)
        for roll in found
        if roll and isinstance(roll.on, Line) and not _turns(roll.of, case)
    ]
    for one, other in combinations(rolls, 2):
        if _is_between(one, other):
            yield from _check_contacts(one, other, level, case)


def _turns(body: str, case: Case) -> bool:
    omega = double(case.motion.omega(body))
    alpha = double(case.motion.alpha(body))
    return omega != 0 or alpha != 0


def _is_between(one: tuple[NoSlip, Line], other: tuple[NoSlip, Line]) -> bool:
    """Whether it is one circle's centre that two parallel tracks have beside it."""
    wheels = {(roll.body, roll.circle.centre) for roll, _ in (one, other)}
    first, second = (track.direction for _, track in (one, other))
    return len(wheels) == 1 and not double(first.cross(second))


def _check_contacts(
    one: tuple[NoSlip, Line], other: tuple[NoSlip, Line], level: Level, case: Case
) -> Iterator[Check]:
    """The difference of the contacts along the tracks, and what the rotation makes of it."""
    first, track = one
    second, beyond = other
    rate = case.rates(level)[make_turning(first.body)]
    if not double(rate):
        return
    along = track.direction / length(track.direction, case.arithmetic)
    start, end = (along.dot(_find_motion(roll.of, level, case)) for roll in (first, second))
    unit = UNITS[level, False]
    both = double(start) and double(end)
    numbers = measure(start, unit) - measure(end, unit) if both else measure(start - end, unit)
    arm = along.dot((foot(first.centre, track) - foot(second.centre, beyond)).turned())
    way = Message(f"solution.both-contacts-{level}", body=case.naming.body(first.body))
    left = Side(numbers, start - end)
    radii = tuple(double(roll.circle.radius) for roll in (first, second))
    yield compare(way, left, _state_turning(rate, arm, radii, level), unit)


def _find_motion(body: str, level: Level, case: Case) -> Vector:
    """The velocity or acceleration of a body that does not turn."""
    if body == GROUND:
        return Vector(0, 0)
    bodies = case.motion.frames.mechanism.bodies
    point = next(each.points[0] for each in bodies if each.name == body)
    match level:
        case "velocity":
            return case.motion.velocity(point, body)
        case "acceleration":
            return case.motion.acceleration(point, body)
        case _:
            assert_never(level)


def _state_turning(rate: Any, arm: Any, radii: tuple[float, ...], level: Level) -> Side:
    """The rotation times the distance of the contacts, the sum of the radii or their difference."""
    sign = 1 if double(rate * arm) > 0 else -1
    small, large = sorted(radii)
    between = abs(double(arm)) > large
    distance = measure(large, "m") + measure(small, "m").signed(1 if between else -1)
    numbers = measure(abs(rate), UNITS[level, True]).dot(distance)
    return Side(numbers.signed(sign), rate * arm)
