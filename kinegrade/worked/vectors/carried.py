"""The motion of a point carried by a body that turns: by its components from those of a base point,
or by its normal and tangential parts about a fixed axis.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace

from kinegrade.language.math.tree import Row
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import TWO, AxisName, VectorSymbol
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, is_zero, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.senses import state_sense_along, state_way_about
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.components import find_known, list_component, list_turning_summands
from kinegrade.worked.vectors.summands import PLACES, add_summands, name_component


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


def explain_turning(term: Term, name: VectorSymbol, case: Case) -> Generator[Block, None, Fact]:
    """Both parts, as far as they are not zero, and the arm where it has to be worked out."""
    arms = introduce_lengths(((term.base, term.point),), case)
    yield case.show(*arms, *_state_parts(term, name, case))
    normal, tangential = _find_parts(term, name, case)
    return Fact(name, normal.value + tangential.value, False, (normal, tangential))


def _find_parts(term: Term, name: VectorSymbol, case: Case) -> tuple[Piece, Piece]:
    """The normal and the tangential part, each positive in its own direction."""
    normal = term.normal(case.motion.rates)
    tangential = term.coefficient() * case.motion.changes[term.rate]
    return (
        Piece(replace(name, part="n"), normal, normal, term),
        Piece(replace(name, part="t"), tangential, tangential, term),
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
        letter = case.naming.alpha(body)
        symbol = letter if double(alpha) > 0 else abs(letter)
        sense = state_way_about(tangential.value, term.vector, term.base, case)
        number = measure(abs(alpha), "rad/s^2")
        yield _state_part(tangential, term, symbol, number, sense, case=case)


def _state_part(
    piece: Piece, term: Term, symbol: Formula, number: Formula, sense: Row, *, case: Case
) -> Equation:
    """The arm times a factor, in symbols and in numbers, and the value."""
    arm = measure(length(term.vector, case.arithmetic), "m")
    symbols = name_length(term.base, term.point, case).dot(symbol)
    value = state_number(length(piece.value, case.arithmetic), piece.symbol.unit)
    return Equation(piece.symbol, (*equate(symbols, arm.dot(number)), *value), sense)
