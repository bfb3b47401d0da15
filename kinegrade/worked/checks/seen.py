"""Checks of a relative velocity that has been found as a difference: seen from the frame, another
point of the body moves along a track, and the body turns about it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, add_letters, add_numbers, gather, point_along
from kinegrade.worked.checks.arms import point_from
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import multiply_chain, subtract
from kinegrade.worked.checks.relative_shares import find_speed
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Fact, Form
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, find_sign
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.speeds import name_relative_rotation
from kinegrade.worked.vectors.relatives import Relative
from kinegrade.worked.vectors.summands import PLACES, name_component


def list_seen_checks(case: Case) -> Iterator[Check]:
    """The checks of all such velocities, along an axis each."""
    for tree, fact in case.findings.answered.items():
        motion = _read_motion(tree)
        if motion is None or not fact.by_components:
            continue
        for term in _list_tracks(motion, case):
            _, positive = find_speed(term, case)
            for axis in AXES:
                along = not double(positive.cross(point_along(axis).vector))
                if along and double(fact.value[PLACES[axis]]):
                    yield _compare(motion, term, fact, axis, case)


def _read_motion(tree: Expression) -> Relative | None:
    """Which point of which body moves relative to which frame, in a relative velocity."""
    match tree:
        case Call(function="relative_velocity", arguments=(Name(point), Name(body), Name(frame))):
            return Relative(point, body, frame)
        case _:
            return None


def _list_tracks(motion: Relative, case: Case) -> Iterator[Term]:
    """The straight tracks in the frame of other points of the body, with what has been found."""
    relations = case.motion.frames.relations
    for term in chain.from_iterable((*one.left, *one.right) for one in relations):
        ours = term.kind == "sliding" and term.rate.body == motion.body
        found = not case.findings.spares(term.rate, "velocity")
        if ours and found and term.frame == motion.frame and term.point != motion.point:
            yield term


def _compare(motion: Relative, term: Term, fact: Fact, axis: AxisName, case: Case) -> Check:
    """v_r = v_rC - (omega - omega_e) y, along an axis."""
    rates, by = case.motion.rates, point_along(axis)
    speed, positive = find_speed(term, case)
    bodies = [make_turning(body) for body in (motion.body, motion.frame)]
    turning, frame = (measure(rates[rate], "rad/s") for rate in bodies)
    spin = Amount(
        name_relative_rotation(motion.body, motion.frame, case, "velocity"), turning - frame
    )
    arm = point_from(term.point, motion.point, case).turned()
    turned = gather(spin, tuple(by.dot(arm.pair)))
    every = (speed.signed(find_sign(by.vector.dot(positive))), *turned)
    value, away = fact.value[PLACES[axis]], term.velocity(rates)
    spinning = double(rates[bodies[0]] - rates[bodies[1]])
    followed = double(away[PLACES[axis]]) + spinning * double(arm.vector[PLACES[axis]])
    frames = case.motion.frames
    moved = subtract(
        multiply_chain(frames.chain(motion.body, motion.point), by.vector),
        multiply_chain(frames.chain(motion.frame, motion.point), by.vector),
    )
    across = double(by.vector.dot(arm.vector))
    seen: Form = {bodies[0]: across, bodies[1]: -across}
    left = Side(measure(value, "m/s"), value, name_component(fact.symbol, axis))
    body, seen_from = map(case.naming.body, (motion.body, motion.frame))
    names = {"point": case.naming.point(motion.point), "centre": case.naming.point(term.point)}
    return compare(
        Message("solution.seen-from-frame", **names, body=body, frame=seen_from),
        left,
        Side(add_numbers(every), followed, add_letters(every)),
        "m/s",
        form=subtract(subtract(moved, multiply_chain((term,), by.vector)), seen),
    )
