"""Bodies that roll on the ground turn about the point of contact, their velocity pole."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import assert_never

from kinegrade.expressions.tree import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    find_names,
    list_parts,
)
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, list_block_formulas
from kinegrade.worked.formulas.measures import is_zero
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.positions.parts import find_symbols, is_met


def turn_about_contact(term: Term, case: Case) -> Term | None:
    """The rotation of a point about the contact in place of its base point: the point's whole
    velocity. None for a body that does not roll on the ground in a named point.
    """
    contact = find_contact(term.rate.body, case) if term.kind == "rotation" else None
    if contact is None:
        return None
    points = case.motion.points
    return replace(term, base=contact, vector=points[term.point] - points[contact])


def find_contact(body: str, case: Case) -> str | None:
    """The named point in which a body rolls on the ground; None where it does not, or the point has
    no name.
    """
    rolls = (find_rolling(relation.source) for relation in case.motion.frames.relations)
    if not any(roll.body == body and roll.of == GROUND for roll in rolls if roll is not None):
        return None
    if case.arithmetic.is_zero(case.motion.omega(body)):
        return None
    pole = case.motion.pole(body, case.arithmetic)
    points = case.motion.points
    return next(
        (name for name in case.template.scheme.points if is_zero(points[name] - pole)), None
    )


def needs_components(point: str, case: Case, level: Level) -> bool:
    """Whether an answer needs more of a point's velocity, or acceleration, than its magnitude or
    what it has along a line through the point or across it.
    """
    asks = (case.template.asks[name].quantity for name in case.solution.answers)
    return any(_uses_components(ask, point, level) for ask in asks)


def _uses_components(tree: Expression, point: str, level: Level) -> bool:
    """Whether an expression holds the vector of a point other than so."""
    match tree:
        case Call(function="magnitude", arguments=(Call(function=inner),)) if _is_point(inner):
            return False
        case Call(function="along", arguments=(Call(function=inner), direction)) if _is_point(
            inner
        ) and point in find_names(direction):
            return False
        case Call(function=name, arguments=(Name(named), *_)) if name in MOTION_FUNCTIONS:
            return named == point and _is_point(name) and MOTION_FUNCTIONS[name].level == level
        case Call() | Operation() | Number() | Name():
            return any(_uses_components(part, point, level) for part in list_parts(tree))
        case _:
            assert_never(tree)


def enters_composition(point: str, case: Case) -> bool:
    """Whether an answer is about the motion of a point relative to a moving body."""
    calls = (
        call
        for name in case.solution.answers
        for call in find_motion_calls(case.template.asks[name].quantity)
    )
    return any(
        MOTION_FUNCTIONS[call.function].derivation in ("relative", "coriolis")
        and call.arguments[0] == Name(point)
        for call in calls
    )


def _is_point(function: str) -> bool:
    """Whether a function gives the velocity or acceleration of a point."""
    return function in MOTION_FUNCTIONS and MOTION_FUNCTIONS[function].derivation == "point"


def introduce_contacts(
    case: Case, used: Collection[str], later: Sequence[Block]
) -> Iterator[Block]:
    """Where bodies roll in points that the figure does not show and that `later` blocks name."""
    bodies = case.motion.frames.mechanism.bodies
    shown = {point for body in bodies for point in body.points} | {*case.template.figure.labels}
    for body in bodies:
        point = find_contact(body.name, case)
        if point is None or point in shown or point not in used:
            continue
        name, letter = case.naming.body(body.name), case.naming.point(point)
        written = chain.from_iterable(map(list_block_formulas, later))
        if is_met(read_symbol(letter), find_symbols(written)):
            yield case.say(Message("solution.unmarked-contact", body=name, point=letter))
