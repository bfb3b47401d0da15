"""The components of vectors along the axes: of a vector that has been found, by what is known of
it; of the rotation of a point about another; of sums.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Literal

from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import OTHER, TWO, VectorSymbol
from kinegrade.worked.formulas.atoms import ZERO as NOTHING
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, double, is_zero, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.axes import Axes, choose_axes
from kinegrade.worked.vectors.known_vectors import list_ways
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.directions import (
    find_term_ends,
    is_inclination_known,
    name_along,
)
from kinegrade.worked.vectors.slopes.inclination import Inclination, name_axis
from kinegrade.worked.vectors.summands import PLACES, Summand, add_summands, name_component
from kinegrade.worked.vectors.vectors import UNITS

_SIGNS: Mapping[int, Literal["+", "-"]] = {1: "+", -1: "-"}
_LEVELS: Mapping[Literal["v", "a"], Level] = {"v": "velocity", "a": "acceleration"}
_DIRECTIONS: Mapping[AxisName, float] = {"x": 0.0, "y": 90.0}


def find_known(symbol: VectorSymbol, value: Vector, case: Case) -> Fact:
    """What has been found of a vector; its components where nothing has."""
    found = (*case.findings.facts.values(), *case.findings.answered.values())
    unknown = Fact(symbol, value, True)
    same = (fact for fact in found if fact.symbol == symbol and is_zero(fact.value - value))
    return next(same, unknown)


def list_component(fact: Fact, axis: AxisName, case: Case) -> Iterator[Summand]:
    """The component of a vector: v_A sin(phi) of one that the solution knows by its magnitude, by
    the rotation where no angle is named, else v_Ax.
    """
    pieces = () if fact.by_components else fact.parts
    shares = [_project(piece, axis, case) for piece in pieces if not is_zero(piece.value)]
    turning = _find_rotation(pieces)
    if pieces and None not in shares:
        yield from (share for listed in shares if listed for share in listed)
    elif turning is not None:
        yield from list_turning_summands(axis, turning, case, _LEVELS[fact.symbol.letter])
    else:
        number = measure(fact.value[PLACES[axis]], fact.symbol.unit)
        yield Summand("+", name_component(fact.symbol, axis), (number,))


def _find_rotation(pieces: Sequence[Piece]) -> Term | None:
    """The rotation that all pieces are parts of, None where there is none."""
    terms = [piece.term for piece in pieces if piece.term is not None]
    alone = len(terms) == len(pieces) and len({list_ways((term,)) for term in terms}) == 1
    return terms[0] if alone and terms[0].kind == "rotation" else None


def _project(piece: Piece, axis: AxisName, case: Case) -> tuple[Summand, ...] | None:
    """The share of a piece in a component: none where it is normal to the axis, None where its
    direction has no named angle.
    """
    heading = find_heading(piece, case)
    along = name_axis(_DIRECTIONS[axis])
    if heading is None or along is None:
        return None
    cosine = find_cosine(heading, along)
    quarters = (heading.quarters - along.quarters) % 4
    if cosine is None and quarters % 2:
        return ()
    sign = 1 - quarters if cosine is None else cosine.sign
    letters = name_signed(piece, case)
    sign, size = sign * letters.sign, state_signed(piece, case, letters.sign)
    if cosine is None:
        return (Summand(_SIGNS[sign], letters.size, (size,)),)
    numbers = (size, cosine.state(True)) if double(piece.value[PLACES[axis]]) else (NOTHING,)
    return (Summand(_SIGNS[sign], letters.size * cosine.state(False), numbers),)


def name_signed(piece: Piece, case: Case) -> Formula:
    """The letter of a piece; where it points against its positive sense, and its magnitude alone
    has been found, less that magnitude.
    """
    against = double(piece.value.dot(piece.positive)) < 0
    sized = against and case.findings.is_size_alone(piece.symbol)
    return -abs(piece.symbol) if sized else piece.symbol


def state_signed(piece: Piece, case: Case, sign: int = 1) -> Formula:
    """The number of a piece, negative where it points against its positive sense; the opposite of
    that where `sign` is negative.
    """
    size = length(piece.value, case.arithmetic)
    against = double(piece.value.dot(piece.positive)) * sign < 0
    return measure(-size if against else size, piece.symbol.unit)


def find_heading(piece: Piece, case: Case) -> Inclination | None:
    """The direction of a piece by an angle that is known."""
    direction = bearing(piece.positive)
    straight = name_axis(direction)
    ends = find_term_ends(piece.term, case) if piece.term else None
    if straight is not None or ends is None:
        return straight
    found = name_along(direction, ends, case)
    known = found is not None and is_inclination_known(found, ends, case)
    return found if known else None


def add_components(
    axis: AxisName,
    name: VectorSymbol,
    facts: Sequence[Fact],
    case: Case,
    sign: Literal["+", "-"] = "+",
) -> Equation:
    """One component of a sum of vectors, or of what remains of the first without the others."""
    first, *others = facts
    summands = list(list_component(first, axis, case))
    for fact in others:
        for share in list_component(fact, axis, case):
            summands.append({"+": share, "-": _flip(share)}[sign])
    start = first.value[PLACES[axis]]
    rest = add_vectors(fact.value for fact in others)[PLACES[axis]]
    whole = {"+": start + rest, "-": start - rest}[sign]
    return add_summands(name_component(name, axis), summands, whole, _LEVELS[name.letter])


def _flip(summand: Summand) -> Summand:
    """The opposite of a summand."""
    return replace(summand, sign=_SIGNS[{"+": -1, "-": 1}[summand.sign]])


def list_turning_summands(
    axis: AxisName, term: Term, case: Case, level: Level
) -> Iterator[Summand]:
    """The terms that the rotation about a base point adds to a component; none where the rotation
    is zero, or the arm by the choice of the axes.
    """
    other = OTHER[axis]
    turn = {"x": -1, "y": 1}[axis]
    rate, body = case.motion.rates[term.rate], term.rate.body
    letters, value = case.naming.turning(body, level), case.rates(level)[term.rate]
    axes = choose_axes(case.construction)
    across, along = (state_arm(one, term, axes, case) for one in (other, axis))
    if double(value) and across is not None:
        arm = measure(term.vector[PLACES[other]] * across.sign, "m")
        yield Summand(
            _SIGNS[turn * across.sign],
            letters * across.size,
            (measure(value, UNITS[level, True]), arm),
        )
    if level == "acceleration" and double(rate) and along is not None:
        yield Summand(
            _SIGNS[-along.sign],
            case.naming.omega(body) ** TWO * along.size,
            (measure(rate, "rad/s"), measure(term.vector[PLACES[axis]] * along.sign, "m")),
            squared=True,
        )


def state_arm(axis: AxisName, term: Term, axes: Axes, case: Case) -> Formula | None:
    """A coordinate of a point from its base point, each left out where the choice of the axes makes
    it zero; None where it makes both zero.
    """
    point, base = (
        name_coordinate(axis, case.naming.letter(name)) for name in (term.point, term.base)
    )
    placed = axes.coordinate(axis, term.point)
    if axes.coordinate(axis, term.base) != ZERO:
        return -base if placed == ZERO else point - base
    return None if placed == ZERO else point
