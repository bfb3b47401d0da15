"""The motion of a point carried by a body that turns: by its components from the vector of a base
point, along x and y or along the arm and across it, or by its normal and tangential parts about a
fixed axis.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace
from itertools import product
from typing import Any

from kinegrade.language.math.tree import Row, Sign
from kinegrade.language.message import Message
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.asked_senses import find_asked_turn, orient_arm
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import needs_components
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import TWO, ZERO, VectorSymbol, add_terms
from kinegrade.worked.formulas.equation import Equation, equate, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, double, is_zero, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.senses import state_sense_along, state_way_about
from kinegrade.worked.vectors.angle_sums import is_told
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.by_components import project_components
from kinegrade.worked.vectors.components import (
    find_heading,
    find_known,
    list_component,
    list_turning_summands,
)
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.directions import is_inclination_known, name_along
from kinegrade.worked.vectors.slopes.inclination import Inclination
from kinegrade.worked.vectors.summands import PLACES, add_summands, name_component
from kinegrade.worked.vectors.vectors import UNITS


def state_carried_component(
    axis: AxisName,
    name: VectorSymbol,
    base: tuple[VectorSymbol, Vector] | None,
    term: Term,
    *,
    case: Case,
    level: Level,
) -> Equation:
    """v_Ax - omega (y_P - y_A), or a_Ax - alpha (y_P - y_A) - omega^2 (x_P - x_A), with numbers and
    value.

    `base` is the vector of the base point with its symbol, None where it is fixed. Terms of a
    rotation that is zero are left out.
    """
    place = PLACES[axis]
    summands = list(list_turning_summands(axis, term, case, level))
    value = find_term_value(term, case.motion, level)[place]
    if base is not None:
        symbol, vector = base
        summands = [*list_component(find_known(symbol, vector, case), axis, case), *summands]
        value = vector[place] + value
    return add_summands(name_component(name, axis), summands, value, level)


def explain_turning(
    term: Term, name: VectorSymbol, announced: Message, case: Case
) -> Generator[Block, None, Fact]:
    """Both parts, as far as they are not zero, and the arm where it has to be worked out, after the
    sentence that announces them and says why one of them is missing.
    """
    yield case.say(_name_missing(term, announced, case))
    arms = introduce_lengths(((term.base, term.point),), case)
    yield case.show(*arms, *_state_parts(term, name, case))
    normal, tangential = _find_parts(term, name, case)
    return Fact(name, normal.value + tangential.value, False, (normal, tangential))


def mark_parts(said: Message, case: Case) -> Message:
    """A sentence that leads to normal and tangential parts, after what their indices mark where
    that has not been said.
    """
    if case.findings.parts_explained:
        return said
    case.findings.parts_explained = True
    return Message("solution.sentences", first=Message("solution.normal-and-tangential"), next=said)


def _name_missing(term: Term, announced: Message, case: Case) -> Message:
    """The sentence after the reason why one of the parts is missing, where the other is not."""
    omega, alpha = case.naming.omega(term.rate.body), case.naming.alpha(term.rate.body)
    point = case.naming.point(term.point)
    turns, changes = (
        double(values[term.rate]) for values in (case.motion.rates, case.motion.changes)
    )
    if turns and not changes:
        zero = case.tell(Equation(alpha, equate(ZERO)))
        first = Message("solution.no-tangential-part", zero=zero, point=point)
    elif changes and not turns:
        zero = case.tell(Equation(omega, equate(ZERO)))
        first = Message("solution.no-normal-part", zero=zero, point=point)
    else:
        return mark_parts(announced, case)
    return Message("solution.sentences", first=first, next=announced)


def _find_parts(term: Term, name: VectorSymbol, case: Case) -> tuple[Piece, Piece]:
    """The normal and the tangential part, each positive in its own direction, or the latter in the
    sense of a question.
    """
    normal = term.normal(case.motion.rates)
    tangential = term.coefficient() * case.motion.changes[term.rate]
    turn = None if is_zero(tangential) else find_asked_turn(term, "acceleration", case)
    positive = tangential if turn is None else term.vector.turned() * turn
    return (
        Piece(replace(name, part="n"), normal, normal, term),
        Piece(replace(name, part="t"), positive, tangential, term),
    )


def _state_parts(term: Term, name: VectorSymbol, case: Case) -> Iterator[Equation]:
    """a^n = r omega^2, a^t = r alpha, with their directions."""
    normal, tangential = _find_parts(term, name, case)
    body, alpha = term.rate.body, case.motion.changes[term.rate]
    if not is_zero(normal.value):
        factors = case.naming.omega(body), measure(case.motion.rates[term.rate], "rad/s")
        sense = state_sense_along(1.0, normal.value, (term.point, term.base), case)
        yield _state_part(normal, term, factors[0] ** TWO, factors[1] ** TWO, sense, case=case)
    if not is_zero(tangential.value):
        turn = find_asked_turn(term, "acceleration", case)
        letter = case.naming.alpha(body)
        size = letter if double(alpha) > 0 else abs(letter)
        symbol = size if turn is None else letter.signed(turn)
        sense = state_way_about(tangential.value, term.vector, term.base, case)
        number = measure(abs(alpha) if turn is None else alpha * turn, "rad/s^2")
        yield _state_part(tangential, term, symbol, number, sense, case=case)


def _state_part(
    piece: Piece, term: Term, symbol: Formula, number: Formula, sense: Row, *, case: Case
) -> Equation:
    """The arm times a factor, in symbols and in numbers, and the value."""
    arm = measure(length(term.vector, case.arithmetic), "m")
    symbols = name_length(term.base, term.point, case).dot(symbol)
    value = state_number(_measure_piece(piece, case), piece.symbol.unit)
    return Equation(piece.symbol, (*equate(symbols, arm.dot(number)), *value), sense)


def find_arm(term: Term, base: Fact, case: Case, level: Level) -> Inclination | None:
    """The direction of a point's arm by an angle that is known, from the base point for velocities
    and to it for accelerations: along it and across it the point's vector has its shortest
    components. None where an answer needs those along x and y, or the arm lies along one of these.
    """
    if base.by_components or needs_components(term.point, case, level):
        return None
    if None in [find_heading(piece, case) for piece in base.parts]:
        return None
    ends = (term.base, term.point)
    found = name_along(bearing(_direct_arm(term, level, case)), ends, case)
    if found is None or found.angle is None or not is_inclination_known(found, ends, case):
        return None
    headings = filter(None, (find_heading(piece, case) for piece in base.parts))
    cosines = (find_cosine(*pair) for pair in product(headings, _list_axes(found)))
    return found if all(is_told(one, case) for one in cosines if one is not None) else None


def _list_axes(arm: Inclination) -> tuple[Inclination, Inclination]:
    """Along the arm, and across it, turned to the left."""
    return arm, replace(arm, quarters=arm.quarters + 1)


def _direct_arm(term: Term, level: Level, case: Case) -> Vector:
    """The arm from the base point, or to it."""
    start, _ = orient_arm(term, level, case)
    return term.vector if start == term.base else -term.vector


def explain_along_arm(
    term: Term, name: VectorSymbol, base: Fact, arm: Inclination, *, case: Case, level: Level
) -> Generator[Block, None, Fact]:
    """The components along the arm and across it, the arm turned to the left: those of the base
    point's vector with what the rotation adds.
    """
    along, across = _find_pieces(term, name, base, case, level)
    axes = _list_axes(arm)
    lines = introduce_lengths(((term.base, term.point),), case)
    first = _state_piece(along, base, axes[0], term, case=case, level=level)
    second = _state_piece(across, base, axes[1], term, case=case, level=level)
    yield case.show(*lines, first, second)
    return Fact(name, along.value + across.value, False, (along, across))


def _find_pieces(
    term: Term, name: VectorSymbol, base: Fact, case: Case, level: Level
) -> tuple[Piece, Piece]:
    """Both components with their letters and directions."""
    arm = _direct_arm(term, level, case)
    total = base.value + find_term_value(term, case.motion, level)
    along = arm * (total.dot(arm) / arm.squared())
    line = join_letters(map(case.naming.letter, orient_arm(term, level, case))).row
    first, second = (
        replace(name, lower=(*name.lower, Sign(","), *sign, *line))
        for sign in ((), (Sign(r"\perp"),))
    )
    return Piece(first, arm, along, term), Piece(second, arm.turned(), total - along, term)


def _state_piece(
    piece: Piece, base: Fact, axis: Inclination, term: Term, *, case: Case, level: Level
) -> Equation:
    """A component in symbols, in numbers, and its value."""
    shown = [one for one in base.parts if not is_zero(one.value)]
    symbols, numbers = (
        list(project_components(shown, axis, case, in_numbers=in_numbers))
        for in_numbers in (False, True)
    )
    for sign, symbol, number in _list_factors(piece, term, case, level):
        arm = measure(length(term.vector, case.arithmetic), "m")
        symbols.append(name_length(term.base, term.point, case).dot(symbol).signed(sign))
        numbers.append(arm.dot(number).signed(sign))
    value = state_number(_measure_piece(piece, case), piece.symbol.unit)
    working = (add_terms(symbols), add_terms(numbers))
    return Equation(piece.symbol, lead_to(piece.symbol, working, value))


def _measure_piece(piece: Piece, case: Case) -> Any:
    """The signed number of a component."""
    size = length(piece.value, case.arithmetic)
    return -size if double(piece.value.dot(piece.positive)) < 0 else size


def _list_factors(
    piece: Piece, term: Term, case: Case, level: Level
) -> Iterator[tuple[int, Formula, Formula]]:
    """By what the arm is multiplied, with its sign: omega across it, omega^2 towards the base
    point, alpha across it.
    """
    body, turned = term.rate.body, double(piece.positive.dot(term.vector.turned()))
    rate, value = case.motion.rates[term.rate], case.rates(level)[term.rate]
    if turned and double(value):
        letters = case.naming.turning(body, level)
        yield (1 if turned > 0 else -1), letters, measure(value, UNITS[level, True])
    elif not turned and level == "acceleration" and double(rate):
        yield 1, case.naming.omega(body) ** TWO, measure(rate, "rad/s") ** TWO
