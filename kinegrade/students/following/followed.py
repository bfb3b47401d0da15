"""The motion that follows from a student's values: the rest of the plan uses them, in doubles.

A student's value replaces a result of the plan: the one rate (or change of a rate) by which a step
determines it, the velocity or acceleration of a point, or a Coriolis or normal part. It is
substituted right after the step by which it is first determined; the other results of that step
stay, and all later steps use it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan, Step
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.following.followed_terms import (
    FollowedReading,
    Place,
    Share,
    make_offsets,
    read_to_follow,
    write_relations,
)
from kinegrade.students.following.substituting import (
    NOTHING,
    SAME,
    OwnValue,
    measure,
    measure_slope,
    move_to_value,
)
from kinegrade.students.unsuspecting import Unsuspecting

_NEARBY = 1e-3  # relative: how far a number is changed to see what depends on it


def follow_values(
    frames: Frames, plan: Plan, values: Sequence[OwnValue], arithmetic: Arithmetic
) -> Motion:
    """The motion with the student's values substituted; a value that cannot be is left out, and the
    motion is as without it.

    Raises Singular where a step determines nothing.
    """
    places = tuple(dict.fromkeys(value.place for value in values if value.place))
    reading = read_to_follow(frames, plan, places)
    relations = write_relations(frames, plan, reading)
    none = {rate: 0.0 for place in places for rate in make_offsets(place)}
    motion = Motion(frames, plan, none, none, reading)
    equations = [relation.equations() for relation in relations]
    solver = Unsuspecting(arithmetic)
    sides = [relation.velocity_side() for relation in relations]
    run = _Run(motion, "velocity", relations, equations, sides, solver)
    motion = run.follow([value for value in values if value.level == "velocity"])
    accelerations = [value for value in values if value.level == "acceleration"]
    motion = _put_in_parts(motion, reading, [value for value in accelerations if value.part])
    sides = [relation.acceleration_side(motion.rates, motion.reading) for relation in relations]
    run = _Run(motion, "acceleration", relations, equations, sides, solver)
    return run.follow([value for value in accelerations if not value.part])


def _put_in_parts(motion: Motion, reading: FollowedReading, values: Iterable[OwnValue]) -> Motion:
    """The motion with the values of Coriolis and normal parts, which the velocities decide."""

    def take(shares: Mapping[Share, Number]) -> Motion:
        return replace(motion, reading=replace(reading, shares=shares))

    shares: Mapping[Share, Number] = {}
    for value in values:
        if value.part:
            open_shares = {value.part: 1.0, **shares}
            shares = move_to_value(take, value, open_shares, {value.part: _NEARBY})
    return take(shares)


@dataclass(frozen=True)
class _Run:
    """A run of a plan for velocities or accelerations, from a motion in which they are not known
    yet; `sides` are the right-hand sides of the relations.
    """

    motion: Motion
    level: Level
    relations: Sequence[Relation]
    equations: plans.Equations
    sides: Sequence[Sequence[Number]]
    solver: Unsuspecting

    def follow(self, values: Iterable[OwnValue]) -> Motion:
        """The motion found step by step, with each student's value substituted as soon as it is
        determined. Raises Singular.
        """
        found, waiting = self._known, list(values)
        for step in self.motion.plan.steps:
            if step.unknowns:
                solved = plans.solve_step(step, self.equations, self.sides, found, self.solver)
                found = {**found, **solved}
            motion = self._take(found)
            ready = [value for value in waiting if value.read(motion) is not None]
            waiting = [value for value in waiting if value not in ready]
            for value in ready:
                found = self._put_in(value, found, step)
        return self._take(found)

    @property
    def _known(self) -> Rates:
        """The rates, or their changes, that are known before the first step."""
        match self.level:
            case "velocity":
                return self.motion.rates
            case "acceleration":
                return self.motion.changes
            case _:
                assert_never(self.level)

    def _take(self, found: Rates) -> Motion:
        """The motion with the rates, or the changes, that are found."""
        motion = self.motion
        match self.level:
            case "velocity":
                return Motion(motion.frames, motion.plan, found, motion.changes, motion.reading)
            case "acceleration":
                return Motion(motion.frames, motion.plan, motion.rates, found, motion.reading)
            case _:
                assert_never(self.level)

    def _put_in(self, wanted: OwnValue, found: Rates, step: Step) -> Rates:
        """What is found, with a student's value substituted for what the step determines it by."""
        rate = None if self._is_given(step) else self._one_rate(wanted, found, step)
        if rate is not None:
            return move_to_value(self._take, wanted, found, {rate: _choose_reach(found, rate)})
        if not wanted.place:
            return found
        reach = _NEARBY * max(map(abs, self._read_vector(wanted.place, found)))
        return move_to_value(
            self._take, wanted, found, dict.fromkeys(make_offsets(wanted.place), reach)
        )

    def _read_vector(self, place: Place, found: Rates) -> Vector:
        """The velocity or acceleration of a point."""
        body, point = place
        motion = self._take(found)
        match self.level:
            case "velocity":
                return motion.velocity(point, body)
            case "acceleration":
                return motion.acceleration(point, body)
            case _:
                assert_never(self.level)

    def _one_rate(self, wanted: OwnValue, found: Rates, step: Step) -> Rate | None:
        """The one rate of the step that the student's value depends on; for a point only if no
        other rate moves it.
        """
        if wanted.place and not self._moves_by_one(wanted.place):
            return None
        now = measure(wanted, self._take(found))
        reaches = {rate: _choose_reach(found, rate) for rate in step.unknowns}
        rates = [
            rate
            for rate, reach in reaches.items()
            if abs(measure_slope(self._take, wanted, found, rate, reach)) * reach
            > NOTHING * abs(now)
        ]
        if len(rates) != 1:
            return None
        without = measure(wanted, self._take({**found, rates[0]: 0.0})) if wanted.place else 0.0
        return None if abs(without) > SAME * abs(now) else rates[0]

    def _moves_by_one(self, place: Place) -> bool:
        """Whether one rate alone determines the motion of a point."""
        added = make_offsets(place)
        return sum(term.rate not in added for term in self.motion.chain(*place)) == 1

    def _is_given(self, step: Step) -> bool:
        """Whether a step only states what is given."""
        laws = (self.relations[index].source for index in step.relations)
        return all(law is not None and law.is_given for law in laws)


def _choose_reach(found: Rates, rate: Rate) -> float:
    """How far to change a rate to see what depends on it."""
    return _NEARBY * float(abs(found[rate]) or max(map(abs, found.values())) or 1.0)
