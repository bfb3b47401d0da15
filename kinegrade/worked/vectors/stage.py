"""The vector equations of one step, and their projections in symbols and in numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Piece
from kinegrade.worked.formulas.atoms import ONE, ZERO, add_terms, multiply_factors
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import measure, state_angle
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.by_components import find_components, project_components
from kinegrade.worked.vectors.projection import Deduction, Projection, Share
from kinegrade.worked.vectors.slopes.cosines import Cosine, find_cosine
from kinegrade.worked.vectors.slopes.directions import find_inclination, name_direction
from kinegrade.worked.vectors.slopes.inclination import Inclination, name_axis
from kinegrade.worked.vectors.table.magnitudes import state_magnitude
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

    def spares(self, deduction: Deduction) -> bool:
        """Whether a deduction gives what stands in no other equation and nothing else needs."""
        rate, *others = deduction.unknowns
        return not others and not deduction.scalars and self.leaves_out(rate)

    def leaves_out(self, rate: Rate) -> bool:
        """Whether an unknown stands in no other equation and nothing else needs it."""
        once = sum(rate in equation.unknowns for equation in self.equations) == 1
        return once and self.case.findings.spares(rate, self.level)

    def uses(self, rate: Rate, later: Sequence[Deduction]) -> bool:
        """Whether an answer, a later step or one of the later deductions needs a rate."""
        taken = any(one.involves(rate) for each in later for one in each.projections)
        return taken or not self.case.findings.spares(rate, self.level)

    def project(self, projection: Projection, solved: Collection[Rate] | None) -> Equation:
        """A projection as an equation: in symbols where `solved` is None, else in numbers with the
        rates that are solved.
        """
        left, right = (
            add_terms(self.list_terms(projection, side, 1, solved))
            for side in (projection.left, projection.right)
        )
        return Equation(left, equate(right))

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
        if len(sought) != 1:
            return None
        ((side, share),) = sought
        left = [one for one in projection.left if one.part.unknown != rate]
        right = [one for one in projection.right if one.part.unknown != rate]
        terms = [
            *self.list_terms(projection, right, -side, solved),
            *self.list_terms(projection, left, side, solved),
        ]
        sign, cosine = self.state_cosine(projection, share, solved is not None)
        total = add_terms(term.signed(-sign) for term in terms)
        arm = self._find_shared_arm(share.part, solved is not None)
        factors = [one for one in (arm, cosine) if one != ONE]
        return divide_by(total, multiply_factors(factors) if factors else ONE)

    def _find_shared_arm(self, part: Part, in_numbers: bool) -> Formula:
        """The arm of a rotation that several vectors share, whose rate is solved for; else 1."""
        if part.term is None or part.term.kind != "rotation":
            return ONE
        if len(self.occurrences(part.term.rate)) == 1:
            return ONE
        if in_numbers:
            return measure(length(part.term.vector, self.case.arithmetic), "m")
        return name_length(part.base, part.point, self.case)

    def list_terms(
        self,
        projection: Projection,
        shares: Sequence[Share],
        sign: int,
        solved: Collection[Rate] | None,
    ) -> Iterator[Formula]:
        """The shares of one side, each with its cosine and, where `sign` is negative, turned."""
        for share in shares:
            components = self._list_components(projection, share, solved is not None)
            yield from (one.signed(sign) for one in components)
            if components:
                continue
            amount = self._state_share(projection.equation, share.part, solved)
            if amount != ZERO:
                turned, cosine = self.state_cosine(projection, share, solved is not None)
                term = amount.size if cosine == ONE else amount.size * cosine
                yield term.signed(sign * amount.sign * turned)

    def find_pieces(self, projection: Projection, share: Share) -> tuple[Piece, ...]:
        """The parts by which a known vector enters a projection, none of one that does so whole."""
        pieces = find_components(share.part, self.level, self.case)
        return pieces if self._list_components(projection, share, False) else ()

    def _list_components(
        self, projection: Projection, share: Share, in_numbers: bool
    ) -> tuple[Formula, ...]:
        """The share of a vector by its components, none where it is not known by these alone."""
        pieces = find_components(share.part, self.level, self.case)
        axis = find_axis(projection, self.case)
        if axis is None:
            return ()
        return project_components(pieces, axis, self.case, in_numbers=in_numbers)

    def state_cosine(
        self, projection: Projection, share: Share, in_numbers: bool
    ) -> tuple[int, Formula]:
        """The sign and the cosine with which a part counts: of named angles where it has them."""
        named = find_share_cosine(projection, share, self.case) if share.angle else None
        if named is None:
            return share.sign, multiply_by_cosine(ONE, share.angle)
        return named.sign, named.state(in_numbers)

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


def divide_by(size: Formula, cosine: Formula) -> Formula:
    """A formula over a cosine, a minus sign before the fraction."""
    if size == ZERO or cosine == ONE:
        return size
    return (size.size / cosine).signed(size.sign)


def find_share_cosine(projection: Projection, share: Share, case: Case) -> Cosine | None:
    """The cosine of a part's angle with the axis, where both have named directions."""
    heading = find_inclination(share.part, case)
    axis = find_axis(projection, case)
    return None if heading is None or axis is None else find_cosine(heading, axis)


def find_axis(projection: Projection, case: Case) -> Inclination | None:
    """The axis as a named direction: itself, or by the unknown normal to it, else by a part along
    it.
    """
    part = projection.reference
    if part is None:
        return name_axis(projection.axis)
    return name_direction(projection.axis, part, case)


def measure_along_direction(term: Term, case: Case, level: Level) -> Any:
    """A term's signed value along its positive direction: exact where the field holds it."""
    rate = case.rates(level)[term.rate]
    size = length(term.vector, case.arithmetic)
    return float(rate) * size if isinstance(size, float) else rate * size
