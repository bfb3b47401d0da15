"""Checks of a gear on a carrier that rolls on a fixed circle: seen from the carrier both turn about
fixed centres, and their rims move alike.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.shapes import Circle
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, Side, compare
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.vectors import UNITS


def list_carrier_checks(level: Level, case: Case) -> Iterator[Check]:
    """The checks of all gears that roll on a fixed circle, unless nothing moves at this level."""
    for relation in case.motion.frames.relations:
        roll = relation.source.find_rolling() if relation.source else None
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
    gear, frame = (rates[make_turning(body)] for body in (roll.body, carrier))
    if not double(gear - frame):
        return
    turned, unit = UNITS[level, True], UNITS[level, False]
    spin = measure(gear, turned) - measure(frame, turned)
    rim = measure(track.radius, "m").dot(measure(-frame, turned)).signed(sense)
    body, other = map(case.naming.body, (roll.body, carrier))
    yield compare(
        Message(f"solution.rims-{level}", body=body, carrier=other),
        Side(measure(roll.circle.radius, "m").dot(spin), roll.circle.radius * (gear - frame)),
        Side(rim, -track.radius * frame * sense),
        unit,
    )
