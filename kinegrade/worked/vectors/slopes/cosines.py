"""The cosine of the angle between two directions, by the named angles of both."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from kinegrade.worked.case import write_row
from kinegrade.worked.formulas.atoms import TWO, add_terms, list_summands
from kinegrade.worked.formulas.formula import Formula, Sum
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import tidy
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.vectors.slopes.derived_angles import ACUTE
from kinegrade.worked.vectors.slopes.inclination import Inclination

Ratio: TypeAlias = Literal["sin", "cos"]
_TURNED: tuple[tuple[int, Ratio], ...] = ((1, "cos"), (-1, "sin"), (-1, "cos"), (1, "sin"))


@dataclass(frozen=True)
class Cosine:
    """The cosine of the angle between two directions, as a sine or cosine of named angles;
    `summands` are those of its angle in degrees, with their signs, where it is a sum.
    """

    sign: int
    function: Ratio
    angle: Formula
    value: float
    summands: tuple[float, ...] = ()

    def state(self, in_numbers: bool) -> Formula:
        """The function without its sign, of the angle in symbols or in degrees."""
        return Function(self.function, state_angle(self.value) if in_numbers else self.angle)


def find_cosine(heading: Inclination, axis: Inclination) -> Cosine | None:
    """The cosine of the angle between two directions; None where that is a right angle or none."""
    terms = sorted(
        (
            (sign, one)
            for sign, one in ((heading.sign, heading), (-axis.sign, axis))
            if one.angle is not None
        ),
        key=lambda term: _rank(*term),
    )
    value = tidy(sum(sign * one.value for sign, one in terms))
    angle = _add_angles([(sign, one.angle) for sign, one in terms if one.angle is not None])
    if angle is None:
        return None
    if value < 0 or (value == 0 and angle.sign < 0):
        return find_cosine(_mirror(heading), _mirror(axis))
    sign, function = _TURNED[(heading.quarters - axis.quarters) % 4]
    values = sorted((sign * one.value for sign, one in terms), key=lambda each: each < 0)
    summands = tuple(values) if len(values) > 1 and isinstance(angle, Sum) else ()
    return Cosine(sign, function, angle, value, summands)


def _rank(sign: int, one: Inclination) -> tuple[int, bool, str]:
    """The place of an angle in a sum: the same in every sum, given angles before derived ones."""
    letters = "" if one.angle is None else write_row(one.angle.print())
    return -sign, rf"\{ACUTE}_" in letters, letters


def _mirror(one: Inclination) -> Inclination:
    """The direction reflected in the x axis, whose cosines are the same."""
    return Inclination(-one.sign, one.angle, one.value, -one.quarters)


def _add_angles(terms: list[tuple[int, Formula]]) -> Formula | None:
    """A sum of angles, those that count positive first; None where nothing is left."""
    if len(terms) == 2 and terms[0][1] == terms[1][1]:
        same = terms[0][0] == terms[1][0]
        return (TWO * terms[0][1]).signed(terms[0][0]) if same else None
    summands = [one for sign, angle in terms for one in list_summands(angle.signed(sign))]
    left: list[Formula] = []
    for one in summands:
        if -one in left:
            left.remove(-one)
        else:
            left.append(one)
    ordered = sorted(left, key=lambda one: -one.sign)
    return add_terms(ordered) if left else None
