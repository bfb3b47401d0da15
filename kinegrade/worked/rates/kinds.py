"""The first chapter of a solution: how each body moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from typing import assert_never

from kinegrade.language.math.tree import Node, Row
from kinegrade.language.message import Message, list_all, list_plainly, list_statements
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rolling
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.problem.template.hints import ROPES
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import find_contact
from kinegrade.worked.document import Block, Heading
from kinegrade.worked.positions.parts import find_symbols, is_met
from kinegrade.worked.rates.sliders import describe_sliders


def describe_motions(case: Case, later: Iterable[Row], steps: Iterable[Step]) -> Iterator[Block]:
    """Under its title, a sentence that says how each body and slider moves, with the letter of its
    angular velocity where a formula `later` refers to it or to its change, and that of this; that
    it rolls where that is used, in one of the steps or because its point of contact is its pole.
    """
    mechanism, met = case.motion.frames.mechanism, find_symbols(later)
    used = frozenset(index for step in steps for index in step.relations)
    bodies = [body for body in mechanism.bodies if not body.particle]
    if bodies:
        told = (_describe_motion(body, mechanism, met, used, case) for body in bodies)
        motions = (*told, *describe_sliders(case))
        yield Heading(case.write(Message("solution.kinds")), 1)
        yield case.say(Message("solution.motion-list-closed", motions=list_statements(motions)))


def _describe_motion(
    body: Body, mechanism: Mechanism, met: Set[Node], used: Set[int], case: Case
) -> Message:
    """How one body moves, with the letters of its rotation that are used."""
    name = case.naming.body(body.name)
    if body.name in mechanism.resting:
        return Message("solution.rests", body=name)
    if body.name in case.translating:
        shape = case.template.figure.shapes.get(body.name)
        if shape in ROPES:  # the rest may be wound up
            return Message(f"solution.translates-{shape}", body=name)
        return Message("solution.translates", body=name)
    letters = case.naming.omega(body.name), case.naming.alpha(body.name)
    if any(is_met(letter, met) for letter in letters):
        told = [letters[0], *(one for one in letters[1:] if is_met(one, met))]
        listed = list_plainly(f"${case.text(letter)}$" for letter in told)
        name = Message("solution.turning-body", body=name, letters=listed)
    pivot = find_fixed_axis(body, case)
    if pivot is not None:
        return Message("solution.rotates", body=name, point=case.naming.point(pivot))
    return _describe_rolls(name, tuple(_list_rolls(body, used, case)), case)


def _describe_rolls(name: Message, rolls: Iterable[NoSlip], case: Case) -> Message:
    """The plane motion of a body, and on what it rolls; a cord that it winds up is no track."""
    tracks, cords = dict[Message, None](), dict[Message, None]()
    for roll in rolls:
        (cords if is_cord(roll, case) else tracks)[describe_track(roll, case)] = None
    if tracks and cords:
        on, along = list_all(tracks), list_all(cords)
        return Message("solution.rolls-and-winds", body=name, other=on, cords=along)
    if cords:
        return Message("solution.winds", body=name, cords=list_all(cords))
    if tracks:
        return Message("solution.rolls", body=name, other=list_all(tracks))
    return Message("solution.plane", body=name)


def is_cord(roll: NoSlip, case: Case) -> bool:
    """Whether a body touches a rope or cord, which is wound on it, rather than a track."""
    return case.template.figure.shapes.get(roll.of) in ROPES


def _list_rolls(body: Body, used: Set[int], case: Case) -> Iterator[NoSlip]:
    """How a body rolls, as far as the solution uses it."""
    on_ground = find_contact(body.name, case) is not None
    for index, relation in enumerate(case.motion.frames.relations):
        roll = find_rolling(relation.source)
        if roll and roll.body == body.name and (index in used or on_ground):
            yield roll


def find_fixed_axis(body: Body, case: Case) -> str | None:
    """The point through which the fixed axis of a body goes; None where it has none."""
    pivots = case.motion.frames.mechanism.find_pivots()
    return pivots.get(body.name) or _find_common_centre(body, case)


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
