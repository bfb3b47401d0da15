"""Checks of wheels on an arm that turns: both have one velocity at their relative pole, which parts
the arm as the radii.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import EqualRimSpeed, find_rims
from kinegrade.mechanics.rates import make_turning
from kinegrade.numbers.number import Number
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rims import state_radii
from kinegrade.worked.vectors.arms import name_length


def list_relative_poles(case: Case) -> Iterator[Check]:
    """The checks of crossed belts between a wheel about the axle of an arm and one at its end."""
    pivots = case.motion.frames.mechanism.find_pivots()
    for relation in case.motion.frames.relations:
        belt = find_rims(relation.source)
        if belt is None or GROUND in (belt.body, belt.of) or not _is_crossed(belt):
            continue
        axle = pivots.get(belt.carrier)
        for one, other in _list_wheels(belt, case):
            if axle is not None and one.centre == axle and double(one.rate):
                yield _check(one, other, belt.carrier, case)


def _is_crossed(belt: EqualRimSpeed) -> bool:
    """Whether rims are joined by a crossed belt."""
    return belt.is_belt and belt.is_opposite


@dataclass(frozen=True)
class _Wheel:
    """A wheel with its radius, in letters too, and its angular velocity."""

    body: str
    centre: str
    letters: Formula
    radius: Number
    rate: Number


def _list_wheels(belt: EqualRimSpeed, case: Case) -> Iterator[tuple[_Wheel, _Wheel]]:
    """Both wheels, in either order."""
    letters, rates = state_radii(belt, case), case.motion.rates
    first, second = (
        _Wheel(body, circle.centre, name, circle.radius, rates[make_turning(body)])
        for body, circle, name in zip(
            (belt.body, belt.of), (belt.circle, belt.on), letters, strict=True
        )
    )
    yield first, second
    yield second, first


def _check(fixed: _Wheel, carried: _Wheel, arm: str, case: Case) -> Check:
    """r1/(r1 + r2) l omega_1 = l omega_0 - r2/(r1 + r2) l omega_2."""
    points, turning = case.motion.points, case.motion.rates[make_turning(arm)]
    far = length(points[carried.centre] - points[fixed.centre], case.arithmetic)
    span, name = measure(far, "m"), name_length(fixed.centre, carried.centre, case)
    whole = fixed.radius + carried.radius
    total = measure(fixed.radius, "m") + measure(carried.radius, "m")
    letters, numbers = list[Formula](), list[Formula]()
    for wheel in (fixed, carried):
        part = wheel.letters / (fixed.letters + carried.letters)
        letters.append(part * name * case.naming.omega(wheel.body))
        share = measure(wheel.radius, "m") / total
        numbers.append(share.dot(span).dot(measure(wheel.rate, "rad/s")))
    left = Side(numbers[0], fixed.radius / whole * far * fixed.rate, letters[0])
    right = Side(
        span.dot(measure(turning, "rad/s")) - numbers[1],
        far * turning - carried.radius / whole * far * carried.rate,
        name * case.naming.omega(arm) - letters[1],
    )
    first, second, frame = map(case.naming.body, (fixed.body, carried.body, arm))
    way = Message("solution.relative-pole-of-wheels", first=first, second=second, arm=frame)
    return compare(way, left, right, "m/s")
