"""The motion that follows from somebody's own values: the plan runs on after them, in doubles.

An own value stands in place of what the plan has found: of the one rate (or change of a rate) that
a step determines it by, of the velocity or acceleration of a point, or of a Coriolis or normal
part. It is put in right after the step by which it is first determined; what that step found
besides stays, and all later steps run on with it.
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
from kinegrade.mechanics.mistaken import Unsuspecting
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.own_terms import (
    OwnFrames,
    Place,
    coriolis_share,
    offsets,
    own_frames,
    own_relations,
)
from kinegrade.mechanics.plan import Plan, Step
from kinegrade.mechanics.relations import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level

NOTHING = 1e-12  # relative: what is smaller is rounding
SAME = 1e-9  # relative: how near a reading must come to the own value
STRAIGHT = (
    1e-4  # relative: how far one step along a tangent may end from the own value, to be polished
)
NEARBY = 1e-3  # relative: how far one goes from a number to see what depends on it


@dataclass(frozen=True)
class FollowedMotion(Motion):
    """A motion while own values are put in, and after; its rates and changes hold what is
    determined so far.
    """

    frames: OwnFrames

    def relative_velocity(self, point: str, body: str, frame: str) -> Vector:
        """Velocity of `point` of `body` seen from the moving body `frame`, m/s: as it was solved
        for, if it was.
        """
        term = self.frames.relative.get((point, frame))
        return term.velocity(self.rates) if term else super().relative_velocity(point, body, frame)

    def relative_acceleration(self, point: str, body: str, frame: str) -> Vector:
        """Acceleration of `point` of `body` seen from `frame`, m/s^2: as it was solved for, if it
        was.
        """
        term = self.frames.relative.get((point, frame))
        if term is None:
            return super().relative_acceleration(point, body, frame)
        tangential: Vector = term.coefficient() * self.changes[term.rate]
        return tangential + term.normal(self.rates)

    def coriolis(self, point: str, body: str, frame: str) -> Vector:
        """Coriolis acceleration of `point` of `body` seen from `frame`, m/s^2."""
        coriolis: Vector = super().coriolis(point, body, frame) * self.share(
            coriolis_share(point, frame)
        )
        return coriolis

    def share(self, name: str) -> float:
        """What is taken of a Coriolis or normal part: all of it, where nobody has put in an own
        one.
        """
        return float(self.rates.get(name, 1.0))


@dataclass(frozen=True)
class OwnValue:
    """A number that somebody has: `read` reads the quantity off a motion, `value` is what stands in
    its place.

    `read` gives None where the motion does not determine the quantity yet. `place` is the body and
    point of whose velocity or acceleration it is, `part` the name of the Coriolis or normal part
    that it is of; both None for angular and for relative motions.
    """

    read: Callable[[FollowedMotion], float | None]
    value: float
    level: Level
    place: Place | None = None
    part: str | None = None


def followed(
    frames: Frames, plan: Plan, own: Sequence[OwnValue], arithmetic: Any
) -> FollowedMotion:
    """The motion with the own values put in; one that cannot be is left out, and the motion is as
    without it.

    Raises Singular where a step determines nothing.
    """
    places = tuple(dict.fromkeys(value.place for value in own if value.place))
    ours = own_frames(frames, plan, places)
    rates, changes = ({name: 0.0 for place in places for name in offsets(place)} for _ in range(2))
    run = Run(
        FollowedMotion(ours, plan, rates, changes),
        own_relations(ours, plan),
        rates,
        changes,
        Unsuspecting(arithmetic),
    )
    run.velocities([value for value in own if value.level == "velocity"])
    accelerations = [value for value in own if value.level == "acceleration"]
    run.parts([value for value in accelerations if value.part])
    run.accelerations([value for value in accelerations if not value.part])
    return run.motion


@dataclass(frozen=True)
class Run:
    """A plan on its way: the rates and changes found so far, which are also those of `motion`."""

    motion: FollowedMotion
    relations: Sequence[Relation]
    rates: dict[str, Any]
    changes: dict[str, Any]
    arithmetic: Unsuspecting

    @cached_property
    def equations(self) -> plans.Equations:
        """The coefficients of all relations."""
        return [relation.equations() for relation in self.relations]

    def velocities(self, own: Sequence[OwnValue]) -> None:
        """Follow the plan for velocities."""
        self.follow(self.rates, lambda index: self.relations[index].velocity_side(), own)

    def accelerations(self, own: Sequence[OwnValue]) -> None:
        """Follow the plan for accelerations."""
        self.follow(
            self.changes, lambda index: self.relations[index].acceleration_side(self.rates), own
        )

    def follow(
        self, found: dict[str, Any], right: Callable[[int], Sequence[Any]], own: Iterable[OwnValue]
    ) -> None:
        """Step by step, with each own value put in as soon as it is determined. Raises Singular."""
        waiting = list(own)
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
                    plans.run(Plan((step,)), self.equations, sides.__getitem__, self.arithmetic)
                )
            ready = [value for value in waiting if value.read(self.motion) is not None]
            waiting = [value for value in waiting if value not in ready]
            for value in ready:
                self.put_in(value, found, step)

    def parts(self, own: Iterable[OwnValue]) -> None:
        """Put in what is read off Coriolis and normal parts, which the velocities decide."""
        for value in own:
            self.rates.setdefault(str(value.part), 1.0)
            move(self.motion, value, self.rates, {str(value.part): NEARBY})

    def put_in(self, own: OwnValue, found: dict[str, Any], step: Step) -> None:
        """Put an own value in place of what the step determines it by."""
        rate = None if self.is_given(step) else self.one_rate(own, found, step)
        if rate is not None:
            move(self.motion, own, found, {rate: reach(found, rate)})
        elif own.place:
            body, point = own.place
            vector = (
                self.motion.velocity(point, body)
                if found is self.rates
                else self.motion.acceleration(point, body)
            )
            move(
                self.motion,
                own,
                found,
                dict.fromkeys(offsets(own.place), NEARBY * max(map(abs, vector))),
            )

    def one_rate(self, own: OwnValue, found: dict[str, Any], step: Step) -> str | None:
        """The one rate of the step that the own value depends on; of a point only where the point
        moves by it alone.
        """
        if own.place and not self.moves_by_one(own.place):
            return None
        now = abs(own.read(self.motion) or 0.0)
        rates = [
            rate
            for rate in step.unknowns
            if abs(slope(self.motion, own, found, rate, reach(found, rate))) * reach(found, rate)
            > NOTHING * now
        ]
        if len(rates) != 1 or (own.place and self.without(own, found, rates[0]) > SAME * now):
            return None
        return rates[0]

    def moves_by_one(self, place: Place) -> bool:
        """Whether one rate alone is the motion of a point."""
        added = offsets(place)
        return sum(term.rate not in added for term in self.motion.frames.chain(*place)) == 1

    def without(self, own: OwnValue, found: dict[str, Any], rate: str) -> float:
        """The size that the own quantity has where a rate is zero."""
        kept, found[rate] = found[rate], 0.0
        size = abs(own.read(self.motion) or 0.0)
        found[rate] = kept
        return size

    def is_given(self, step: Step) -> bool:
        """Whether a step says no more than what is given."""
        sources = (self.relations[index].source for index in step.relations)
        return all(
            isinstance(source, (Rotation, Component, Circulation, Parallel)) for source in sources
        )


def reach(found: dict[str, Any], rate: str) -> float:
    """How far to go from a rate to see what depends on it."""
    return NEARBY * float(abs(found[rate]) or max(map(abs, found.values())) or 1.0)


def slope(
    motion: FollowedMotion, own: OwnValue, found: dict[str, Any], rate: str, reach: float
) -> float:
    """By how much the own quantity changes with a rate."""
    kept = found[rate]
    found[rate] = kept + reach
    above = own.read(motion) or 0.0
    found[rate] = kept - reach
    below = own.read(motion) or 0.0
    found[rate] = kept
    return (above - below) / (2 * reach) if reach else 0.0


def move(
    motion: FollowedMotion, own: OwnValue, found: dict[str, Any], reaches: dict[str, float]
) -> None:
    """Change some rates, by as little as it takes, so that the own quantity has the own value.

    They stay as they were where that is no straight way: an angle, a magnitude that cannot be
    negative.
    """
    kept = {rate: found[rate] for rate in reaches}
    start = own.read(motion) or 0.0
    for tolerance in (STRAIGHT, SAME, SAME):
        missing = own.value - (own.read(motion) or 0.0)
        if not abs(missing) > NOTHING * abs(own.value):
            return
        slopes = {rate: slope(motion, own, found, rate, reach) for rate, reach in reaches.items()}
        steepness = sum(each * each for each in slopes.values())
        if steepness:
            found.update(
                {rate: found[rate] + missing * each / steepness for rate, each in slopes.items()}
            )
        if not abs(own.value - (own.read(motion) or 0.0)) <= tolerance * abs(own.value - start):
            found.update(kept)
            return
