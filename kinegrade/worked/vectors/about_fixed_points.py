"""The velocity or acceleration of a point from its distance to a fixed point: an axis, the contact
of a body that rolls, or the centre of a circle.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace
from typing import Literal, assert_never

from kinegrade.language.message import Message, Text
from kinegrade.mechanics.laws import SharedPoint
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import enters_composition, needs_components
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, TWO, ZERO, VectorSymbol
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.senses import state_way_about
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.carried import state_carried_component
from kinegrade.worked.vectors.vectors import name_point_vector

_Place = Literal["of", "at"]  # a point of the body that turns, or one at the same place
_Start = Literal["point", "base"]  # from a fixed axis, or from a moving base point


def explain_about_contact(
    term: Term, name: VectorSymbol, case: Case
) -> Generator[Block, None, Fact]:
    """The velocity of a point of a body that rolls on the ground: none in the contact, elsewhere
    its distance to that times the rotation, or both components where they are needed.
    """
    value = term.velocity(case.motion.rates)
    names: dict[str, Text] = {
        "body": case.naming.body(term.rate.body),
        "point": case.naming.point(term.point),
    }
    if term.point == term.base:
        yield case.say(Message("solution.contact-rests", **names))
        yield case.show(Equation(name, equate(ZERO)))
        return Fact(name, value, False)
    pole = case.naming.point(term.base)
    yield case.say(Message("solution.known-contact", pole=pole, **names))
    whole = needs_components(term.point, case, "velocity")
    if not whole and not enters_composition(term.point, case):
        yield case.show(*_state_speed(term, name, case))
        return Fact(name, value, False, (Piece(name, value, value, term),))
    yield case.show(*state_components(term, name, None, case, "velocity"))
    return Fact(name, value, True)


def find_single_sense(term: Term, value: Vector) -> Vector:
    """The direction in which the speed of a single term counts positive."""
    match term.kind:
        case "rotation":
            return value
        case "sliding" | "arc":
            return term.coefficient()
        case _:
            assert_never(term.kind)


def explain_single(term: Term, name: VectorSymbol, case: Case) -> Iterator[Block]:
    """The velocity of a point that turns about a fixed axis; nothing for a guided point, whose
    speed has been given.
    """
    if term.kind != "rotation":
        return
    yield case.say(announce_rotation(term, "point", case))
    yield case.show(*_state_speed(term, name, case))


def _state_speed(term: Term, name: VectorSymbol, case: Case) -> Iterator[Equation]:
    """The arm where it has to be worked out, and the speed of a point at it."""
    value = term.velocity(case.motion.rates)
    omega, rate = case.naming.omega(term.rate.body), case.motion.rates[term.rate]
    turned = omega if double(rate) >= 0 else abs(omega)
    ends = term.base, term.point
    yield from introduce_lengths((ends,), case)
    size = state_number(length(value, case.arithmetic), "m/s")
    arm = measure(length(term.vector, case.arithmetic), "m")
    numbers = arm.dot(measure(abs(rate), "rad/s"))
    links = (*equate(name_length(*ends, case).dot(turned), numbers), *size)
    yield Equation(name, links, state_way_about(value, term.vector, term.base, case))


def announce_rotation(term: Term, start: _Start, case: Case) -> Message:
    """About which point of its body a point turns."""
    return Message(
        f"solution.known-{start}-{find_place(term, case)}",
        point=case.naming.point(term.point),
        base=case.naming.point(term.base),
        body=case.naming.body(term.rate.body),
    )


def find_place(term: Term, case: Case) -> _Place:
    """Whether a point is one of the body that turns, or is only at the same place, as a contact is
    where it is a point of each of two bodies.
    """
    mechanism, body = case.motion.frames.mechanism, term.rate.body
    owners = tuple(other.name for other in mechanism.bodies if term.point in other.points)
    alone = len(owners) == 1 or mechanism.holds(SharedPoint(term.point, owners))
    return "of" if body in owners and alone else "at"


def explain_circling(term: Term, name: VectorSymbol, case: Case) -> Generator[Block, None, Fact]:
    """The acceleration of a point on a fixed circle: the normal part from its speed, the tangential
    part as given.
    """
    point, centre = case.naming.point(term.point), case.naming.point(term.base)
    yield case.say(Message("solution.known-circle", point=point, centre=centre))
    normal = term.normal(case.motion.rates)
    tangential = term.coefficient() * case.motion.changes[term.rate]
    speed = measure(length(term.velocity(case.motion.rates), case.arithmetic), "m/s")
    radius = measure(length(term.vector, case.arithmetic), "m")
    arm = name_length(term.base, term.point, case)
    symbols = name_point_vector(term.point, "velocity", case) ** TWO / arm
    first, second = replace(name, part="n"), replace(name, part="t")
    links = equate(symbols, speed**TWO / radius)
    size = state_number(length(normal, case.arithmetic), "m/s^2")
    arms = introduce_lengths(((term.base, term.point),), case)
    yield case.show(*arms, Equation(first, (*links, *size)))
    along = term.coefficient()
    pieces = Piece(first, normal, normal, term), Piece(second, along, tangential, term)
    return Fact(name, normal + tangential, False, pieces)


def state_components(
    term: Term,
    name: VectorSymbol,
    base: tuple[VectorSymbol, Vector] | None,
    case: Case,
    level: Level,
) -> Iterator[Equation]:
    """Both components of a vector from those of its base point, which is None where it rests."""
    for axis in AXES:
        yield state_carried_component(axis, name, base, term, case=case, level=level)
