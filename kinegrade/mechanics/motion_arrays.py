"""Motions of one structure, in doubles, as a single motion whose numbers are arrays with an entry
for each.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Any

import numpy as np

from kinegrade.mechanics.frames import Base, Frames
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number


def describe_structure(motion: Motion) -> Hashable:
    """What two motions of a template must have in common to be stacked: everything but the
    numbers.
    """
    frames = motion.frames
    bases = tuple(
        (name, base.point, _describe_chain_structure(base.chain))
        for name, base in frames.bases.items()
    )
    relations = tuple(
        (
            _describe_chain_structure(relation.left),
            _describe_chain_structure(relation.right),
            relation.along is None,
            tuple(rate for rate, _ in relation.turning),
            relation.frame,
        )
        for relation in frames.relations
    )
    return (
        motion.plan,
        tuple(motion.points),
        bases,
        relations,
        tuple(motion.rates),
        tuple(motion.changes),
    )


def _describe_chain_structure(chain: Chain) -> Hashable:
    """A chain without its vectors."""
    return tuple((term.kind, term.rate, term.point, term.base, term.frame) for term in chain)


def stack_motions(motions: Sequence[Motion]) -> Motion:
    """The motions, of one structure and in doubles, as one. Joints and drivers are those of the
    first, as relations state all of the numbers.
    """
    first, frames = motions[0], [motion.frames for motion in motions]
    points = {
        name: stack_vectors([motion.points[name] for motion in motions]) for name in first.points
    }
    bases = {
        name: Base(base.point, _stack_chains([one.bases[name].chain for one in frames]), base.joint)
        for name, base in frames[0].bases.items()
    }
    relations = tuple(
        _stack_relations(same) for same in zip(*(one.relations for one in frames), strict=True)
    )
    mechanism = frames[0].mechanism
    together = Mechanism(points, mechanism.bodies, mechanism.joints, mechanism.drivers)
    if not first.plan.steps:  # poses, of which no rate is known
        return Motion(Frames(together, bases, relations), first.plan, first.rates, first.changes)
    return Motion(
        Frames(together, bases, relations),
        first.plan,
        {name: stack_numbers([motion.rates[name] for motion in motions]) for name in first.rates},
        {
            name: stack_numbers([motion.changes[name] for motion in motions])
            for name in first.changes
        },
    )


def _stack_relations(same: Sequence[Relation]) -> Relation:
    """Relations of one structure as one."""
    first = same[0]
    factors = zip(*([factor for _, factor in relation.turning] for relation in same), strict=True)
    return Relation(
        first.origin,
        _stack_chains([relation.left for relation in same]),
        _stack_chains([relation.right for relation in same]),
        stack_vectors([relation.along for relation in same if relation.along is not None]),
        tuple(
            (rate, stack_numbers(factor))
            for (rate, _), factor in zip(first.turning, factors, strict=True)
        ),
        stack_numbers([relation.velocity for relation in same]),
        stack_numbers([relation.acceleration for relation in same]),
        first.frame,
        first.source,
    )


def _stack_chains(chains: Sequence[Chain]) -> Chain:
    """Chains of one structure as one."""
    return tuple(
        Term(
            same[0].kind,
            same[0].rate,
            stack_vectors([term.vector for term in same]),
            same[0].point,
            same[0].base,
            same[0].frame,
        )
        for same in zip(*chains, strict=True)
    )


def stack_vectors(vectors: Sequence[Vector]) -> Any:
    """Vectors as one; None if there are none."""
    if not vectors:
        return None
    return Vector(
        stack_numbers([vector.x for vector in vectors]),
        stack_numbers([vector.y for vector in vectors]),
    )


def stack_numbers(numbers: Sequence[Number]) -> Any:
    """Doubles as an array; numbers that are equal in all, down to the sign of a zero, as one
    double.
    """
    array = np.array(numbers)
    first = array[0]
    if (array == first).all() and (np.signbit(array) == np.signbit(first)).all():
        return float(first)
    return array
