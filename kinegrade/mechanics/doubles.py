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


def convert_to_doubles(motion: Motion) -> MotionInDoubles:
    """The same motion with each number a double. Joints and drivers of the mechanism keep their
    numbers: the relations, which are converted, contain everything that they state.
    """
    mechanism, frames = motion.frames.mechanism, motion.frames
    points = {name: convert_vector(point) for name, point in mechanism.points.items()}
    bases = {
        name: Base(base.point, _convert_chain(base.chain), base.joint)
        for name, base in frames.bases.items()
    }
    plain = Frames(
        Mechanism(points, mechanism.bodies, mechanism.joints, mechanism.drivers),
        bases,
        tuple(_convert_relation(relation) for relation in frames.relations),
    )
    if not motion.plan.steps:  # a pose, of which no rate is known
        return MotionInDoubles(plain, motion.plan, motion.rates, motion.changes)
    return MotionInDoubles(
        plain,
        motion.plan,
        {name: float(rate) for name, rate in motion.rates.items()},
        {name: float(change) for name, change in motion.changes.items()},
    )


def _convert_relation(relation: Relation) -> Relation:
    """A relation with its terms, direction, factors and imposed rates in doubles."""
    return Relation(
        relation.origin,
        _convert_chain(relation.left),
        _convert_chain(relation.right),
        None if relation.along is None else convert_vector(relation.along),
        tuple((rate, float(factor)) for rate, factor in relation.turning),
        float(relation.velocity),
        float(relation.acceleration),
        relation.frame,
        relation.source,
    )


def _convert_chain(chain: Chain) -> Chain:
    """The terms with their vectors in doubles."""
    return tuple(
        Term(term.kind, term.rate, convert_vector(term.vector), term.point, term.base, term.frame)
        for term in chain
    )


def convert_vector(vector: Any) -> Vector:
    """A vector in doubles."""
    return Vector(float(vector.x), float(vector.y))
