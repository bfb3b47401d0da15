"""Checks of points of bodies whose rotation relative to another one is given: seen from that one
the point turns at the given rate, and is carried along besides.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import ImposedRotation, find_imposed_rotation
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount
from kinegrade.worked.checks.arms import point_from
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side, make_side
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, find_sign
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.driven import state_imposed
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.components import list_component, list_turning_summands
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.summands import PLACES


def list_carried_checks(case: Case) -> Iterator[Check]:
    """The checks of the points of bodies that are driven relative to one that turns about a fixed
    axis, in which both motions count.
    """
    pivots = case.motion.frames.mechanism.find_pivots()
    for relation in case.motion.frames.relations:
        law = find_imposed_rotation(relation.source)
        if law is not None and law.of != GROUND and law.of in pivots:
            yield from _list_points(law, relation, pivots[law.of], case)


def _list_points(
    law: ImposedRotation, relation: Relation, axle: str, case: Case
) -> Iterator[Check]:
    frames, base = case.motion.frames, case.motion.frames.bases[law.body].point
    for point in case.motion.points:
        fact = case.findings.facts.get(make_key(frames.chain(law.body, point), "velocity"))
        if fact is None or point == base or not is_lettered(point, case):
            continue
        carried = _Carried(law, relation, axle, base, point)
        for axis in AXES:
            if carried.counts(axis, case):
                yield carried.check(fact, axis, case)


@dataclass(frozen=True)
class _Carried:
    """A point of a driven body, the pin of that body, and the axle of what carries it."""

    law: ImposedRotation
    relation: Relation
    axle: str
    base: str
    point: str

    def counts(self, axis: AxisName, case: Case) -> bool:
        """Whether both motions have a component along an axis."""
        points = case.motion.points
        arms = (points[self.point] - points[start] for start in (self.axle, self.base))
        return all(double(arm.turned()[PLACES[axis]]) for arm in arms)

    def check(self, fact: Fact, axis: AxisName, case: Case) -> Check:
        """v_Bx = -omega_OA y_B - omega_r (y_B - y_A)."""
        points, place = case.motion.points, PLACES[axis]
        rate, turned = make_turning(self.law.of), self.relation.velocity
        vector = points[self.point] - points[self.axle]
        carrying = Term("rotation", rate, vector, self.point, self.axle)
        arm = point_from(self.base, self.point, case).turned()
        share = self._state_rate(case).times(arm.pair[axis])
        transport = make_side(
            list(list_turning_summands(axis, carrying, case, "velocity")),
            case.motion.rates[rate] * vector.turned()[place],
        )
        seen = turned * arm.vector[place]
        every = Side(
            transport.numbers + share.numbers.signed(share.sign),
            transport.value + seen,
            transport.sum + share.letters.signed(share.sign),
        )
        value = fact.value[place]
        found = make_side(list(list_component(fact, axis, case)), value)
        way = Message(
            "solution.carried-point",
            point=case.naming.point(self.point),
            body=case.naming.body(self.law.of),
            axis=axis,
        )
        return compare(way, found, every, "m/s")

    def _state_rate(self, case: Case) -> Amount:
        """The rate that is given, with its sign."""
        said = state_imposed(self.law, self.relation, case, "velocity").equation.links[0].right
        number = measure(self.relation.velocity, "rad/s")
        sign = said.sign
        return Amount(said.size, number.size.signed(sign * find_sign(self.relation.velocity)), sign)
