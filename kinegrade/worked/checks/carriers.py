"""Checks of gears on a carrier: seen from it all turn about fixed centres, and rims that run on
each other move alike, those of gears that a third one joins too.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain, combinations, product

from kinegrade.expressions.tree import find_names
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import EqualRimSpeed, NoSlip, find_rims, find_rolling
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.shapes import Circle
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import subtract
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Form
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rims import state_radii
from kinegrade.worked.rates.rolled_motion import state_rolled_radius
from kinegrade.worked.rates.speeds import name_relative_rotation, state_radius
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.vectors import UNITS


def list_carrier_checks(level: Level, case: Case) -> Iterator[Check]:
    """The checks of all gears that roll on a fixed circle, then of those that mesh with one third
    gear, unless nothing moves at this level.
    """
    return chain(_list_rolling(level, case), _list_joined(level, case))


def _list_rolling(level: Level, case: Case) -> Iterator[Check]:
    for relation in case.motion.frames.relations:
        roll = find_rolling(relation.source)
        if roll and roll.of == GROUND and isinstance(roll.on, Circle):
            for carrier in _find_carriers(roll, roll.on, case):
                yield from _check_rims(roll, roll.on, carrier, level, case)


def _find_carriers(roll: NoSlip, track: Circle, case: Case) -> Iterator[str]:
    """The bodies that join the gear's centre to that of the circle."""
    for body in case.motion.frames.mechanism.bodies:
        if {roll.circle.centre, track.centre} <= set(body.points):
            yield body.name


def _check_rims(
    roll: NoSlip, track: Circle, carrier: str, level: Level, case: Case
) -> Iterator[Check]:
    """The speed of the gear's rim and that of the circle's, seen from the carrier."""
    rates, sense = case.rates(level), 1 if roll.inside else -1
    turning, frame = (rates[make_turning(body)] for body in (roll.body, carrier))
    if not double(turning - frame):
        return
    gear = _Gear(roll.body, roll.circle, state_rolled_radius(roll, case))
    turned, unit = UNITS[level, True], UNITS[level, False]
    radius, ends = _state_track_radius(roll, track, case)
    rim = radius.numbers.dot(measure(frame, turned)).signed(-sense)
    letters = radius.letters * name_relative_rotation(carrier, GROUND, case, level)
    body, other = map(case.naming.body, (roll.body, carrier))
    check = compare(
        Message(f"solution.rims-{level}", body=body, carrier=other),
        _state_rim(gear, carrier, level, case),
        Side(rim, -track.radius * frame * sense, letters.signed(-sense)),
        unit,
        form=subtract(
            _form_rim(gear, carrier), {make_turning(carrier): -double(track.radius) * sense}
        ),
    )
    yield replace(check, arm=ends)


def _state_track_radius(
    roll: NoSlip, track: Circle, case: Case
) -> tuple[Amount, tuple[str, str] | None]:
    """The radius of a fixed circle: as it is given, else by the arm, whose ends are told too, and
    the radius of the gear.
    """
    on = case.template.scheme.joints[roll.joint].on
    given = case.template.parameters
    if on is None or {*find_names(on.arguments[1])} <= {*given}:
        stated = state_radius(on, track.radius, case)
        return Amount(stated, measure(track.radius, "m")), None
    points, ends = case.motion.points, (track.centre, roll.circle.centre)
    arm = length(points[ends[1]] - points[ends[0]], case.arithmetic)
    sign = 1 if roll.inside else -1
    letters = name_length(*ends, case) + state_rolled_radius(roll, case).signed(sign)
    numbers = measure(arm, "m") + measure(roll.circle.radius, "m").signed(sign)
    return Amount(letters, numbers), ends


@dataclass(frozen=True)
class _Gear:
    """A body with the circle on which it meshes, whose radius has these letters."""

    body: str
    circle: Circle
    radius: Formula

    def is_same(self, other: _Gear) -> bool:
        """Whether the other one is this circle of this body."""
        radii = (double(gear.circle.radius) for gear in (self, other))
        return self.body == other.body and len(set(radii)) == 1


@dataclass(frozen=True)
class _Pair:
    """Two gears in mesh, the second one seen from the first; -1 where they turn in opposite
    senses.
    """

    first: _Gear
    second: _Gear
    carrier: str
    sense: int


def _list_joined(level: Level, case: Case) -> Iterator[Check]:
    """The checks of gears that mesh with the same circle of a third one."""
    found = (find_rims(relation.source) for relation in case.motion.frames.relations)
    for one, other in combinations(filter(None, found), 2):
        for first, second in product(_list_pairs(one, case), _list_pairs(other, case)):
            if first.carrier == second.carrier and first.second.is_same(second.second):
                yield from _check_joined(first, second, level, case)


def _list_pairs(mesh: EqualRimSpeed, case: Case) -> tuple[_Pair, _Pair]:
    """Two gears in mesh, in either order."""
    radii = state_radii(mesh, case)
    one, other = _Gear(mesh.body, mesh.circle, radii[0]), _Gear(mesh.of, mesh.on, radii[1])
    sense = -1 if mesh.is_opposite else 1
    return _Pair(one, other, mesh.carrier, sense), _Pair(other, one, mesh.carrier, sense)


def _check_joined(one: _Pair, other: _Pair, level: Level, case: Case) -> Iterator[Check]:
    """The rim speeds of both gears that mesh with the third one, seen from the carrier."""
    sense = one.sense * other.sense
    left, right = (_state_rim(pair.first, pair.carrier, level, case) for pair in (one, other))
    if not double(left.value):
        return
    name = case.naming.body
    way = Message(
        f"solution.joined-rims-{level}",
        first=name(one.first.body),
        second=name(other.first.body),
        idler=name(one.second.body),
        carrier=name(one.carrier),
    )
    turned = Side(right.numbers.signed(sense), right.value * sense, right.sum.signed(sense))
    form = subtract(_form_rim(one.first, one.carrier), _form_rim(other.first, other.carrier, sense))
    yield compare(way, left, turned, UNITS[level, False], form=form)


def _state_rim(gear: _Gear, carrier: str, level: Level, case: Case) -> Side:
    """The speed of a gear's rim, seen from the carrier."""
    rates, turned = case.rates(level), UNITS[level, True]
    rate, radius = rates[make_turning(gear.body)], gear.circle.radius
    frame = rates[make_turning(carrier)]
    spin = measure(rate, turned) - measure(frame, turned)
    letters = gear.radius * name_relative_rotation(gear.body, carrier, case, level)
    return Side(measure(radius, "m").dot(spin), radius * (rate - frame), letters)


def _form_rim(gear: _Gear, carrier: str, sense: int = 1) -> Form:
    """The same, by what multiplies the rates."""
    radius = double(gear.circle.radius) * sense
    return {make_turning(gear.body): radius, make_turning(carrier): -radius}
