"""Components of vectors along the direction that an ask names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kinegrade.expressions.tree import Expression, find_names
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import ZERO, add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import bearing, double, tidy
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.positions.bisectors import find_bisector_angle
from kinegrade.worked.vectors.by_components import project_components, split
from kinegrade.worked.vectors.components import state_signed
from kinegrade.worked.vectors.slopes.derived_angles import is_line_found
from kinegrade.worked.vectors.slopes.directions import is_inclination_known, name_along
from kinegrade.worked.vectors.slopes.inclination import Inclination, name_axis, relate
from kinegrade.worked.vectors.stage import multiply_by_cosine

_QUARTER = 90.0  # degrees
RIGHT = 1e-7  # degrees from a right angle that count as a right angle


@dataclass(frozen=True)
class Working:
    """A number in symbols, and with numbers substituted where that adds something."""

    symbols: Formula
    numbers: Formula | None = None


def name_known_axis(direction: Expression, value: Vector, case: Case) -> Inclination | None:
    """The direction that an ask names, whose value is given, along or normal to the line of two
    points or to the bisector of a given angle, by an angle that is known; None where none is.
    """
    half = find_bisector_angle(direction, case)
    if half is not None:
        return relate(bearing(value), half)
    points = [name for name in find_names(direction) if name in case.motion.points]
    if len(points) != 2:
        return None
    ends = (points[0], points[1])
    found = name_along(bearing(value), ends, case)
    return found if found and is_inclination_known(found, ends, case) else None


def project(fact: Fact, direction: Vector, case: Case, named: Inclination | None = None) -> Working:
    """The component along a direction, `named` by an angle where one is known: from the
    components, or each magnitude times a cosine, in symbols where the angles have any; those normal
    to it add nothing.
    """
    if fact.by_components and named is not None and named.angle is not None:
        return Working(*project_on(split(fact), named, case))
    axis = bearing(direction)
    straight = named or name_axis(axis)
    if not fact.by_components and straight is not None:
        seen = [piece for piece in fact.parts if double(piece.value.squared())]
        told = project_on(seen, straight, case)
        if told[0] != ZERO:
            return Working(*told)
    symbols, numbers = list[Formula](), list[Formula]()
    for piece in split(fact) if fact.by_components else fact.parts:
        angle = abs((bearing(piece.positive) - axis + 180) % 360 - 180)
        if abs(angle - 90) > RIGHT and double(piece.positive.squared()):
            sign, acute = (1 if angle < 90 else -1), tidy(min(angle, 180 - angle))
            symbols.append(_turn_to_axis(piece.symbol, piece, acute, case).signed(sign))
            number = state_signed(piece, case)
            if number != ZERO:
                share = _turn_to_axis(number.size, piece, acute, case)
                numbers.append(share.signed(sign * number.sign))
    shown = add_terms(numbers)
    return Working(add_terms(symbols), None if shown.is_decimal else shown)


def project_on(pieces: Sequence[Piece], axis: Inclination, case: Case) -> tuple[Formula, Formula]:
    """The projection of the pieces of a vector, in symbols and in numbers; zero in symbols where
    no known angle names the direction of a piece.
    """
    symbols, numbers = (
        add_terms(project_components(pieces, axis, case, in_numbers=one)) for one in (False, True)
    )
    return symbols, numbers


def _turn_to_axis(size: Formula, piece: Piece, angle: float, case: Case) -> Formula:
    """A size times the cosine of a piece's angle with a direction, in degrees, or the sine of the
    angle that is left to a right one where that is of a line that has been found. Of the components
    of a vector, x and y, one has a sine and one a cosine.
    """
    rest = tidy(_QUARTER - angle)
    found, other = (is_line_found(one, case) for one in (angle, rest))
    by_sine = other if found != other else piece.symbol.axis == "y"
    if by_sine and angle:
        return size * Function("sin", state_angle(rest))
    return multiply_by_cosine(size, angle)
