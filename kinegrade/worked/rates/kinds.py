"""The first chapter of a solution: how each body moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from typing import assert_never

from kinegrade.language.math.tree import Node, Row
from kinegrade.language.message import Message, list_all, list_statements
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.positions.parts import find_symbols, is_met


def describe_motions(case: Case, later: Iterable[Row]) -> Iterator[Block]:
    """A sentence that says how each body moves, with the letter of its angular velocity where a
    formula `later` refers to it or to its change.
    """
    mechanism, met = case.motion.frames.mechanism, find_symbols(later)
    motions = (_describe_motion(body, mechanism, met, case) for body in mechanism.bodies)
    yield case.say(Message("solution.motion-list-closed", motions=list_statements(motions)))


def _describe_motion(body: Body, mechanism: Mechanism, met: Set[Node], case: Case) -> Message:
    """How one body moves, with the letter of its angular velocity where that is used."""
    if body.particle:
        return Message("solution.particle", point=case.naming.point(body.name))
    name = case.naming.body(body.name)
    if body.name in mechanism.resting:
        return Message("solution.rests", body=name)
    if body.name in case.translating:
        return Message("solution.translates", body=name)
    letters = case.naming.omega(body.name), case.naming.alpha(body.name)
    if any(is_met(letter, met) for letter in letters):
        name = Message("solution.turning-body", body=name, omega=case.text(letters[0]))
    pivot = mechanism.find_pivots().get(body.name) or _find_common_centre(body, case)
    if pivot is not None:
        return Message("solution.rotates", body=name, point=case.naming.point(pivot))
    laws = (relation.source for relation in case.motion.frames.relations)
    rolls = (law.find_rolling() for law in laws if law)
    own = (roll for roll in rolls if roll and roll.body == body.name)
    tracks = dict.fromkeys(describe_track(roll, case) for roll in own)
    if tracks:
        return Message("solution.rolls", body=name, other=list_all(tracks))
    return Message("solution.plane", body=name)


def _find_common_centre(body: Body, case: Case) -> str | None:
    """The fixed centre of the circles on which two points of a body move; None where they have
    none in common.
    """
    for relation in case.motion.frames.relations:
        terms = (*relation.left, *relation.right)
        centres = [term.base for term in terms if term.kind == "arc" and term.frame == GROUND]
        turning = [term.rate.body for term in terms if term.kind == "rotation"]
        if turning == [body.name] and len(centres) == 2 and len({*centres}) == 1:
            return centres[0]
    return None


def describe_track(roll: NoSlip, case: Case) -> Message:
    """What a body rolls on, in prose."""
    if roll.of != GROUND:
        return case.naming.body(roll.of)
    match roll.on:
        case Line():
            return Message("solution.fixed-line")
        case Circle():
            return Message("solution.fixed-circle")
        case _:
            assert_never(roll.on)
