"""The path of a mechanism: its positions, velocities and accelerations over its whole cycle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinegrade.errors import MechanismError, Problem
from kinegrade.language.message import Message
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.geometry import round_short
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import run_steps
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.motion.arrays import Arrays
from kinegrade.motion.conditions import Placed
from kinegrade.motion.cubics import PathCubics
from kinegrade.motion.displacement import Displacement
from kinegrade.motion.ends import ChangePoint, Closed, End, Limit
from kinegrade.motion.following import meet_input
from kinegrade.motion.input import Input, find_input
from kinegrade.motion.placing import place_frames
from kinegrade.motion.system import System
from kinegrade.motion.tracing import Trace, trace_path

Array = NDArray[np.float64]
_SOLVED = 1e-14
_MET = 1e-13
_ROUNDS = 8
_ASTRAY = 1e-3  # rad, or sizes of the mechanism: a path is known much better


@dataclass(frozen=True, eq=False)
class MotionPath:
    """The positions that a mechanism reaches from the instant, its lengths unchanged, by its input
    alone; all displacements are since the instant: rad or m.

    `motion` is that of the instant, in doubles.
    """

    motion: Motion
    system: System
    traced: Trace

    @property
    def input(self) -> Input:
        """What moves the mechanism."""
        return self.system.input

    @property
    def start(self) -> End | None:
        """What stops the input backwards; None where nothing does, so that the path begins at the
        instant.
        """
        return self.traced.start

    @property
    def end(self) -> End:
        """What stops the input forwards."""
        return self.traced.end

    @property
    def is_closed(self) -> bool:
        """Whether the path comes back to the instant."""
        return isinstance(self.end, Closed)

    @property
    def changes(self) -> tuple[ChangePoint, ...]:
        """The change points, in their order."""
        return self.traced.changes

    @property
    def size(self) -> float:
        """The greatest distance of the mechanism's points at the instant, m."""
        return self.system.size

    @cached_property
    def bounds(self) -> tuple[float, float]:
        """The least and the greatest displacement of the input."""
        first, last = self.traced.knots[0], self.traced.knots[-1]
        unit = self.system.units[-1]
        return float(first.unknowns[-1] * unit), float(last.unknowns[-1] * unit)

    def spread(self, count: int) -> Array:
        """`count` displacements of the input over the whole path: at equal distances on a path that
        nothing stops, else closer at its ends, as of a swinging input.
        """
        low, high = self.bounds
        if isinstance(self.start, Limit) or isinstance(self.end, Limit):
            swing = (1 - np.cos(np.linspace(0, np.pi, count))) / 2
            return np.asarray(low + (high - low) * swing)
        return np.linspace(low, high, count)

    def spread_by_length(self, count: int) -> Array:
        """`count` displacements at equal distances along the path, on which all coordinates count:
        closer where others change fast.
        """
        return np.asarray(np.clip(self._cubics.spread_by_length(count), *self.bounds))

    @cached_property
    def _cubics(self) -> PathCubics:
        return PathCubics(self.traced.knots, self.system.units)

    def place(self, moved: Array) -> Placement:
        """The positions at displacements of the input within the `bounds`. Raises MechanismError
        for others.
        """
        low, high = self.bounds
        slack = 1e-12 * (high - low)
        if moved.size and not (low - slack <= moved.min() and moved.max() <= high + slack):
            raise MechanismError(
                Message("motion.out-of-reach", low=round_short(low), high=round_short(high))
            )
        return self._solve(self._cubics.guess(moved), moved)

    def _solve(self, coordinates: Array, moved: Array) -> Placement:
        """Newton's method by the steps of the plan, for all positions at once; each keeps the best
        that it had, and none is corrected by so much that it might come to another branch.
        """
        arithmetic, least = Arrays(), np.full(moved.shape, np.inf)
        best, start = coordinates, coordinates
        with arithmetic.context():
            for _ in range(_ROUNDS):
                found = self._put(coordinates, moved)
                nearer = found.missed < least
                best = np.where(nearer, coordinates, best)
                least = np.where(nearer, found.missed, least)
                if not nearer.any() or least.max() < _SOLVED * self.size:
                    break
                coordinates = best + np.where(nearer, self._find_step(found.placed), 0.0)
                astray = np.abs((coordinates - start).T / self.system.units[:-1]).max(axis=1)
                coordinates = np.where(astray < _ASTRAY, coordinates, best)
            for number in np.flatnonzero(least > _MET * self.size):
                best[:, number] = self._solve_alone(start[:, number], moved[number])
            return self._put(best, moved)

    def _solve_alone(self, coordinates: Array, moved: float) -> Array:
        """One position at which the steps of the plan do not help, as at a change point."""
        guess = np.append(coordinates, moved) / self.system.units
        found = meet_input(self.system, guess, guess[-1])
        return coordinates if found is None else (found * self.system.units)[:-1]

    def _put(self, coordinates: Array, moved: Array) -> Placement:
        """The positions of these coordinates, whether or not they meet the conditions."""
        at, placed = self.system.place(tuple(coordinates), moved, Arrays())
        return Placement(self, moved, at, placed)

    def _find_step(self, placed: Sequence[Placed]) -> Array:
        """The step by which the conditions are met, to first order; none at a dead point."""
        equations = [each.relation.equations() for each in placed]
        right = [[-missed for missed in each.missed] for each in placed]
        steps = run_steps(self.motion.plan, equations, right, Arrays())
        size = np.shape(placed[-1].missed[0])
        rows = [np.broadcast_to(np.asarray(steps[rate]), size) for rate in self.system.rates]
        return np.asarray(np.nan_to_num(np.array(rows), nan=0.0, posinf=0.0, neginf=0.0))


@dataclass(frozen=True, eq=False)
class Placement:
    """Positions of a path at some displacements of the input, `moved`: `at` has the coordinates of
    all rates, `placed` the relations there.
    """

    path: MotionPath
    moved: Array
    at: Displacement
    placed: tuple[Placed, ...]

    @cached_property
    def missed(self) -> Array:
        """By how much the worst condition is missed at each position, m or rad."""
        misses = [np.broadcast_to(m, self.moved.shape) for each in self.placed for m in each.missed]
        return np.asarray(np.abs(np.array(misses)).max(axis=0))

    @property
    def greatest(self) -> float:
        """The same at the worst position."""
        return float(self.missed.max(initial=0.0))

    @cached_property
    def frames(self) -> Frames:
        """The mechanism and its relations where they are: numbers are arrays over positions."""
        relations: tuple[Relation, ...] = tuple(each.relation for each in self.placed)
        return place_frames(self.path.motion.frames, relations, self.at)

    @cached_property
    def motion(self) -> Motion:
        """The motion at every position, where the input has the velocity and the acceleration that
        are given for the instant; infinite, or NaN, at a dead point.
        """
        arithmetic, plan = Arrays(), self.path.motion.plan
        relations = self.frames.relations
        equations = [relation.equations() for relation in relations]
        with arithmetic.context():
            sides = [relation.velocity_side() for relation in relations]
            rates = run_steps(plan, equations, sides, arithmetic)
            sides = [relation.acceleration_side(rates) for relation in relations]
            changes = run_steps(plan, equations, sides, arithmetic)
        return Motion(self.frames, plan, rates, changes)


@dataclass(frozen=True)
class Still:
    """A mechanism that has no path, for this `reason`."""

    reason: Problem


def find_path(motion: Motion) -> MotionPath | Still:
    """The path of a motion, of any arithmetic; what stays as it is says why."""
    doubles = motion.map(float)
    mechanism = motion.frames.mechanism.map(float)
    doubles = replace(doubles, frames=replace(doubles.frames, mechanism=mechanism))
    moved = find_input(doubles.frames)
    if moved is None:
        return Still(Message("motion.no-input"))
    system = System(doubles.frames, moved, tuple(doubles.rates))
    try:
        return MotionPath(doubles, system, trace_path(system))
    except MechanismError as error:
        return Still(error.faults[0])
