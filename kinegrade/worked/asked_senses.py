"""The motion of guided points, positive in the sense in which a question counts it.

A joint guides a point along a line that has a direction, y upwards say, or along a circle on which
it counts counter-clockwise. Where the question counts the point's velocity downwards, or clockwise
about the centre, its letter would have one value in the equations and another one in the answer; so
the line or circle is taken the other way round.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from dataclasses import replace
from itertools import product
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Operation, is_literal_zero
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.solution import Solution
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import NEGLIGIBLE

_DIRECTIONS = {"x": Vector(1, 0), "y": Vector(0, 1)}
_COUNTED = ("velocity", "acceleration")
_RELATIVE = ("relative_velocity", "relative_acceleration")


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
    if isinstance(tree, Call):
        yield from _find_clockwise(tree, motion)
        yield from _find_backwards(tree, motion)
    if not isinstance(tree, Operation) or not is_literal_zero(tree):
        return
    bound = set(_list_bound(motion.frames.relations))
    for axis, vector in product(AXES, find_motion_calls(tree)):
        point = vector.arguments[0]
        counted = Call(axis, (vector,)) == tree.right and vector.function in _COUNTED
        if counted and isinstance(point, Name):
            for term in _list_tracks(point.name, motion):
                if term.rate not in bound and _has_direction(term.vector, _DIRECTIONS[axis]):
                    yield term.rate


def _find_clockwise(tree: Call, motion: Motion) -> Iterator[Rate]:
    """The rate of a point on a circle of a moving body whose relative velocity or acceleration
    along the circle is asked for, clockwise about the centre.
    """
    match tree:
        case Call(
            "along", (Call(function, (Name(point), Name(body), Name(frame))), Call(turn, arm))
        ):
            asked = function in _RELATIVE and turn == "turned"
        case _:
            return
    bound = set(_list_bound(motion.frames.relations))
    for term in _list_terms(motion):
        moving = (term.rate.point, term.rate.body, term.frame) == (point, body, frame)
        inwards = Operation("-", Name(term.base), Name(term.point))
        if asked and term.kind == "arc" and moving and arm == (inwards,) and term.rate not in bound:
            yield term.rate


def find_asked_turn(term: Term, level: Level, case: Case) -> int | None:
    """1 where a question counts the vector of a point that turns about another one
    counter-clockwise about that, -1 where clockwise; None where none does.
    """
    outwards = Operation("-", Name(term.point), Name(term.base))
    inwards = Operation("-", Name(term.base), Name(term.point))
    senses = {
        sign
        for sign, arm in ((1, outwards), (-1, inwards))
        if _is_counted(term, Call("turned", (arm,)), level, case)
    }
    return senses.pop() if len(senses) == 1 else None


def orient_arm(term: Term, level: Level, case: Case) -> tuple[str, str]:
    """From where to where the arm of a point counts positive that is carried by a base point: as a
    question says, else from the base point for velocities, to it for accelerations.
    """
    away, back = (term.base, term.point), (term.point, term.base)
    usual, other = {"velocity": (away, back), "acceleration": (back, away)}[level]
    start, end = map(Name, other)
    return other if _is_counted(term, Operation("-", end, start), level, case) else usual


def _is_counted(term: Term, direction: Expression, level: Level, case: Case) -> bool:
    """Whether a question is about the component of a point's vector in a direction."""
    point, body = Name(term.point), Name(term.rate.body)
    quantities = {ask.quantity for ask in case.template.asks.values()}
    vectors = (Call(level, (point,)), Call(level, (point, body)))
    return any(Call("along", (vector, direction)) in quantities for vector in vectors)


def _find_backwards(tree: Call, motion: Motion) -> Iterator[Rate]:
    """The rate of a point that slides along a line on the ground or of a moving body, whose motion
    there is asked for from point to point, against the direction of the line.
    """
    match tree:
        case Call(
            "along",
            (Call(function, (Name(point), *others)), Operation("-", Name(end), Name(start))),
        ) if function in (*_COUNTED, *_RELATIVE):
            way = motion.points[end] - motion.points[start]
        case _:
            return
    frame = others[-1] if function in _RELATIVE else Name(GROUND)
    bound = set(_list_bound(motion.frames.relations))
    for term in _list_terms(motion):
        slides = (term.kind, term.point, Name(term.frame)) == ("sliding", point, frame)
        if slides and term.rate not in bound and _has_direction(-term.vector, way):
            yield term.rate


def _list_tracks(point: str, motion: Motion) -> Iterator[Term]:
    """The terms of a point that slides along a fixed line."""
    for term in _list_terms(motion):
        if (term.kind, term.point, term.frame) == ("sliding", point, GROUND):
            yield term


def _list_terms(motion: Motion) -> Iterator[Term]:
    """The terms of all bases and relations."""
    frames = motion.frames
    yield from (term for base in frames.bases.values() for term in base.chain)
    for relation in frames.relations:
        yield from (*relation.left, *relation.right)


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
    return tuple(_turn_term(term) if term.rate in rates else term for term in chain)


def _turn_term(term: Term) -> Term:
    match term.kind:
        case "sliding":
            return term.put(-term.vector)
        case "rotation" | "arc":
            return replace(term, clockwise=not term.clockwise)
        case _:
            assert_never(term.kind)


def _negate(values: Rates, rates: Set[Rate]) -> Rates:
    return {name: -value if name in rates else value for name, value in values.items()}
