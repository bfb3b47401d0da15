"""Curves of what is asked of a mechanism, read off its motion along a path."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from kinegrade.cycles.curves import Curve, Gap
from kinegrade.cycles.gaps import ASIDE, GapSearch
from kinegrade.cycles.rounding import find_scales
from kinegrade.cycles.undetermined import find_undetermined, shake_motion
from kinegrade.errors import AtInfinity
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import find_names
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.arrays import Arrays
from kinegrade.motion.path import Array, MotionPath, Placement
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.floats import Floats
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask

_POSITIONS = 721  # between which gaps are found
_WITHIN = 0.999  # of what is left out at a gap: the positions at its ends have values
_TOGETHER = 1e-6  # of the mechanism's size: how far apart points are that coincide


@dataclass(frozen=True, eq=False)
class CurveTracer:
    """Traces what is asked, of which all can be followed, along a path of an instance."""

    solution: Solution
    path: MotionPath
    names: tuple[str, ...]

    def trace(self, placement: Placement) -> list[Curve]:
        """The curves at positions of the path; none has a value at a gap, or too near to it for
        rounding not to show.
        """
        moved = placement.moved
        scales, rows = find_scales(self.path), self._read(placement.motion, moved)
        found = []
        for ask, row, gaps in zip(self._asks, rows, self._gaps, strict=True):
            values = self._break_off(ask, scales.clear(row, ask.unit), moved, gaps)
            found.append(Curve(ask, moved, values, gaps))
        return found

    def read(self, moved: Array) -> Array:
        """Rows of the values at displacements of the input, whatever is at gaps; angles within a
        turn.
        """
        scales = find_scales(self.path)
        rows = self._read_beside(moved, lambda placement: placement.motion)
        cleared = (scales.clear(row, ask.unit) for row, ask in zip(rows, self._asks, strict=True))
        return np.array(list(cleared))

    def add_gaps(self, moved: Array) -> Array:
        """Displacements of the input with those at all gaps, and those from which on curves have
        values on both sides; those too near to a gap are left out.
        """
        gaps = np.array([gap.displacement for gaps in self._gaps for gap in gaps])
        beside = (gaps + share * self._aside for share in (-1, 0, 1))
        nearest = np.abs(moved[:, None] - gaps).min(axis=1, initial=np.inf)
        return np.unique(np.concatenate([moved[nearest > self._aside], *beside]))

    @property
    def _asks(self) -> list[Ask]:
        return [self.solution.template.asks[name] for name in self.names]

    @property
    def _aside(self) -> float:
        low, high = self.path.bounds
        return ASIDE * (high - low)

    @cached_property
    def _gaps(self) -> list[tuple[Gap, ...]]:
        """Those of each ask."""
        if not self.names:
            return []
        periods = [360.0 if ask.unit.degrees else math.inf for ask in self._asks]
        scales = find_scales(self.path)
        search = GapSearch(
            lambda moved: self._read_beside(moved, lambda placement: placement.motion),
            lambda moved: self._read_beside(moved, lambda each: shake_motion(each, scales)),
            np.array(periods),
            self.path.spread(_POSITIONS),
        )
        found = self._add_changes(search.find())
        shared = self._merge([place for places in found for place in places])
        every = np.unique([shared(place) for places in found for place in places])
        swaying = search.find_swaying(every)
        return [
            tuple(
                Gap(each, self._find_together(ask, each))
                for each in sorted({*map(shared, places), *every[sways].tolist()})
            )
            for ask, places, sways in zip(self._asks, found, swaying, strict=True)
        ]

    def _add_changes(self, found: Sequence[tuple[float, ...]]) -> list[tuple[float, ...]]:
        """The places, with the change points for what is not determined there."""
        low, high = self.path.bounds
        added = [*found]
        for change in self.path.changes:
            place = change.displacement
            if low + self._aside < place < high - self._aside:
                loose = find_undetermined(self.path, place, place - self._aside, self._read)
                added = [
                    (*places, place) if new else places
                    for places, new in zip(added, loose, strict=True)
                ]
        return added

    def _merge(self, places: list[float]) -> Callable[[float], float]:
        """What finds the one place of all that are too near to each other to be told apart."""
        ordered = np.unique(places)
        groups = np.split(ordered, np.flatnonzero(np.diff(ordered) > self._aside) + 1)
        middles = np.array([float(group[len(group) // 2]) for group in groups if group.size])
        return lambda place: float(middles[np.argmin(np.abs(middles - place))])

    def _find_together(self, ask: Ask, displacement: float) -> tuple[str, ...]:
        """The points named in an ask of which some coincide there, and not at the instant."""
        points = self.path.place(np.array([displacement])).frames.mechanism.points
        named = [name for name in dict.fromkeys(find_names(ask.quantity)) if name in points]

        def is_apart(first: str, second: str, places: Mapping[str, Vector]) -> bool:
            apart = float(np.max(np.hypot(*(places[first] - places[second]))))
            return apart > _TOGETHER * self.path.size

        pairs = [
            pair
            for pair in combinations(named, 2)
            if is_apart(*pair, self.path.motion.points) and not is_apart(*pair, points)
        ]
        return tuple(name for name in named if any(name in pair for pair in pairs))

    def _break_off(self, ask: Ask, values: Array, moved: Array, gaps: tuple[Gap, ...]) -> Array:
        """The values without those at gaps; angles go on through full turns between two gaps."""
        found = values.copy()
        for gap in gaps:
            found[np.abs(moved - gap.displacement) < _WITHIN * self._aside] = np.nan
        if ask.unit.degrees:
            known = np.isfinite(found)
            ends = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]])))
            bounds = {0, len(found), *ends.tolist()}
            bounds |= {int(np.searchsorted(moved, gap.displacement)) for gap in gaps}
            for start, end in pairwise(sorted(bounds)):
                found[start:end] = np.unwrap(found[start:end], period=360.0)
        return found

    def _read_beside(self, moved: Array, find: Callable[[Placement], Motion]) -> Array:
        """Rows of the values of all asks in motions at displacements of the input; the instant is
        read as well, as nothing can be said of positions that are all singular.
        """
        with_instant = np.append(moved, 0.0)
        return self._read(find(self.path.place(with_instant)), with_instant)[:, :-1]

    def _read(self, motion: Motion, moved: Array) -> Array:
        """Rows of the values of all asks, each in its unit."""
        arithmetic = Arrays()
        values = {
            **find_body_names(motion.frames.mechanism),
            **dict(_list_fixed_values(self.solution.assembly.values)),
            **motion.points,
        }
        functions = {
            **make_elementary_functions(arithmetic),
            **make_constructions(arithmetic, motion.points),
            **make_quantities(motion, arithmetic),
        }
        return np.array([_read_values(ask, values, functions, moved) for ask in self._asks])


def _read_values(
    ask: Ask, values: Mapping[str, Any], functions: Mapping[str, Any], moved: Array
) -> Array:
    """The values of an ask, in its unit."""
    arithmetic = Arrays()
    try:
        with arithmetic.context():
            number = evaluate(ask.quantity, values, functions, arithmetic)
    except AtInfinity:
        return np.full(moved.shape, np.inf)
    found = np.broadcast_to(np.asarray(number, dtype=float), moved.shape)
    if ask.unit.degrees:
        return np.asarray(np.degrees(found))
    return np.asarray(found / Floats().scale(ask.unit.scale))


def _list_fixed_values(values: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The numbers and words among the values of an instance, in doubles; not points and lines."""
    for name, value in values.items():
        if isinstance(value, str):
            yield name, value
        elif not isinstance(value, tuple):
            try:
                yield name, convert_number(value)
            except (TypeError, AttributeError):
                continue
