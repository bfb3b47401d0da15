"""A solved motion in doubles: for scales, and for working it out again by hand; never for
answers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.frames import Base, Frames
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True, eq=False)
class MotionInDoubles(Motion):
    """A motion in doubles, compared by identity, so that results found for it can be cached."""

    __hash__, __eq__ = object.__hash__, object.__eq__


def in_doubles(motion: Motion) -> MotionInDoubles:
    """The same motion with each number a double. Joints and drivers of the mechanism keep their
    numbers: the relations, which are converted, contain everything that they state.
    """
    mechanism, frames = motion.frames.mechanism, motion.frames
    points = {name: double(point) for name, point in mechanism.points.items()}
    bases = {
        name: Base(base.point, chain_in_doubles(base.chain), base.joint)
        for name, base in frames.bases.items()
    }
    plain = Frames(
        Mechanism(points, mechanism.bodies, mechanism.joints, mechanism.drivers),
        bases,
        tuple(relation_in_doubles(relation) for relation in frames.relations),
    )
    if not motion.plan.steps:  # a pose, of which no rate is known
        return MotionInDoubles(plain, motion.plan, motion.rates, motion.changes)
    return MotionInDoubles(
        plain,
        motion.plan,
        {name: float(rate) for name, rate in motion.rates.items()},
        {name: float(change) for name, change in motion.changes.items()},
    )


def relation_in_doubles(relation: Relation) -> Relation:
    """A relation with its terms, direction, factors and imposed rates in doubles."""
    return Relation(
        relation.origin,
        chain_in_doubles(relation.left),
        chain_in_doubles(relation.right),
        None if relation.along is None else double(relation.along),
        tuple((rate, float(factor)) for rate, factor in relation.turning),
        float(relation.velocity),
        float(relation.acceleration),
        relation.frame,
        relation.source,
    )


def chain_in_doubles(chain: Chain) -> Chain:
    """The terms with their vectors in doubles."""
    return tuple(
        Term(term.kind, term.rate, double(term.vector), term.point, term.base, term.frame)
        for term in chain
    )


def double(vector: Any) -> Vector:
    """A vector in doubles."""
    return Vector(float(vector.x), float(vector.y))
