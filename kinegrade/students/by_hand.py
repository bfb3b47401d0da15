"""A motion worked out by hand: the plan is followed, and each term and each solved rate is written
down rounded.

The contribution of a term is found from rounded arms and rates and rounded again, as it stands in
the table of a vector equation: the arm, the velocity, the normal, tangential and Coriolis parts of
the acceleration.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Base, Frames, build_chain
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rates
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.rounding import Rounded


@dataclass(frozen=True)
class WrittenTerm(Term):
    """A term whose vectors are written down."""

    rounded: Rounded = field(kw_only=True)

    def velocity(self, rates: Rates) -> Vector:
        """The term's velocity as it is written down, m/s."""
        return write_down(super().velocity(rates), self.rounded)

    def normal(self, rates: Rates) -> Vector:
        """The centripetal part of its acceleration as it is written down, m/s^2."""
        return write_down(super().normal(rates), self.rounded)

    def coriolis(self, rates: Rates) -> Vector:
        """The Coriolis part of its acceleration as it is written down, m/s^2."""
        return write_down(super().coriolis(rates), self.rounded)

    def acceleration(self, rates: Rates, changes: Rates) -> Vector:
        """The term's acceleration, m/s^2: the sum of its written parts."""
        return self.in_frame(rates, changes) + self.coriolis(rates)

    def in_frame(self, rates: Rates, changes: Rates) -> Vector:
        """The acceleration relative to the frame, m/s^2: the written normal and tangential
        parts.
        """
        tangential: Vector = self.coefficient() * changes[self.rate]
        return self.normal(rates) + write_down(tangential, self.rounded)


@dataclass(frozen=True)
class _WrittenFrames(Frames):
    """Chains and relations whose terms are written down."""

    rounded: Rounded = field(kw_only=True)

    def chain(self, body: str, point: str) -> Chain:
        """The written terms whose sum is the velocity of `point`, taken as a point of `body`."""
        return _write_chain(build_chain(self.mechanism, self.bases, body, point), self.rounded)

    @cached_property
    def relative(self) -> dict[tuple[str, str], WrittenTerm]:
        """The relative motions that the plan solves for: of a point relative to a body."""
        return {(term.point, term.frame): term for term in self.terms()}

    def terms(self) -> Iterator[WrittenTerm]:
        """All terms of relations and bases."""
        chains = [side for relation in self.relations for side in (relation.left, relation.right)]
        for terms in (*chains, *(base.chain for base in self.bases.values())):
            yield from (
                term for term in terms if isinstance(term, WrittenTerm) and term.kind != "rotation"
            )


@dataclass(frozen=True)
class _WrittenMotion(Motion):
    """A motion by hand: a relative motion that was solved for is not found again as a
    difference.
    """

    frames: _WrittenFrames

    def relative_velocity(self, point: str, body: str, frame: str) -> Vector:
        """Velocity of `point` of `body` relative to the moving body `frame`, m/s."""
        term = self.frames.relative.get((point, frame))
        return term.velocity(self.rates) if term else super().relative_velocity(point, body, frame)

    def relative_acceleration(self, point: str, body: str, frame: str) -> Vector:
        """Acceleration of `point` of `body` relative to `frame`, m/s^2."""
        term = self.frames.relative.get((point, frame))
        return (
            term.in_frame(self.rates, self.changes)
            if term
            else super().relative_acceleration(point, body, frame)
        )


def solve_by_hand(motion: Motion, rounded: Rounded) -> Motion:
    """The motion again, from the same relations and by the same plan, with rounded intermediate
    values; in doubles.

    Raises Singular where rounding leaves a step undetermined.
    """
    if not motion.plan.steps:
        return motion
    relations = tuple(_write_relation(relation, rounded) for relation in motion.frames.relations)
    bases = {
        name: Base(base.point, _write_chain(base.chain, rounded), base.joint)
        for name, base in motion.frames.bases.items()
    }
    equations = [relation.equations() for relation in relations]
    rates = plans.run_steps(
        motion.plan, equations, lambda index: relations[index].velocity_side(), rounded
    )
    changes = plans.run_steps(
        motion.plan, equations, lambda index: relations[index].acceleration_side(rates), rounded
    )
    return _WrittenMotion(
        _WrittenFrames(motion.frames.mechanism, bases, relations, rounded=rounded),
        motion.plan,
        rates,
        changes,
    )


def _write_relation(relation: Relation, rounded: Rounded) -> Relation:
    """The relation with its terms written down."""
    return Relation(
        relation.origin,
        _write_chain(relation.left, rounded),
        _write_chain(relation.right, rounded),
        relation.along,
        relation.turning,
        relation.velocity,
        relation.acceleration,
        relation.frame,
    )


def _write_chain(terms: Chain, rounded: Rounded) -> Chain:
    """The terms with their arms written down."""
    return tuple(
        term
        if isinstance(term, WrittenTerm)
        else WrittenTerm(
            term.kind,
            term.rate,
            write_down(term.vector, rounded),
            term.point,
            term.base,
            term.frame,
            rounded=rounded,
        )
        for term in terms
    )


def write_down(vector: Vector, rounded: Rounded) -> Vector:
    """A vector or a point with its components as they are written down."""
    return Vector(rounded.noted(vector.x), rounded.noted(vector.y))
