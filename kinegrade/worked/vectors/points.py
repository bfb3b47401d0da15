"""The velocity or acceleration of a point of a body whose motion is known: from its distance to a
fixed axis, or from its base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.asked_senses import orient_arm
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import enters_composition, turn_about_contact
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, VectorSymbol
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.senses import state_way
from kinegrade.worked.translations import say_translation
from kinegrade.worked.vectors.about_fixed_points import (
    announce_rotation,
    explain_about_contact,
    explain_circling,
    explain_single,
    find_place,
    find_single_sense,
    state_components,
)
from kinegrade.worked.vectors.carried import explain_along_arm, explain_turning, find_arm
from kinegrade.worked.vectors.components import add_components, find_known
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.relative_parts import list_relative_parts
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.vectors import name_by_role, name_point_vector


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
        yield from explain_single(last, name, case)
        fact = Fact(name, value, False, (Piece(name, find_single_sense(last, value), value, last),))
    elif len(chain) == 1 and last.kind == "arc":
        fact = yield from explain_circling(last, name, case)
    elif len(chain) == 1 and last.kind == "rotation":
        fact = yield from explain_turning(last, name, announce_rotation(last, "point", case), case)
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
    return (yield from explain_about_contact(about, name, case))


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
    yield case.say(announce_rotation(last, "base" if before else "point", case))
    base = (base_name, carried) if before else None
    yield case.show(*state_components(last, name, base, case, level))
    return Fact(name, find_vector(chain, case.motion, level), True)


def _find_base(chain: Chain, case: Case, level: Level) -> Fact:
    """What has been found of the vector of the base point of a chain's last rotation."""
    symbol = name_point_vector(chain[-1].base, level, case)
    return find_known(symbol, find_vector(chain[:-1], case.motion, level), case)


def _announce_arm(term: Term, case: Case, level: Level) -> Message:
    """From which base point, and along which line and across it the components are taken."""
    ends = orient_arm(term, level, case)
    return Message(
        f"solution.along-arm-{find_place(term, case)}",
        point=case.naming.point(term.point),
        base=case.naming.point(term.base),
        body=case.naming.body(term.rate.body),
        line=case.text(join_letters(map(case.naming.letter, ends))),
    )


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
