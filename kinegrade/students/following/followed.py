"""The motions that may follow from a student's values, in doubles.

A student's value contradicts the equations of the mechanism, so one of them is left out
(`departures`), and the motion moves until the value is what is read off it. Each equation that may
be left out is one way of going on. Velocities come first; accelerations are solved again from them,
and then the student's values among them are put in likewise. A Coriolis or normal part is taken as
the student has it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from typing import assert_never

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.students.following.departures import Equations, Response
from kinegrade.students.following.followed_terms import Share
from kinegrade.students.following.own_values import OwnValue

_NEARBY = 1e-3  # relative: how far rates are changed to see what depends on them
_MOST = 100  # ways of going on from several values


def follow_values(equations: Equations, values: Sequence[OwnValue]) -> Iterator[Motion]:
    """The motions in which the student's values are read, one for each way of going on, and for
    each of two ways of reading a point: by the shorter chain, or by that of its body. A value that
    cannot be put in is left out. Raises Singular where a step determines nothing.
    """
    velocities = [value for value in values if value.level == "velocity"]
    accelerations = [value for value in values if value.level == "acceleration" and not value.part]
    moved = _Ways(equations, "velocity").follow_all(equations.right, velocities)
    for motion in islice(moved, _MOST):
        reading = replace(equations.reading, shares=_find_shares(motion, values))
        solved = equations.solve_accelerations(replace(motion, reading=reading))
        ways = _Ways(equations, "acceleration").follow_all(solved, accelerations)
        for each in islice(ways, _MOST):
            yield each
            yield replace(each, reading=replace(reading, shortcuts=()))


def _find_shares(motion: Motion, values: Sequence[OwnValue]) -> Mapping[Share, float]:
    """What is taken of Coriolis and normal parts, which the velocities decide."""
    shares = {}
    for value in values:
        now = value.read(motion) if value.part else None
        if value.part and now:
            shares[value.part] = value.value / now
    return shares


@dataclass(frozen=True)
class _Ways:
    """The ways of putting values into the velocities or the accelerations of a motion."""

    equations: Equations
    level: Level

    def follow_all(self, motion: Motion, values: Sequence[OwnValue]) -> Iterator[Motion]:
        """The motions with all values that can be put in, in the order of the plan: one that
        another follows from goes first.
        """
        if len(values) > 1:
            values = sorted(values, key=lambda value: self._find_step(motion, value))
        return self._follow(motion, values)

    def _find_step(self, motion: Motion, value: OwnValue) -> int:
        """The number of steps of the plan that determine a value."""
        rates = self._get_rates(motion)
        known = dict.fromkeys(self.equations.reading.offsets, 0.0)
        for number, step in enumerate(self.equations.plan.steps):
            if value.read(self._put(motion, known)) is not None:
                return number
            known |= {rate: float(rates[rate]) for rate in step.unknowns}
        return len(self.equations.plan.steps)

    def _follow(
        self, motion: Motion, values: Sequence[OwnValue], kept: Sequence[OwnValue] = ()
    ) -> Iterator[Motion]:
        """The motions with all values that can be put in; `kept` are in the motion already."""
        if not values:
            yield motion
            return
        value, *rest = values
        ways = [motion] if value.is_read(motion) else self._move(motion, value, kept)
        for moved in ways or [motion]:
            yield from self._follow(moved, rest, (*kept, value) if ways else kept)

    def _move(self, motion: Motion, value: OwnValue, kept: Sequence[OwnValue]) -> list[Motion]:
        """The motions with one more value, in which those before it still are."""
        now = value.read(motion) or 0.0
        moved = [
            self._move_along(motion, value, now, response)
            for response in self._list_responses(motion, value)
        ]
        return [each for each in moved if each and all(old.is_kept(each) for old in kept)]

    def _list_responses(self, motion: Motion, value: OwnValue) -> Iterator[Response]:
        """How the rates move where an equation is left out."""
        yield from self.equations.left_out
        slopes = [self._find_slope(motion, value, rate) for rate in self._offsets(value)]
        if value.place and any(slopes):
            yield self.equations.move_point(value.place, Vector(*slopes))
        match self.level:
            case "velocity":
                yield from self.equations.poles
            case "acceleration":
                pass  # a pole is one of velocities
            case _:
                assert_never(self.level)

    def _offsets(self, value: OwnValue) -> Sequence[Rate]:
        """The rates of the additions to the motion of the value's own point."""
        return self.equations.reading.find_offsets(value.place) if value.place else ()

    def _find_slope(self, motion: Motion, value: OwnValue, rate: Rate) -> float:
        """How a value changes with an addition to the motion of its own point."""
        near = self._choose_near(motion, {rate: 1.0})
        above, below = (
            value.read(self._take(motion, {rate: 1.0}, way)) or 0.0 for way in (near, -near)
        )
        return (above - below) / near

    def _move_along(
        self, motion: Motion, value: OwnValue, now: float, response: Response
    ) -> Motion | None:
        """The motion with a value, which is `now` another one, found along a response; None where
        it is not to be had there.
        """
        move = partial(self._take, motion, response)
        distance = value.find_distance(now, move, self._choose_near(motion, response))
        return None if distance is None else move(distance)

    def _choose_near(self, motion: Motion, response: Response) -> float:
        """A short way along a response."""
        rates = self._get_rates(motion)
        largest = max(abs(float(rate)) for rate in rates.values())
        return _NEARBY * (largest or 1.0) / max(map(abs, response.values()))

    def _get_rates(self, motion: Motion) -> Rates:
        """The rates, or their changes."""
        match self.level:
            case "velocity":
                return motion.rates
            case "acceleration":
                return motion.changes
            case _:
                assert_never(self.level)

    def _take(self, motion: Motion, response: Response, way: float) -> Motion:
        """The motion with its rates, or their changes, some way along a response."""
        moved = {
            rate: number + way * response.get(rate, 0.0)
            for rate, number in self._get_rates(motion).items()
        }
        return self._put(motion, moved)

    def _put(self, motion: Motion, rates: Rates) -> Motion:
        """The motion with other rates, or changes of them."""
        match self.level:
            case "velocity":
                found = rates, motion.changes
            case "acceleration":
                found = motion.rates, rates
            case _:
                assert_never(self.level)
        # Not `replace`, which takes as long as the rest of a step
        return Motion(motion.frames, motion.plan, *found, motion.reading)
