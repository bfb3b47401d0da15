"""The motion of guided points, positive in the sense in which a question counts it.

A joint guides a point along a line that has a direction, y upwards say. Where the question counts
the point's velocity downwards, its letter would have one value in the equations and another one in
the answer; so the line is taken the other way round.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from dataclasses import replace
from itertools import product

from kinegrade.expressions.tree import Call, Expression, Name, Operation, is_literal_zero
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.solution import Solution
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import NEGLIGIBLE

_DIRECTIONS = {"x": Vector(1, 0), "y": Vector(0, 1)}
_COUNTED = ("velocity", "acceleration")


def count_as_asked(solution: Solution, asked: Iterable[str]) -> Solution:
    """The instance with the tracks turned round along which questions count a point's motion
    negative; those stay that a driver imposes, or that go with a rotation.
    """
    motion = solution.motion
    trees = [solution.template.asks[name].quantity for name in asked]
    turned = {rate for tree in trees for rate in _find_opposite(tree, motion)}
    return replace(solution, motion=_turn(motion, turned)) if turned else solution


def _find_opposite(tree: Expression, motion: Motion) -> Iterator[Rate]:
    """The rate of a guided point whose velocity or acceleration along an axis is asked for with a
    minus, where the point's track has the direction of this axis.
    """
    if not isinstance(tree, Operation) or not is_literal_zero(tree):
        return
    for axis, vector in product(AXES, find_motion_calls(tree)):
        point = vector.arguments[0]
        counted = Call(axis, (vector,)) == tree.right and vector.function in _COUNTED
        if counted and isinstance(point, Name):
            bound = set(_list_bound(motion.frames.relations))
            for term in _list_tracks(point.name, motion):
                if term.rate not in bound and _has_direction(term.vector, _DIRECTIONS[axis]):
                    yield term.rate


def _list_tracks(point: str, motion: Motion) -> Iterator[Term]:
    """The terms of a point that slides along a fixed line."""
    frames = motion.frames
    chains = [base.chain for base in frames.bases.values()]
    for chain in (*chains, *(side for one in frames.relations for side in (one.left, one.right))):
        for term in chain:
            if (term.kind, term.point, term.frame) == ("sliding", point, GROUND):
                yield term


def _list_bound(relations: Iterable[Relation]) -> Iterator[Rate]:
    """The rates of relations that are not vector equations."""
    for relation in relations:
        if not relation.is_vector:
            yield from relation.unknowns()


def _has_direction(vector: Vector, axis: Vector) -> bool:
    return abs(float(vector.cross(axis))) < NEGLIGIBLE < float(vector.dot(axis))


def _turn(motion: Motion, rates: Set[Rate]) -> Motion:
    """The same motion with the tracks of these rates the other way round."""
    frames = motion.frames
    bases = {
        name: replace(base, chain=_turn_chain(base.chain, rates))
        for name, base in frames.bases.items()
    }
    relations = tuple(
        replace(one, left=_turn_chain(one.left, rates), right=_turn_chain(one.right, rates))
        for one in frames.relations
    )
    return replace(
        motion,
        frames=replace(frames, bases=bases, relations=relations),
        rates=_negate(motion.rates, rates),
        changes=_negate(motion.changes, rates),
    )


def _turn_chain(chain: Chain, rates: Set[Rate]) -> Chain:
    return tuple(term.put(-term.vector) if term.rate in rates else term for term in chain)


def _negate(values: Rates, rates: Set[Rate]) -> Rates:
    return {name: -value if name in rates else value for name, value in values.items()}
