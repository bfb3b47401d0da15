"""The equations that a student's value may contradict, and how the motion moves without each.

The equations of a mechanism determine all of its rates; a student's value contradicts them. One of
them is left out then, and all others hold: which one is open. A vector equation is left out in one
direction, as if it had been projected across it: the direction of an unknown term, the one across
it, or an axis. That a base point moves as the step before found it is an equation too; without it
a body turns about its pole, faster or more slowly. So is what is given: without it all velocities
keep their proportions, which students read off a figure with poles.

Equations are linear in the rates, so that without one of them all rates move along a straight line.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan, Step
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles
from kinegrade.numbers.number import Number
from kinegrade.students.following.followed_terms import (
    FollowedReading,
    Place,
    find_detours,
    read_to_follow,
    write_relations,
)
from kinegrade.students.mistaking.unsuspecting import Unsuspecting

_SAME = 1e-9  # relative: what differs by less is the same direction
_AXES = (Vector(1.0, 0.0), Vector(0.0, 1.0))
Response = Mapping[Rate, float]  # how fast each rate moves
_Sides = Sequence[Sequence[Number]]


@dataclass(frozen=True)
class Equations:
    """The relations of a mechanism as they are written at the steps of its plan, in doubles."""

    frames: Frames
    plan: Plan
    reading: FollowedReading
    relations: Sequence[Relation]

    @cached_property
    def _rows(self) -> plans.Equations:
        """The coefficients of the rates."""
        return [relation.equations() for relation in self.relations]

    @cached_property
    def _offsets(self) -> Rates:
        """No addition to the motion of any point."""
        return dict.fromkeys(self.reading.offsets, 0.0)

    def solve_velocities(self) -> Motion:
        """The motion of which only the velocities are known. Raises Singular."""
        rates = self._solve([relation.velocity_side() for relation in self.relations])
        return Motion(self.frames, self.plan, rates, {}, self.reading)

    def solve_accelerations(self, motion: Motion) -> Motion:
        """The motion with the accelerations that its velocities lead to. Raises Singular."""
        sides = [
            relation.acceleration_side(motion.rates, motion.reading) for relation in self.relations
        ]
        return Motion(self.frames, self.plan, motion.rates, self._solve(sides), motion.reading)

    def _solve(self, sides: _Sides, offsets: Rates | None = None) -> Rates:
        """All rates from the right-hand sides of the relations."""
        found: dict[Rate, Number] = {**self._offsets, **(offsets or {})}
        solver = Unsuspecting(Doubles())
        for step in self.plan.steps:
            if step.unknowns:
                found.update(plans.solve_step(step, self._rows, sides, found, solver))
        return found

    @cached_property
    def left_out(self) -> tuple[Response, ...]:
        """How the rates move where a relation is left out, for velocities and accelerations."""
        return _drop_alike(self._leave_out())

    def _leave_out(self) -> Iterator[Rates]:
        """For each relation and each of its directions."""
        none: list[list[Number]] = [[0.0] * len(rows) for rows in self._rows]
        for step in self.plan.steps:
            for index in step.relations if step.unknowns else ():
                for side in self._find_directions(index, step):
                    yield self._solve([*none[:index], side, *none[index + 1 :]])

    def _find_directions(self, index: int, step: Step) -> Iterable[Sequence[float]]:
        """The right-hand sides with which a relation may be left out."""
        if not self.relations[index].is_vector:
            return ([1.0],)
        x, y = self._rows[index]
        terms = [Vector(x[rate], y[rate]) for rate in step.unknowns if rate in x]
        return [*_AXES, *terms, *(term.turned() for term in terms)]

    def move_point(self, place: Place, direction: Vector) -> Response:
        """How the rates move where a point gets an addition to its motion in a direction."""
        offsets = dict(zip(self.reading.find_offsets(place), direction, strict=True))
        moved = self._solve([[0.0] * len(rows) for rows in self._rows], offsets)
        return {rate: float(number) for rate, number in moved.items()}

    @cached_property
    def poles(self) -> tuple[Response, ...]:
        """How the rates move where a base point moves faster or more slowly along its path."""
        return _drop_alike(self._move_bases())

    def _move_bases(self) -> Iterator[Rates]:
        """For the base points of all bodies that move."""
        motion = self.right
        for body, base in self.frames.bases.items():
            velocity = motion.velocity(base.point, body)
            if base.chain and velocity.squared():
                yield self.move_point((body, base.point), velocity)

    @cached_property
    def by_detours(self) -> Equations:
        """The same, points of bodies being read about another point than the base."""
        return replace(self, reading=replace(self.reading, detours=find_detours(self.frames)))

    @cached_property
    def right(self) -> Motion:
        """The velocities as they are."""
        return self.solve_velocities()


def state_equations(frames: Frames, plan: Plan, places: Sequence[Place]) -> Equations:
    """The equations of a mechanism in doubles, of which students may have the velocities and
    accelerations of the points at `places` and of the bodies' base points.
    """
    bases = [(body, base.point) for body, base in frames.bases.items()]
    reading = read_to_follow(frames, plan, [*places, *bases])
    return Equations(frames, plan, reading, write_relations(frames, plan, reading))


def _drop_alike(responses: Iterable[Rates]) -> tuple[Response, ...]:
    """The responses, each once: those that differ by a factor alone are one."""
    found: list[Response] = []
    for response in responses:
        numbers = {rate: float(number) for rate, number in response.items()}
        size = max(map(abs, numbers.values()), default=0.0)
        unit = {rate: number / size for rate, number in numbers.items()} if size else {}
        if unit and not any(_is_same(unit, other, sign) for other in found for sign in (1, -1)):
            found.append(unit)
    return tuple(found)


def _is_same(one: Response, other: Response, sign: int) -> bool:
    """Whether two responses of size one agree, except for a sign."""
    return all(abs(number - sign * other[rate]) <= _SAME for rate, number in one.items())
