"""Known vectors of which a solution has found the components, or the normal and tangential parts:
they enter a projection by these, so that no angle is needed which nothing else tells.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, add_squares
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, is_zero, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.vectors.components import find_heading, name_signed, state_signed
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.inclination import Inclination
from kinegrade.worked.vectors.summands import name_component


def find_components(part: Part, level: Level, case: Case) -> tuple[Piece, ...]:
    """The pieces by which a part has been found: its components along the axes, or its normal and
    tangential parts; none where it is known by one magnitude.
    """
    key = make_key(part.together, level)
    fact = case.findings.facts.get(key) if part.together else None
    if fact is None:
        return ()
    pieces = split(fact) if fact.by_components else fact.pieces
    telling = tuple(piece for piece in pieces if not is_zero(piece.value))
    return telling if len(telling) > 1 else ()


def split(fact: Fact) -> tuple[Piece, Piece]:
    """A vector as the sum of its components along the axes."""
    x, y = fact.value
    along, up = (name_component(fact.symbol, axis) for axis in AXES)
    return (
        Piece(along, Vector(1, 0), Vector(1, 0) * x),
        Piece(up, Vector(0, 1), Vector(0, 1) * y),
    )


def state_size(fact: Fact, case: Case) -> Equation:
    """The magnitude of a vector from its components, or from the one that is not zero."""
    unit, names = fact.symbol.unit, dict(zip(AXES, fact.value, strict=True))
    seen = {name: value for name, value in names.items() if double(value)}
    letters = [name_component(fact.symbol, name) for name in seen]
    size = state_number(length(fact.value, case.arithmetic), unit)
    if not seen:
        return Equation(fact.symbol, size)
    if len(seen) == 1:
        return Equation(fact.symbol, (*equate(abs(letters[0])), *size))
    numbers = add_squares(measure(value, unit) for value in seen.values())
    return Equation(fact.symbol, (*equate(add_squares(letters), numbers), *size))


def project_components(
    pieces: Sequence[Piece], axis: Inclination, case: Case, *, in_numbers: bool
) -> tuple[Formula, ...]:
    """The projection of a vector on a named axis, piece by piece: v_Ax cos(phi) + v_Ay sin(phi);
    none where a piece has a direction that no known angle names.
    """
    shares = list[Formula]()
    for piece in pieces:
        heading = find_heading(piece, case)
        if heading is None:
            return ()
        cosine = find_cosine(heading, axis)
        turned = (heading.quarters - axis.quarters) % 4
        letters = name_signed(piece, case)
        number = state_signed(piece, case, letters.sign).signed(letters.sign)
        size = number if in_numbers else letters
        if cosine is not None:
            share = size.size * cosine.state(in_numbers)
            shares.append(share.signed(cosine.sign * size.sign))
        elif turned % 2 == 0:
            shares.append(size.signed(1 - turned))
    return tuple(shares)
