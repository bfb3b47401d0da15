"""Rods: bodies whose turning is found together with the velocity of one point, from that of
another.

What students take for a rod's angular velocity where they do not add up velocities, or not those
that are there. `misjudged_steps` puts it in place of what a step of the plan finds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.mistaking.unsuspecting import Unsuspecting

Replacements = Iterator[tuple[Rate, Number]]


@dataclass(frozen=True)
class Rod:
    """A body whose point `near` has a velocity that is `known` when the rate of the `end` is found,
    by which its point `far` moves, together with its own turning.

    `rotation` is the term of that turning; the motion to which it leads is also that of the chain
    `met`.
    """

    rotation: Term
    known: Chain
    end: Term
    met: Chain
    near: Vector
    far: Vector

    @property
    def pivot(self) -> Vector | None:
        """The fixed point about which the end runs, m; None on a straight path, and where the known
        end turns about none.
        """
        turns = self.end.kind != "sliding" and self.known[-1].kind == "rotation"
        return self.far - self.end.vector if turns else None


def find_rods(frames: Frames, plan: Plan) -> Iterator[Rod]:
    """The rods of a mechanism, in the order in which the plan finds their rates."""
    for step in plan.steps:
        for relation in (frames.relations[index] for index in step.relations):
            if relation.is_vector:
                yield from _find_rods_in(relation, step.unknowns, frames)


def _find_rods_in(relation: Relation, unknowns: Sequence[Rate], frames: Frames) -> Iterator[Rod]:
    """The rods of a vector relation whose step finds these rates."""
    for side, met in ((relation.left, relation.right), (relation.right, relation.left)):
        if len(side) < 2 or side[-1].kind != "rotation" or side[-1].rate not in unknowns:
            continue
        *base, rotation = side
        start, tip = (frames.mechanism.points[name] for name in (rotation.base, rotation.point))
        for known, ends, near, far in ((tuple(base), met, start, tip), (met, base, tip, start)):
            is_known = known and not any(term.rate in unknowns for term in known)
            on_ground = [end for end in ends if end.rate in unknowns and end.frame == GROUND]
            if is_known and len(ends) == len(on_ground) == 1:
                yield Rod(rotation, known, ends[0], met, near, far)


@dataclass(frozen=True)
class MisjudgedRod:
    """What the rates of a rod, rad/s and m/s, are taken for, given those that are right."""

    rod: Rod
    rates: Rates
    arithmetic: Arithmetic

    def turn_with_neighbour(self) -> Replacements:
        """It turns as the body does whose motion its known end has."""
        last = self.rod.known[-1]
        if last.kind == "rotation":
            yield self.rod.rotation.rate, self.rates[last.rate]

    def turn_about_end(self) -> Replacements:
        """It turns about its other end, which is taken for its pole."""
        yield self._take(self.rod.rotation.rate, self._measure(self._speed) / self._length)

    def turn_about_pivot(self) -> Replacements:
        """It turns about the fixed pivot of its other end's body, together with that body."""
        if self.rod.pivot is not None:
            turning = self._measure(self._speed) / self._measure(self.rod.pivot - self.rod.near)
            yield self._take(self.rod.rotation.rate, turning)
            yield self._take(self.rod.end.rate, turning)

    def translate(self) -> Replacements:
        """It does not turn: both ends are as fast as each other."""
        yield self.rod.rotation.rate, self.rates[self.rod.rotation.rate] * 0
        along = self._measure(self.rod.end.coefficient())
        yield self._take(self.rod.end.rate, self._measure(self._speed) / along)

    def turn_on_velocities(self) -> Replacements:
        """It turns about the common point of the lines along its ends' velocities.

        For the velocity v of the near end, the direction d of the far one's and the arm r from the
        near end to the far one, the point is at v s from the near end, s = (r x d)/(v x d), and
        omega is v/(v s). Raises Singular where the far end moves along the rod.
        """
        arm, along, speed = self._arm, self.rod.end.coefficient(), self._speed
        below = arm.cross(along)
        for rate, above in (
            (self.rod.rotation.rate, speed.cross(along)),
            (self.rod.end.rate, arm.cross(speed)),
        ):
            yield self._take(rate, Unsuspecting(self.arithmetic).solve([[below]], [above])[0])

    @property
    def meeting(self) -> Vector:
        """The common point of the lines along the velocities of both ends, m. Raises Singular where
        they are parallel.
        """
        along, speed = self.rod.end.coefficient(), self._speed
        solver = Unsuspecting(self.arithmetic)
        (share,) = solver.solve([[speed.cross(along)]], [self._arm.cross(along)])
        return self.rod.near + speed * share

    @cached_property
    def _speed(self) -> Vector:
        """The velocity of the near end, m/s."""
        return add_vectors(term.velocity(self.rates) for term in self.rod.known)

    @property
    def _arm(self) -> Vector:
        return self.rod.far - self.rod.near

    @property
    def _length(self) -> Number:
        return self._measure(self._arm)

    def _measure(self, vector: Vector) -> Number:
        return self.arithmetic.magnitude(vector.x, vector.y)

    def _take(self, rate: Rate, size: Number) -> tuple[Rate, Number]:
        """A rate of that size, in its own sense."""
        sense: Number = self.arithmetic.sign(self.rates[rate])
        return rate, abs(size) * sense
