"""What is asked of a mechanism, over its whole cycle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from kinegrade.errors import AtInfinity
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import find_names
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.motion.arrays import Arrays
from kinegrade.motion.path import Array, Placement
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.floats import Floats
from kinegrade.problem.quantities.functions import make_quantities, needs_configurations
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask, Template

_TAIL = 6.0  # per cent of the input's range
_EQUAL = 1e-9  # of the range of values
_STEEP = 4.0  # times what the other positions take


@dataclass(frozen=True, eq=False)
class Curve:
    """An ask's values, in its unit, where the input has `moved` to (rad or m since the instant);
    not finite at dead points and where a pole is at infinity.
    """

    ask: Ask
    moved: Array
    values: Array

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
        width = self.usual[1] - self.usual[0]
        return float(known.max() - known.min()) > _STEEP * width > 0

    @cached_property
    def least(self) -> int:
        """The number of the first position at which the value is least, to within rounding."""
        return self._find_first(-self.values)

    @cached_property
    def greatest(self) -> int:
        """The number of the first position at which the value is greatest, likewise."""
        return self._find_first(self.values)

    def _find_first(self, values: Array) -> int:
        known = np.where(np.isfinite(values), values, np.nan)
        slack = _EQUAL * (np.nanmax(known) - np.nanmin(known))
        return int(np.flatnonzero(known >= np.nanmax(known) - slack)[0])


def find_followed(template: Template) -> tuple[str, ...]:
    """The asks that have values along a cycle: what is read off one position alone, and names no
    angle of the instant.
    """
    fixed = {name for name, parameter in template.parameters.items() if not parameter.unit.angle}
    return tuple(
        name
        for name, ask in template.asks.items()
        if not needs_configurations(ask.quantity)
        and not set(find_names(ask.quantity)) & (template.parameters.keys() - fixed)
    )


def trace_curves(solution: Solution, placement: Placement, names: tuple[str, ...]) -> list[Curve]:
    """The curves of these asks, all of which can be followed."""
    return [
        Curve(ask, placement.moved, _read_values(ask, solution, placement))
        for ask in map(solution.template.asks.__getitem__, names)
    ]


def _read_values(ask: Ask, solution: Solution, placement: Placement) -> Array:
    """The values of an ask, in its unit."""
    motion, arithmetic, shape = placement.motion, Arrays(), placement.moved.shape
    values = {
        **find_body_names(motion.frames.mechanism),
        **dict(_list_fixed_values(solution.assembly.values)),
        **motion.points,
    }
    functions = {
        **make_elementary_functions(arithmetic),
        **make_constructions(arithmetic, motion.points),
        **make_quantities(motion, arithmetic),
    }
    try:
        with arithmetic.context():
            number = evaluate(ask.quantity, values, functions, arithmetic)
    except AtInfinity:
        return np.full(shape, np.inf)
    found = np.broadcast_to(np.asarray(number, dtype=float), shape)
    if ask.unit.degrees:
        return np.asarray(np.degrees(np.unwrap(found)))
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
