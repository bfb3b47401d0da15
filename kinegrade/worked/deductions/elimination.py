"""How unknowns that several equations share are found: all but one are expressed by that one, and
inserted into the equation that is left.

Only coefficients are worked out here, in doubles; the values come from the exact motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import assert_never

from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Number
from kinegrade.worked.case import Case
from kinegrade.worked.vectors.projection import PARALLEL, Deduction, Projection


@dataclass(frozen=True)
class Line:
    """A rate as a line over the kept one: `slope` times that plus `offset`."""

    slope: float
    offset: float


@dataclass(frozen=True)
class Elimination:
    """All unknowns as lines over the rate that is `kept`, which `into` then gives; `by` is the
    projection that has expressed them, None where relations between rates have.
    """

    kept: Rate
    lines: Mapping[Rate, Line]
    into: Projection
    by: Projection | None


@dataclass(frozen=True)
class _Row:
    """A linear equation: the coefficients of the rates, and what their sum is equal to."""

    coefficients: Mapping[Rate, float]
    total: float

    def subtract(self, other: _Row, rate: Rate) -> _Row:
        """The equation without `rate`, by as much of another one as that takes."""
        factor = self.coefficients.get(rate, 0.0) / other.coefficients[rate]
        rates = dict.fromkeys((*self.coefficients, *other.coefficients))
        left = {
            each: self.coefficients.get(each, 0.0) - factor * other.coefficients.get(each, 0.0)
            for each in rates
            if each != rate
        }
        return _Row(left, self.total - factor * other.total)


def find_elimination(deduction: Deduction, level: Level, case: Case) -> Elimination | None:
    """How the equations of a deduction give its unknowns: by relations between rates that are
    inserted into one projection, or by the last of two projections, inserted into the first; None
    where it takes more than that.
    """
    into, *others = deduction.projections or (None,)
    if into is None or len(others) > 1 or (others and deduction.scalars):
        return None
    rates = {rate: float(value) for rate, value in case.rates(level).items()}
    rows = [
        *(_make_scalar_row(scalar, deduction, level, case, rates) for scalar in deduction.scalars),
        *(_make_projected_row(each, deduction, rates) for each in others),
    ]
    for kept in _list_candidates(deduction, into):
        lines = _express(rows, deduction.unknowns, kept)
        if lines is not None:
            return Elimination(kept, lines, into, others[0] if others else None)
    return None


def _list_candidates(deduction: Deduction, into: Projection) -> Iterator[Rate]:
    """The unknowns that may be kept, rotations first, those first that stand in the projection."""
    yield from sorted(
        deduction.unknowns, key=lambda rate: (rate.kind != "turning", not into.involves(rate))
    )


def _find_side(scalar: Relation, level: Level, case: Case) -> list[Number]:
    """What a relation between rates equals at a level."""
    match level:
        case "velocity":
            return scalar.velocity_side()
        case "acceleration":
            return scalar.acceleration_side(case.motion.rates)
        case _:
            assert_never(level)


def _make_scalar_row(
    scalar: Relation, deduction: Deduction, level: Level, case: Case, rates: Mapping[Rate, float]
) -> _Row:
    """A relation between rates, with what is known in its total."""
    (row,), sides = scalar.equations(), _find_side(scalar, level, case)
    known = sum(
        float(factor) * rates[rate]
        for rate, factor in row.items()
        if rate not in deduction.unknowns
    )
    coefficients = {rate: float(row[rate]) for rate in row if rate in deduction.unknowns}
    return _Row(coefficients, float(sides[0]) - known)


def _make_projected_row(
    projection: Projection, deduction: Deduction, rates: Mapping[Rate, float]
) -> _Row:
    """A projection: its total is what the values of the unknowns make of it."""
    row = {rate: factor for rate, factor in projection.row().items() if rate in deduction.unknowns}
    return _Row(row, sum(factor * rates[rate] for rate, factor in row.items()))


def _express(rows: Sequence[_Row], unknowns: Sequence[Rate], kept: Rate) -> dict[Rate, Line] | None:
    """All unknowns by the one kept; None where the equations do not say them."""
    open_rows, solved = list(rows), dict[Rate, _Row]()
    for rate in unknowns:
        if rate == kept:
            continue
        usable = [row for row in open_rows if abs(row.coefficients.get(rate, 0.0)) > PARALLEL]
        if not usable:
            return None
        pivot = usable[0]
        open_rows = [row.subtract(pivot, rate) for row in open_rows if row is not pivot]
        solved = {each: row.subtract(pivot, rate) for each, row in solved.items()}
        solved[rate] = pivot
    lines = {
        rate: Line(
            -row.coefficients.get(kept, 0.0) / row.coefficients[rate],
            row.total / row.coefficients[rate],
        )
        for rate, row in solved.items()
    }
    return {**lines, kept: Line(1.0, 0.0)}
