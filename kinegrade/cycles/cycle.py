"""A mechanism's cycle as it is shown: its curves, strokes and ends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import assert_never

import numpy as np

from kinegrade.cycles.curves import Curve, Extreme, find_followed
from kinegrade.cycles.peaks import find_extremes
from kinegrade.cycles.swings import Swing, find_swings
from kinegrade.cycles.tracing import CurveTracer
from kinegrade.errors import MechanismError, TemplateError
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.motion.path import Array, MotionPath, Still, find_path
from kinegrade.problem.solution import Solution

_POSITIONS = 721


@dataclass(frozen=True, eq=False)
class Cycle:
    """The cycle of an instance through its instant.

    `curves` are over the whole cycle, at the displacements `moved`, `instant` has their values at
    the instant; with `centrodes` its figure shows velocity poles and the curves that they describe.
    """

    solution: Solution
    path: MotionPath
    moved: Array
    curves: tuple[Curve, ...]
    instant: tuple[float, ...]
    swings: tuple[Swing, ...]
    centrodes: bool = False

    @cached_property
    def extremes(self) -> Mapping[str, tuple[Extreme, Extreme]]:
        """The least and the greatest value of each ask that is not constant and does not grow
        beyond bounds.
        """
        return measure_extremes(self.solution, self.path, self.curves)


def measure_extremes(
    solution: Solution, path: MotionPath, curves: Sequence[Curve]
) -> Mapping[str, tuple[Extreme, Extreme]]:
    """The same of curves at any positions of a path."""
    measured = [each for each in curves if each.constant is None and not each.is_steep]
    if not measured:
        return {}
    tracer = CurveTracer(solution, path, tuple(each.ask.name for each in measured))
    return dict(zip(tracer.names, find_extremes(tracer.read, measured), strict=True))


def make_cycle(
    solution: Solution, names: Sequence[str] | None = None, *, centrodes: bool = False
) -> Cycle:
    """The cycle of a solved instance with the curves of these asks, by default of what the template
    gives points for.

    Raises MechanismError where it has none, TemplateError for asks that have no curve.
    """
    path = _require_path(solution)
    asked = _choose_asks(solution, names)
    tracer = CurveTracer(solution, path, asked)
    moved = tracer.add_gaps(path.spread(_POSITIONS))
    curves = tuple(tracer.trace(path.place(moved)))
    now = tracer.trace(path.place(np.zeros(1)))
    instant = tuple(float(curve.values[0]) for curve in now)
    return Cycle(solution, path, moved, curves, instant, find_swings(path), centrodes)


def _require_path(solution: Solution) -> MotionPath:
    """The path of a solved instance. Raises MechanismError where it has none."""
    found = find_path(solution.motion)
    match found:
        case MotionPath():
            return found
        case Still(reason=reason):
            raise MechanismError(Fault(solution.template.name, reason))
        case _:
            assert_never(found)


def _choose_asks(solution: Solution, names: Sequence[str] | None) -> tuple[str, ...]:
    """The asks of these names. Raises TemplateError for those that have no curve."""
    template = solution.template
    followed = find_followed(solution)
    if names is None:
        asked = template.asked() or tuple(template.asks)
        return tuple(name for name in asked if name in followed)
    astray = [name for name in names if name not in followed]
    if astray:
        known = list_plainly(followed)
        faults = (Message("motion.no-curve", ask=name, known=known) for name in astray)
        raise TemplateError(*(Fault(template.name, fault) for fault in faults))
    return tuple(names)
