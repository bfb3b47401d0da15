"""What is asked of a mechanism, over its whole cycle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kinegrade.expressions.tree import find_names
from kinegrade.motion.path import Array
from kinegrade.motion.placing import find_carriers
from kinegrade.problem.quantities.functions import needs_configurations
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask

_TAIL = 6.0  # per cent of the input's range
_EQUAL = 1e-8  # of the greatest value
_NEARLY = 0.01  # of the range of values: how much less a peak may be between positions
_MOST = 40  # peaks that are nearly equal
_EXACT = 1e-4  # of the range of values: how well a limit is known
_STEEP = 4.0  # times what the other positions take


@dataclass(frozen=True)
class Gap:
    """A displacement of the input, rad or m, at which an ask has no value: a direction that it is
    taken along has no length there, as between points that are `together`, or it is nothing
    divided by nothing.
    """

    displacement: float
    together: tuple[str, ...]


@dataclass(frozen=True)
class Extreme:
    """The least or greatest value, in the unit of the ask, and the displacement of the input, rad
    or m; one that `is_near` is only come near to there.
    """

    value: float
    displacement: float
    is_near: bool = False


@dataclass(frozen=True, eq=False)
class Curve:
    """An ask's values, in its unit, where the input has `moved` to (rad or m since the instant);
    not finite at dead points and where a pole is at infinity, NaN at its `gaps`.
    """

    ask: Ask
    moved: Array
    values: Array
    gaps: tuple[Gap, ...] = ()

    @cached_property
    def usual(self) -> tuple[float, float]:
        """Between which values the curve lies for all but the ends of the input's range."""
        known = np.isfinite(self.values)
        even = np.linspace(self.moved[0], self.moved[-1], len(self.moved))
        values = np.interp(even, self.moved[known], self.values[known])
        low, high = np.percentile(values, [_TAIL, 100 - _TAIL])
        return float(low), float(high)

    @property
    def is_steep(self) -> bool:
        """Whether values grow beyond bounds somewhere, as at dead points."""
        known = self.values[np.isfinite(self.values)]
        width = 0.0 if self.constant is not None else self.usual[1] - self.usual[0]
        return float(known.max() - known.min()) > _STEEP * width > 0

    @cached_property
    def constant(self) -> float | None:
        """The one value that all are to within rounding, which may be much at the ends of the
        input's range and beside gaps; None where there is none.
        """
        known = np.isfinite(self.values)
        inner = self.values[1:-1][known[:-2] & known[1:-1] & known[2:]]
        if not inner.size or np.ptp(inner) > _EQUAL * np.abs(inner).max():
            return None
        return float(np.median(inner))

    def list_tops(self, sign: float) -> tuple[int, ...]:
        """The numbers of the positions beside which the values, times `sign`, may be greatest."""
        heights = np.where(np.isfinite(self.values), sign * self.values, -np.inf)
        around = np.concatenate([[-np.inf], heights, [-np.inf]])
        high = heights >= heights.max() - _NEARLY * np.ptp(heights[np.isfinite(heights)])
        tops = np.flatnonzero(high & (heights >= np.maximum(around[:-2], around[2:])))
        return tuple(sorted(tops[np.argsort(-heights[tops], kind="stable")][:_MOST].tolist()))

    def find_limit(self, number: int) -> tuple[Gap, float] | None:
        """The gap that a position is next to, and what the value goes to there, which it does not
        reach.
        """
        moved, values = self.moved, self.values
        places = {gap.displacement: gap for gap in self.gaps}
        for behind, ahead in ((number - 1, number + 1), (number + 1, number - 1)):
            gap = places.get(moved[ahead]) if 0 < number < len(moved) - 1 else None
            if gap is not None:
                slope = (values[number] - values[behind]) / (moved[number] - moved[behind])
                limit = values[number] + slope * (gap.displacement - moved[number])
                step = 10.0 ** np.floor(np.log10(_EXACT * np.ptp(values[np.isfinite(values)])))
                return gap, float(np.round(limit / step) * step)
        return None


def find_followed(solution: Solution) -> tuple[str, ...]:
    """The asks that have values along a cycle: what is read off one position alone, and names
    nothing whose place or value is known at the instant alone.
    """
    unknown = set(_list_of_the_instant(solution))
    return tuple(
        name
        for name, ask in solution.template.asks.items()
        if not needs_configurations(ask.quantity) and unknown.isdisjoint(find_names(ask.quantity))
    )


def _list_of_the_instant(solution: Solution) -> Iterator[str]:
    """What a quantity may name that is known at the instant alone: what is given or worked out to
    say where points are, as those that move change it, and points that no body carries, unless
    their coordinates are numbers.
    """
    scheme = solution.template.scheme
    carried = find_carriers(solution.motion.frames.mechanism)
    placing = {
        name
        for expression in (*scheme.lengths.values(), *scheme.points.values())
        for name in find_names(expression)
    }
    yield from scheme.lengths
    yield from (name for name in scheme.parameters if name in placing)
    yield from solution.template.angles
    for name, place in scheme.points.items():
        if name not in carried and any(find_names(place)):
            yield name
