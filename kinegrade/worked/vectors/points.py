"""The velocity or acceleration of a point of a body whose motion is known: from its distance to a
fixed axis, or from its base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace
from typing import Literal, assert_never

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message, Text
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import SharedPoint
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level, Part, find_term_value, list_term_parts
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import enters_composition, needs_components, turn_about_contact
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, TWO, ZERO, VectorSymbol
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.senses import state_way, state_way_about
from kinegrade.worked.translations import say_translation
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.carried import (
    explain_along_arm,
    explain_turning,
    find_arm,
    state_carried_component,
)
from kinegrade.worked.vectors.components import add_components, find_known
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.vectors import (
    name_by_role,
    name_coriolis,
    name_point_vector,
)

_Place = Literal["of", "at"]  # a point of the body that turns, or one at the same place
_Start = Literal["point", "base"]  # from a fixed axis, or from a moving base point


def find_vector(chain: Chain, motion: Motion, level: Level) -> Vector:
    """The vector of a chain."""
    return add_vectors(find_term_value(term, motion, level) for term in chain)


def find_point(chain: Chain, name: VectorSymbol, case: Case, level: Level) -> Iterator[Block]:
    """How the vector of a chain is found, if that has not been written yet; `name` is its
    symbol.
    """
    if make_key(chain, level) in case.findings.facts or not chain:
        return
    last, value = chain[-1], find_vector(chain, case.motion, level)
    if all(term.kind == "sliding" and term.frame == GROUND for term in chain):
        sense = find_positive_sense(last, case, level)
        pieces = (Piece(name, sense, value, last),) if len(chain) == 1 else ()
        fact = Fact(name, value, len(chain) > 1, pieces)
    elif level == "velocity" and (about := turn_about_contact(last, case)):
        fact = yield from _explain_rolling(chain, about, name, case)
    elif len(chain) == 1 and level == "velocity":
        yield from _explain_single(last, name, case)
        fact = Fact(
            name, value, False, (Piece(name, _find_single_sense(last, value), value, last),)
        )
    elif len(chain) == 1 and last.kind == "arc":
        fact = yield from _explain_circling(last, name, case)
    elif len(chain) == 1 and last.kind == "rotation":
        fact = yield from explain_turning(last, name, _announce_rotation(last, "point", case), case)
    else:
        fact = yield from _explain_sum(chain, name, case, level)
    case.findings.facts[make_key(chain, level)] = fact


def _explain_rolling(
    chain: Chain, about: Term, name: VectorSymbol, case: Case
) -> Generator[Block, None, Fact]:
    """The velocity of a point of a body that rolls: about the contact, or from the base point where
    its motion is composed and the direction of its arm is known.
    """
    last, before = chain[-1], chain[:-1]
    if enters_composition(last.point, case) and last.point != about.base:
        base = name_point_vector(last.base, "velocity", case)
        yield from find_point(before, base, case, "velocity")
        if find_arm(last, _find_base(chain, case, "velocity"), case, "velocity"):
            return (yield from _explain_carried(chain, name, case, "velocity"))
    return (yield from _explain_about_contact(about, name, case))


def _explain_about_contact(
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
    yield case.show(*_state_components(term, name, None, case, "velocity"))
    return Fact(name, value, True)


def _find_single_sense(term: Term, value: Vector) -> Vector:
    """The direction in which the speed of a single term counts positive."""
    match term.kind:
        case "rotation":
            return value
        case "sliding" | "arc":
            return term.coefficient()
        case _:
            assert_never(term.kind)


def _explain_sum(
    chain: Chain, name: VectorSymbol, case: Case, level: Level
) -> Generator[Block, None, Fact]:
    """A point's vector: its last term added to the terms before, by components; that of its base
    point where the body translates.
    """
    last, value = chain[-1], find_vector(chain, case.motion, level)
    match last.kind:
        case "rotation":
            if last.rate in case.held_rates:
                base = name_point_vector(last.base, level, case)
                yield from find_point(chain[:-1], base, case, level)
                carried = find_known(base, value, case)
                if len(carried.pieces) == 1:
                    return (yield from _explain_shifted(carried.pieces[0], name, last, case, level))
            return (yield from _explain_carried(chain, name, case, level))
        case "sliding" | "arc":
            yield from _explain_composed(chain, name, case, level)
        case _:
            assert_never(last.kind)
    return Fact(name, value, True)


def _explain_shifted(
    carried: Piece, name: VectorSymbol, term: Term, case: Case, level: Level
) -> Generator[Block, None, Fact]:
    """The vector of a point of a body that translates: that of its base point."""
    yield from say_translation(term.rate.body, level, case)
    size = length(carried.value, case.arithmetic)
    against = double(carried.value.dot(carried.positive)) < 0
    number = state_number(-size if against else size, name.unit)
    links = (*equate(carried.symbol), number[-1])
    yield case.show(Equation(name, links, state_way(carried.value, case)))
    return Fact(name, carried.value, False, (replace(carried, symbol=name),))


def _explain_single(term: Term, name: VectorSymbol, case: Case) -> Iterator[Block]:
    """The velocity of a point that turns about a fixed axis; nothing for a guided point, whose
    speed has been given.
    """
    if term.kind != "rotation":
        return
    yield case.say(_announce_rotation(term, "point", case))
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


def _announce_rotation(term: Term, start: _Start, case: Case) -> Message:
    """About which point of its body a point turns."""
    return Message(
        f"solution.known-{start}-{_find_place(term, case)}",
        point=case.naming.point(term.point),
        base=case.naming.point(term.base),
        body=case.naming.body(term.rate.body),
    )


def _find_place(term: Term, case: Case) -> _Place:
    """Whether a point is one of the body that turns, or is only at the same place, as a contact is
    where it is a point of each of two bodies.
    """
    mechanism, body = case.motion.frames.mechanism, term.rate.body
    owners = tuple(other.name for other in mechanism.bodies if term.point in other.points)
    alone = len(owners) == 1 or mechanism.holds(SharedPoint(term.point, owners))
    return "of" if body in owners and alone else "at"


def _explain_circling(term: Term, name: VectorSymbol, case: Case) -> Generator[Block, None, Fact]:
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


def _explain_carried(
    chain: Chain, name: VectorSymbol, case: Case, level: Level
) -> Generator[Block, None, Fact]:
    """A point's vector from its base point: by components along its arm and across it where their
    directions are known, else along the axes.
    """
    last, before = chain[-1], chain[:-1]
    base_name, carried = (
        name_point_vector(last.base, level, case),
        find_vector(before, case.motion, level),
    )
    yield from find_point(before, base_name, case, level)
    fact = _find_base(chain, case, level)
    arm = find_arm(last, fact, case, level) if before else None
    if arm is not None:
        yield case.say(_announce_arm(last, case, level))
        return (yield from explain_along_arm(last, name, fact, arm, case=case, level=level))
    yield case.say(_announce_rotation(last, "base" if before else "point", case))
    base = (base_name, carried) if before else None
    yield case.show(*_state_components(last, name, base, case, level))
    return Fact(name, find_vector(chain, case.motion, level), True)


def _find_base(chain: Chain, case: Case, level: Level) -> Fact:
    """What has been found of the vector of the base point of a chain's last rotation."""
    symbol = name_point_vector(chain[-1].base, level, case)
    return find_known(symbol, find_vector(chain[:-1], case.motion, level), case)


def _announce_arm(term: Term, case: Case, level: Level) -> Message:
    """From which base point, and along which line and across it the components are taken."""
    ends = {"velocity": (term.base, term.point), "acceleration": (term.point, term.base)}[level]
    return Message(
        f"solution.along-arm-{_find_place(term, case)}",
        point=case.naming.point(term.point),
        base=case.naming.point(term.base),
        body=case.naming.body(term.rate.body),
        line=case.text(join_letters(map(case.naming.letter, ends))),
    )


def _state_components(
    term: Term,
    name: VectorSymbol,
    base: tuple[VectorSymbol, Vector] | None,
    case: Case,
    level: Level,
) -> Iterator[Equation]:
    """Both components of a vector from those of its base point, which is None where it rests."""
    for axis in AXES:
        yield state_carried_component(axis, name, base, term, case=case, level=level)


def _explain_composed(
    chain: Chain, name: VectorSymbol, case: Case, level: Level
) -> Iterator[Block]:
    """The components of a point that moves within a moving body: transport, relative and Coriolis
    parts added.
    """
    last, before = chain[-1], chain[:-1]
    number = index_relative(find_relative(last), case)
    transport = name_by_role("e", level, number)
    yield from find_point(before, transport, case, level)
    yield case.say(
        Message(
            "solution.known-relative",
            point=case.naming.point(last.point),
            frame=case.naming.body(last.frame),
        )
    )
    carried = find_known(transport, find_vector(before, case.motion, level), case)
    parts = [carried, *list_relative_parts(last, case, level)]
    yield case.show(*(add_components(axis, name, parts, case) for axis in AXES))


def list_relative_parts(term: Term, case: Case, level: Level) -> Iterator[Fact]:
    """The relative and Coriolis parts of a term, each by its magnitude and direction."""
    number = index_relative(find_relative(term), case)
    for part in list_term_parts(term, case.motion, tuple(case.motion.rates), level):
        name = _name_relative_part(part, level, number, case)
        fixed = part.role == "coriolis" or part.part == "n"
        sense = part.value if fixed else term.coefficient()
        yield Fact(name, part.value, False, (Piece(name, sense, part.value, term),))


def _name_relative_part(part: Part, level: Level, number: Row, case: Case) -> VectorSymbol:
    """The symbol of a relative or Coriolis part."""
    match part.role:
        case "coriolis":
            return name_coriolis(number)
        case "relative" | "absolute" | "transport" | "rotation":
            return replace(name_by_role("r", level, number), part=part.part)
        case _:
            assert_never(part.role)
