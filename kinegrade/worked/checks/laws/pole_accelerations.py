"""Checks of the acceleration of the velocity pole of a rolling wheel: the angular velocity times
the speed at which the point of contact moves along the track.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rolling
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.shapes import Line
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.measures import double, is_zero, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.speeds import find_term, name_speed
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.facts import make_key


def list_pole_accelerations(case: Case) -> Iterator[Check]:
    """The checks of the lettered points at which wheels touch fixed straight tracks."""
    frames = case.motion.frames
    for relation in frames.relations:
        roll = find_rolling(relation.source)
        if roll is None or roll.of != GROUND or not isinstance(roll.on, Line):
            continue
        contact = foot(roll.centre, roll.on)
        for point, place in case.motion.points.items():
            fact = case.findings.facts.get(make_key(frames.chain(roll.body, point), "acceleration"))
            if fact is not None and is_lettered(point, case) and is_zero(place - contact):
                yield from _check(roll, relation, (point, fact), case)


def _check(roll: NoSlip, relation: Relation, pole: tuple[str, Fact], case: Case) -> Iterator[Check]:
    """a_C = |omega| |v_O|, where the wheel moves."""
    point, fact = pole
    term, omega = find_term(relation.turning[0][0], case), case.motion.omega(roll.body)
    speed = length(term.velocity(case.motion.rates), case.arithmetic)
    turning = omega if double(omega) > 0 else -omega
    if not double(turning) or not double(speed):
        return
    found = length(fact.value, case.arithmetic)
    rate = Amount(abs(case.naming.omega(roll.body)), measure(turning, "rad/s"))
    product = rate.times(Amount(abs(name_speed(term, case, "velocity")), measure(speed, "m/s")))
    way = Message(
        "solution.acceleration-of-pole",
        pole=case.naming.point(point),
        body=case.naming.body(roll.body),
    )
    left = Side(measure(found, "m/s^2"), found, fact.symbol)
    yield compare(way, left, Side(product.numbers, turning * speed, product.letters), "m/s^2")
