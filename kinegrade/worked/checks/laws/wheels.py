"""Checks of points of rolling wheels whose velocities the pole has given: by the centre as base
point, whose own velocity has been found.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rolling
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.relative_shares import find_speed
from kinegrade.worked.checks.sides import make_side
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.rates.speeds import find_term, name_speed
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.components import list_component, list_turning_summands
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.summands import PLACES


def list_wheel_checks(case: Case) -> Iterator[Check]:
    """The checks of the points of wheels that roll on fixed tracks, along an axis each, in which
    both the centre and the rotation count.
    """
    match case.method:
        case "base-point":
            return  # a check by the centre would say it again
        case "projection" | "pole" | None:
            pass
        case _:
            assert_never(case.method)
    for relation in case.motion.frames.relations:
        roll = find_rolling(relation.source)
        if roll is not None and roll.of == GROUND:
            yield from _list_points(roll, _find_centre(roll, relation, case), case)


def _find_centre(roll: NoSlip, relation: Relation, case: Case) -> Fact:
    """The velocity of the centre, as it has been found, else as it is given along the track."""
    found = _find_fact(roll.body, roll.circle.centre, case)
    if found is not None:
        return found
    term = find_term(relation.turning[0][0], case)
    symbol, value = name_speed(term, case, "velocity"), term.velocity(case.motion.rates)
    _, positive = find_speed(term, case)
    return Fact(symbol, value, False, (Piece(symbol, positive, value, term),))


def _list_points(roll: NoSlip, found: Fact, case: Case) -> Iterator[Check]:
    centre = roll.circle.centre
    for point in case.motion.points:
        fact = _find_fact(roll.body, point, case)
        if point == centre or fact is None or not is_lettered(point, case):
            continue
        arm = case.motion.points[point] - case.motion.points[centre]
        for axis in AXES:
            across = double(arm.turned()[PLACES[axis]])
            if across and double(found.value[PLACES[axis]]) and double(fact.value[PLACES[axis]]):
                turn = Term("rotation", make_turning(roll.body), arm, point, centre)
                yield _check(turn, (found, fact), axis, case)


def _find_fact(body: str, point: str, case: Case) -> Fact | None:
    chain = case.motion.frames.chain(body, point)
    return case.findings.facts.get(make_key(chain, "velocity"))


def _check(turn: Term, facts: tuple[Fact, Fact], axis: AxisName, case: Case) -> Check:
    """v_Bx = v_Ox - omega (y_B - y_O)."""
    before, after = (list(list_component(fact, axis, case)) for fact in facts)
    before += list_turning_summands(axis, turn, case, "velocity")
    value = facts[1].value[PLACES[axis]]
    followed = (
        facts[0].value[PLACES[axis]]
        + case.motion.rates[turn.rate] * (turn.vector.turned()[PLACES[axis]])
    )
    first, second = map(case.naming.point, (turn.base, turn.point))
    way = Message("solution.component-check-velocity", axis=axis, first=first, second=second)
    return compare(way, make_side(after, value), make_side(before, followed), "m/s")
