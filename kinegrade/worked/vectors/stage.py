"""The vector equations of one step, and their projections in symbols and in numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ONE, ZERO, add_terms
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.formula import Formula, Function
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import measure, state_angle
from kinegrade.worked.vectors.magnitudes import state_magnitude
from kinegrade.worked.vectors.projection import Projection, Share
from kinegrade.worked.vectors.vectors import UNITS, name_value


@dataclass(frozen=True)
class Stage:
    """The vector equations of one step, which share their unknowns."""

    equations: tuple[VectorEquation, ...]
    level: Level
    case: Case

    def occurrences(self, rate: Rate) -> list[tuple[VectorEquation, Part]]:
        """The places where an unknown stands."""
        return [
            (equation, part)
            for equation in self.equations
            for part in equation.parts
            if part.unknown == rate
        ]

    def project(self, projection: Projection, solved: Collection[Rate] | None) -> Equation:
        """A projection as an equation: in symbols where `solved` is None, else in numbers with the
        rates that are solved.
        """
        left, right = (
            self._add_shares(projection.equation, side, solved)
            for side in (projection.left, projection.right)
        )
        return Equation(left, equate(right))

    def _add_shares(
        self, equation: VectorEquation, shares: Sequence[Share], solved: Collection[Rate] | None
    ) -> Formula:
        """One side of a projection."""
        return add_terms(self._list_terms(equation, shares, 1, solved))

    def solve(
        self, projection: Projection, rate: Rate, solved: Collection[Rate] | None
    ) -> Formula | None:
        """What a projection says of its one unknown vector, in symbols or in numbers; None where
        that stands in several places.
        """
        sought = [
            (sign, share)
            for sign, side in ((1, projection.left), (-1, projection.right))
            for share in side
            if share.part.unknown == rate
        ]
        if len(sought) != 1 or len(self.occurrences(rate)) != 1:
            return None
        ((side, share),) = sought
        turned = -side * share.sign
        left = [one for one in projection.left if one.part.unknown != rate]
        right = [one for one in projection.right if one.part.unknown != rate]
        terms = [
            *self._list_terms(projection.equation, right, -turned, solved),
            *self._list_terms(projection.equation, left, turned, solved),
        ]
        return divide_by_cosine(add_terms(terms), share.angle)

    def _list_terms(
        self,
        equation: VectorEquation,
        shares: Sequence[Share],
        sign: int,
        solved: Collection[Rate] | None,
    ) -> Iterator[Formula]:
        """The shares of one side, each with its cosine and, where `sign` is negative, turned."""
        for share in shares:
            amount = self._state_share(equation, share.part, solved)
            if amount != ZERO:
                term = multiply_by_cosine(amount.size, share.angle)
                yield term.signed(sign * amount.sign * share.sign)

    def _state_share(
        self, equation: VectorEquation, part: Part, solved: Collection[Rate] | None
    ) -> Formula:
        """The magnitude of a share without its cosine. An unknown one stays a symbol in numbers
        too, with its numeric factor.
        """
        unit = UNITS[self.level, False]
        if part.unknown is None or part.term is None:
            if solved is None:
                return name_value(equation, part, self.case)
            return measure(length(part.value, self.case.arithmetic), unit)
        if solved is not None and part.unknown in solved:
            return measure(measure_along_direction(part.term, self.case, self.level), unit)
        return self._state_unknown(equation, part, part.term, solved is not None)

    def _state_unknown(
        self, equation: VectorEquation, part: Part, term: Term, in_numbers: bool
    ) -> Formula:
        """An unknown: the vector's symbol, or arm times rate where several vectors share it."""
        symbol = name_value(equation, part, self.case)
        if len(self.occurrences(term.rate)) == 1:
            return symbol
        if in_numbers and term.kind == "rotation":
            arm = measure(length(term.vector, self.case.arithmetic), "m")
            return arm * self.case.naming.turning(term.rate.body, self.level)
        if in_numbers:
            return symbol
        return state_magnitude(equation, part, self.case) or symbol


def multiply_by_cosine(size: Formula, angle: float) -> Formula:
    """A size times the cosine of an angle in degrees, without a factor of one.

    >>> multiply_by_cosine(ONE, 0.0), type(multiply_by_cosine(ONE, 30.0)).__name__
    (Number(digits='1'), 'Function')
    """
    if angle == 0:
        return size
    cosine = Function("cos", state_angle(angle))
    return cosine if size == ONE else size * cosine


def divide_by_cosine(size: Formula, angle: float) -> Formula:
    """A formula over the cosine of an angle in degrees, a minus sign before the fraction."""
    if angle == 0 or size == ZERO:
        return size
    return (size.size / Function("cos", state_angle(angle))).signed(size.sign)


def measure_along_direction(term: Term, case: Case, level: Level) -> Any:
    """A term's signed value along its positive direction: exact where the field holds it."""
    rate = case.rates(level)[term.rate]
    size = length(term.vector, case.arithmetic)
    return float(rate) * size if isinstance(size, float) else rate * size
