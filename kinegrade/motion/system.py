"""The conditions on positions as equations in numbers of order one, by which a path is followed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.terms import Term
from kinegrade.motion.conditions import Conditions, Placed
from kinegrade.motion.displacement import Displacement
from kinegrade.motion.input import Input
from kinegrade.numbers.doubles import Doubles
from kinegrade.numbers.number import Arithmetic, Number

Row = NDArray[np.float64]
_VANISHING = 1e-12  # of the greatest coefficient
_INDEPENDENT = 1e-7  # of a row's length: what is left of it beside the rows before


class System:
    """The unknowns are the coordinates of all rates and, last, that of the input: angles in rad,
    ways in sizes of the mechanism. Rows are divided by their greatest coefficient at the instant.
    """

    def __init__(self, frames: Frames, moved: Input, rates: Sequence[Rate]) -> None:
        self.frames, self.input, self.rates = frames, moved, tuple(rates)
        self.conditions = Conditions(frames)
        self.size = measure_size(frames)
        lengths = {term.rate: _measure_unit(term) for term in _list_terms(frames)}
        units = [self.size / lengths[rate] if rate in lengths else 1.0 for rate in self.rates]
        self.units = np.array([*units, 1.0 if moved.is_angle else self.size])
        self.weights = np.ones(0)
        greatest = np.abs(self.evaluate(np.zeros(len(self.units)))[1]).max(axis=1)
        # A row of an arm that stands along an axis vanishes at the instant
        self.weights = 1.0 / np.where(greatest > _VANISHING * greatest.max(), greatest, self.size)

    def place(
        self, coordinates: Sequence[Number], moved: Number, arithmetic: Arithmetic
    ) -> tuple[Displacement, tuple[Placed, ...]]:
        """The relations where the coordinates and the input have gone to."""
        by_rate = dict(zip(self.rates, coordinates, strict=True))
        at = Displacement(by_rate, self.frames.bases, arithmetic)
        imposed = tuple(share * moved if share else 0.0 for share in self.input.shares)
        return at, self.conditions.place(at, imposed)

    def evaluate(self, unknowns: Row) -> tuple[Row, Row]:
        """By how much every condition is missed, and the derivatives of that."""
        values = (unknowns * self.units).tolist()
        _, placed = self.place(values[:-1], values[-1], Doubles())
        missed = np.array([number for each in placed for number in each.missed])
        rows = np.array(
            [
                [*(row.get(rate, 0.0) for rate in self.rates), -share]
                for each, share in zip(placed, self.input.shares, strict=True)
                for row in each.relation.equations()
            ],
            dtype=float,
        )
        weights = self.weights if len(self.weights) else np.ones(len(missed))
        return missed * weights, rows * self.units * weights[:, None]

    @cached_property
    def independent(self) -> list[int]:
        """The rows that are independent at the instant: surplus ones are left out."""
        _, rows = self.evaluate(np.zeros(len(self.units)))
        chosen: list[int] = []
        basis: list[Row] = []
        for number, row in enumerate(rows):
            rest = row - sum((base * (base @ row) for base in basis), np.zeros_like(row))
            rest = rest - sum((base * (base @ rest) for base in basis), np.zeros_like(row))
            if np.linalg.norm(rest) > _INDEPENDENT * np.linalg.norm(row):
                chosen.append(number)
                basis.append(rest / np.linalg.norm(rest))
        return chosen


def measure_size(frames: Frames) -> float:
    """The size of a mechanism, m: the greatest distance of its points, 1 where all are in one."""
    places = frames.mechanism.points.values()
    arms = (first - second for first, second in combinations(places, 2))
    return max((math.hypot(arm.x, arm.y) for arm in arms), default=0.0) or 1.0


def _list_terms(frames: Frames) -> Iterator[Term]:
    """The terms of ways along lines."""
    chains = [base.chain for base in frames.bases.values()]
    chains += [side for each in frames.relations for side in (each.left, each.right)]
    return (term for chain in chains for term in chain if term.kind == "sliding")


def _measure_unit(term: Term) -> float:
    """The length of a term's vector, m, of which its coordinate is a multiple."""
    return math.hypot(term.vector.x, term.vector.y)
