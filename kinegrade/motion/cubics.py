"""The cubics between the knots of a path: about where a mechanism is, before the conditions are met
exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinegrade.motion.following import Knot

Array = NDArray[np.float64]
_HALVINGS = 14
_ENDS = (slice(0, -1), slice(1, None))  # the knots at which stretches begin and end


@dataclass(frozen=True, eq=False)
class PathCubics:
    """A cubic for each stretch between two knots, of every coordinate, the last of which is the
    input; `units` are those of the coordinates, rad or m.
    """

    knots: Sequence[Knot]
    units: Array

    def spread_by_length(self, count: int) -> Array:
        """`count` displacements of the input at equal distances along the path, on which all
        coordinates count.
        """
        ends = np.concatenate([[0.0], np.cumsum(self._lengths)])
        gone = np.linspace(0.0, ends[-1], count)
        number = np.clip(np.searchsorted(ends, gone, side="right") - 1, 0, len(self._lengths) - 1)
        share = (gone - ends[number]) / self._lengths[number]
        a, b, c, d = (part[number, -1] for part in self._coefficients)
        return np.asarray(((d * share + c) * share + b) * share + a)

    def guess(self, moved: Array) -> Array:
        """The coordinates about where the input has gone so far: the input of a cubic
        is found by halving, as it hardly changes near a dead point.
        """
        inputs = self._knots[:, -1]
        number = np.clip(np.searchsorted(inputs, moved, side="right") - 1, 0, len(inputs) - 2)
        a, b, c, d = (part[number, -1] for part in self._coefficients)
        low, width = np.zeros(len(moved)), 1.0
        for _ in range(_HALVINGS):
            width /= 2
            middle = low + width
            value = ((d * middle + c) * middle + b) * middle + a
            low = np.where(value > moved, low, middle)
        a, b, c, d = (part[number, :-1].T for part in self._coefficients)
        share = low + width / 2
        return np.asarray(((d * share + c) * share + b) * share + a)

    @cached_property
    def _knots(self) -> Array:
        return np.asarray([knot.unknowns * self.units for knot in self.knots])

    @cached_property
    def _tangents(self) -> Array:
        return np.asarray([knot.tangent * self.units for knot in self.knots])

    @cached_property
    def _lengths(self) -> Array:
        """How long each stretch between knots is, in units of the coordinates."""
        return np.asarray(np.linalg.norm(np.diff(self._knots, axis=0) / self.units, axis=1))

    @cached_property
    def _coefficients(self) -> tuple[Array, Array, Array, Array]:
        """The coefficients of each stretch's cubics in the part of it that is gone."""
        first, rise = self._knots[:-1], np.diff(self._knots, axis=0)
        leaving, arriving = (self._tangents[each] * self._lengths[:, None] for each in _ENDS)
        return first, leaving, 3 * rise - 2 * leaving - arriving, leaving + arriving - 2 * rise
