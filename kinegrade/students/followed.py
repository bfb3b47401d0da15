"""The motion that follows from a student's values: the rest of the plan uses them, in doubles.

A student's value replaces a result of the plan: the one rate (or change of a rate) by which a step
determines it, the velocity or acceleration of a point, or a Coriolis or normal part. It is
substituted right after the step by which it is first determined; the other results of that step
stay, and all later steps use it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.joints import Parallel
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan, Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Arithmetic
from kinegrade.students.followed_terms import (
    OwnFrames,
    Place,
    Share,
    make_offsets,
    open_frames,
    open_relations,
)
from kinegrade.students.mistaken import Unsuspecting

_NOTHING = 1e-12  # relative: anything smaller is rounding
_SAME = 1e-9  # relative: how near a reading must come to the student's value
_STRAIGHT = 1e-4  # relative: the largest miss of one step along a tangent, to be refined
_NEARBY = 1e-3  # relative: how far a number is changed to see what depends on it


@dataclass(frozen=True)
class FollowedMotion(Motion):
    """A motion while the student's values are substituted, and after; its rates and changes are
    those determined so far.
    """

    frames: OwnFrames

    def relative_velocity(self, point: str, body: str, frame: str) -> Vector:
        """Velocity of `point` of `body` relative to the moving body `frame`, m/s: as solved for, if
        it was.
        """
        term = self.frames.relative.get((point, frame))
        return term.velocity(self.rates) if term else super().relative_velocity(point, body, frame)

    def relative_acceleration(self, point: str, body: str, frame: str) -> Vector:
        """Acceleration of `point` of `body` relative to `frame`, m/s^2: as solved for, if it
        was.
        """
        term = self.frames.relative.get((point, frame))
        if term is None:
            return super().relative_acceleration(point, body, frame)
        tangential: Vector = term.coefficient() * self.changes[term.rate]
        return tangential + term.normal(self.rates)

    def coriolis(self, point: str, body: str, frame: str) -> Vector:
        """Coriolis acceleration of `point` of `body` relative to `frame`, m/s^2."""
        share = Share("coriolis", point, frame).find(self.rates)
        coriolis: Vector = super().coriolis(point, body, frame) * share
        return coriolis


@dataclass(frozen=True)
class OwnValue:
    """A student's value: `read` reads the quantity off a motion, `value` is the number that
    replaces it.

    `read` gives None where the motion does not determine the quantity yet. `place` is the body and
    point whose velocity or acceleration it is, `part` the share of a Coriolis or normal part; both
    None for angular and for relative motions.
    """

    read: Callable[[FollowedMotion], float | None]
    value: float
    level: Level
    place: Place | None = None
    part: Share | None = None


def follow_values(
    frames: Frames, plan: Plan, values: Sequence[OwnValue], arithmetic: Arithmetic
) -> FollowedMotion:
    """The motion with the student's values substituted; a value that cannot be is left out, and the
    motion is as without it.

    Raises Singular where a step determines nothing.
    """
    places = tuple(dict.fromkeys(value.place for value in values if value.place))
    extended = open_frames(frames, plan, places)
    rates, changes = (
        {name: 0.0 for place in places for name in make_offsets(place)} for _ in range(2)
    )
    run = _Run(
        FollowedMotion(extended, plan, rates, changes),
        open_relations(extended, plan),
        rates,
        changes,
        Unsuspecting(arithmetic),
    )
    run.velocities([value for value in values if value.level == "velocity"])
    accelerations = [value for value in values if value.level == "acceleration"]
    run.parts([value for value in accelerations if value.part])
    run.accelerations([value for value in accelerations if not value.part])
    return run.motion


@dataclass(frozen=True)
class _Run:
    """A run of a plan: the rates and changes found so far, which are also those of `motion`."""

    motion: FollowedMotion
    relations: Sequence[Relation]
    rates: dict[Any, Any]
    changes: dict[Any, Any]
    arithmetic: Unsuspecting

    @cached_property
    def equations(self) -> plans.Equations:
        """The coefficients of all relations."""
        return [relation.equations() for relation in self.relations]

    def velocities(self, values: Sequence[OwnValue]) -> None:
        """Follow the plan for velocities."""
        self._follow(self.rates, lambda index: self.relations[index].velocity_side(), values)

    def accelerations(self, values: Sequence[OwnValue]) -> None:
        """Follow the plan for accelerations."""
        self._follow(
            self.changes, lambda index: self.relations[index].acceleration_side(self.rates), values
        )

    def _follow(
        self,
        found: dict[Any, Any],
        right: Callable[[int], Sequence[Any]],
        values: Iterable[OwnValue],
    ) -> None:
        """Run step by step, substituting each student's value as soon as it is determined. Raises
        Singular.
        """
        waiting = list(values)
        for step in self.motion.plan.steps:
            if step.unknowns:
                sides = {
                    index: [
                        side - sum(row[rate] * found[rate] for rate in row if rate in found)
                        for row, side in zip(self.equations[index], right(index), strict=True)
                    ]
                    for index in step.relations
                }
                found.update(
                    plans.run_steps(
                        Plan((step,)), self.equations, sides.__getitem__, self.arithmetic
                    )
                )
            ready = [value for value in waiting if value.read(self.motion) is not None]
            waiting = [value for value in waiting if value not in ready]
            for value in ready:
                self._put_in(value, found, step)

    def parts(self, values: Iterable[OwnValue]) -> None:
        """Substitute the values of Coriolis and normal parts, which the velocities decide."""
        for value in values:
            self.rates.setdefault(value.part, 1.0)
            _move_rates(self.motion, value, self.rates, {value.part: _NEARBY})

    def _put_in(self, wanted: OwnValue, found: dict[Any, Any], step: Step) -> None:
        """Substitute a student's value for what the step determines it by."""
        rate = None if self._is_given(step) else self._one_rate(wanted, found, step)
        if rate is not None:
            _move_rates(self.motion, wanted, found, {rate: _choose_reach(found, rate)})
        elif wanted.place:
            body, point = wanted.place
            vector = (
                self.motion.velocity(point, body)
                if found is self.rates
                else self.motion.acceleration(point, body)
            )
            _move_rates(
                self.motion,
                wanted,
                found,
                dict.fromkeys(make_offsets(wanted.place), _NEARBY * max(map(abs, vector))),
            )

    def _one_rate(self, wanted: OwnValue, found: dict[Any, Any], step: Step) -> Rate | None:
        """The one rate of the step that the student's value depends on; for a point only if no
        other rate moves it.
        """
        if wanted.place and not self._moves_by_one(wanted.place):
            return None
        now = abs(wanted.read(self.motion) or 0.0)
        rates = [
            rate
            for rate in step.unknowns
            if abs(_measure_slope(self.motion, wanted, found, rate, _choose_reach(found, rate)))
            * _choose_reach(found, rate)
            > _NOTHING * now
        ]
        if len(rates) != 1 or (
            wanted.place and self.without(wanted, found, rates[0]) > _SAME * now
        ):
            return None
        return rates[0]

    def _moves_by_one(self, place: Place) -> bool:
        """Whether one rate alone determines the motion of a point."""
        added = make_offsets(place)
        return sum(term.rate not in added for term in self.motion.frames.chain(*place)) == 1

    def without(self, wanted: OwnValue, found: dict[Any, Any], rate: Rate) -> float:
        """The absolute value of the student's quantity with a rate set to zero."""
        kept, found[rate] = found[rate], 0.0
        size = abs(wanted.read(self.motion) or 0.0)
        found[rate] = kept
        return size

    def _is_given(self, step: Step) -> bool:
        """Whether a step only states what is given."""
        sources = (self.relations[index].source for index in step.relations)
        return all(
            isinstance(source, (Rotation, Component, Circulation, Parallel)) for source in sources
        )


def _choose_reach(found: dict[Any, Any], rate: Rate) -> float:
    """How far to change a rate to see what depends on it."""
    return _NEARBY * float(abs(found[rate]) or max(map(abs, found.values())) or 1.0)


def _measure_slope(
    motion: FollowedMotion, wanted: OwnValue, found: dict[Any, Any], rate: Rate, reach: float
) -> float:
    """The derivative of the student's quantity with respect to a rate."""
    kept = found[rate]
    found[rate] = kept + reach
    above = wanted.read(motion) or 0.0
    found[rate] = kept - reach
    below = wanted.read(motion) or 0.0
    found[rate] = kept
    return (above - below) / (2 * reach) if reach else 0.0


def _move_rates(
    motion: FollowedMotion, wanted: OwnValue, found: dict[Any, Any], reaches: dict[Any, float]
) -> None:
    """Change some rates, by as little as possible, so that the student's quantity has the student's
    value.

    They stay unchanged where the quantity is not linear in them: an angle, or a magnitude that
    cannot be negative.
    """
    kept = {rate: found[rate] for rate in reaches}
    start = wanted.read(motion) or 0.0
    for tolerance in (_STRAIGHT, _SAME, _SAME):
        missing = wanted.value - (wanted.read(motion) or 0.0)
        if not abs(missing) > _NOTHING * abs(wanted.value):
            return
        slopes = {
            rate: _measure_slope(motion, wanted, found, rate, reach)
            for rate, reach in reaches.items()
        }
        steepness = sum(each * each for each in slopes.values())
        if steepness:
            found.update(
                {rate: found[rate] + missing * each / steepness for rate, each in slopes.items()}
            )
        if not abs(wanted.value - (wanted.read(motion) or 0.0)) <= tolerance * abs(
            wanted.value - start
        ):
            found.update(kept)
            return
