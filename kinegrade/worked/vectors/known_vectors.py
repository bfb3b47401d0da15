"""How a solution has stated a vector that is already known: by an algebraic value, and along which
positive sense.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import assert_never

from kinegrade.expressions.tree import (
    Call,
    Name,
    Number,
    Operation,
    find_names,
    is_literal_zero,
)
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    EqualBeltSpeed,
    EqualPitchSpeed,
    EqualRotation,
    GuidedPoint,
    Imposed,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    Law,
    NoSlip,
    SharedPoint,
    find_rolling,
)
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Piece, Ways
from kinegrade.worked.formulas.measures import double, find_sign

_AXES: Mapping[str, Vector] = {"x": Vector(1, 0), "y": Vector(0, 1)}


def find_stated_sense(term: Term, case: Case, level: Level) -> int:
    """1 where a term's value has been stated along the vector that its rate multiplies, -1 where
    against it.

    A driver may impose a point's motion in the direction opposite to the joint's; what is given
    counts positive in its own sense, and so does what circles about the same centre unless a
    question says in which sense it counts, and what has been found by its size.
    """
    asked = _find_asked_sense(term, case, level)
    if asked is not None:
        return asked
    for relation in case.motion.frames.relations:
        law = relation.source
        if law is not None and (_imposes(relation, term) or _circles_beside(relation, term)):
            along = law.find_imposed_direction()
            opposite = along is not None and double(along.dot(term.coefficient())) < 0
            return find_given_sign(law, relation, case, level) * (-1 if opposite else 1)
    piece = _find_piece(term, case, level)
    return -1 if piece and double(piece.positive.dot(term.coefficient())) < 0 else 1


def _find_piece(term: Term, case: Case, level: Level) -> Piece | None:
    """The velocity of a guided point, or the tangential part of its acceleration, as it has been
    found by another way.
    """
    part = "t" if term.kind == "arc" and level == "acceleration" else ""
    letters = case.naming.letter(term.point).row
    pieces = (
        piece
        for (told, _), fact in case.findings.facts.items()
        for piece in fact.pieces
        if told == level and (piece.symbol.lower, piece.symbol.part) == (letters, part)
    )
    return next(pieces, None) if term.frame == GROUND else None


def _find_asked_sense(term: Term, case: Case, level: Level) -> int | None:
    """1 where a question counts the velocity of a point on a fixed circle, or its tangential
    acceleration, counter-clockwise about the centre, -1 where clockwise; None where no question
    does, and where a driver gives it.
    """
    if term.kind != "arc" or term.frame != GROUND:
        return None
    if any(_imposes(relation, term) for relation in case.motion.frames.relations):
        return None
    counted = Call(level, (Name(term.point),))
    outwards = Operation("-", Name(term.point), Name(term.base))
    inwards = Operation("-", Name(term.base), Name(term.point))
    quantities = {ask.quantity for ask in case.template.asks.values()}
    senses = {
        sign
        for sign, arm in ((1, outwards), (-1, inwards))
        if Call("along", (counted, Call("turned", (arm,)))) in quantities
    }
    return senses.pop() if len(senses) == 1 else None


def find_given_sign(law: Law, relation: Relation, case: Case, level: Level) -> int:
    """-1 where a point's velocity or acceleration counts positive against the driver's direction:
    where questions count those of points beside it so, else where the statement gives the size of
    a negative one, with the sense in words; else 1.
    """
    match law:
        case SharedPoint() | GuidedPoint() | EqualRotation() | ImposedRotation():
            return 1
        case NoSlip() | EqualPitchSpeed() | EqualBeltSpeed():
            return 1
        case ImposedMotion(of=of) if of != GROUND:
            return 1
        case ImposedComponent(direction=direction):
            return find_sign(direction.dot(relation.left[0].vector))
        case ImposedMotion(direction=direction):
            asked = {find_sign(direction.dot(one)) for one in _list_asked_senses(direction, case)}
            return asked.pop() if len(asked) == 1 else _find_own_sign(law, relation, case, level)
        case ImposedCircling():
            return _find_own_sign(law, relation, case, level)
        case _:
            assert_never(law)


def _find_own_sign(law: Imposed, relation: Relation, case: Case, level: Level) -> int:
    """-1 where the statement gives the size of a negative value, with the sense in words."""
    value = {"velocity": relation.velocity, "acceleration": relation.acceleration}[level]
    return -1 if double(value) < 0 and not _is_signed(law, case, level) else 1


def _list_asked_senses(along: Vector, case: Case) -> Iterator[Vector]:
    """The senses in which questions count velocities and accelerations along a line that have the
    letter of a point alone.
    """
    for ask in case.template.asks.values():
        sign, tree = 1, ask.quantity
        if isinstance(tree, Operation) and is_literal_zero(tree):
            sign, tree = -1, tree.right
        match tree:
            case Call("x" | "y" as axis, (Call("velocity" | "acceleration"),)):
                sense = _AXES[axis] * sign
                if "," not in ask.symbol and not double(sense.cross(along)):
                    yield sense
            case Name() | Number() | Operation() | Call():
                continue
            case _:
                assert_never(tree)


def _is_signed(law: Imposed, case: Case, level: Level) -> bool:
    """Whether a driver's value is an expression of a negative given, whose sign is printed."""
    sentence, values = case.template.scheme.drivers[law.driver], case.solution.assembly.values
    tree = {"velocity": sentence.velocity, "acceleration": sentence.acceleration}[level]
    return any(double(values[name]) < 0 for name in find_names(tree) if name in values)


def _imposes(relation: Relation, term: Term) -> bool:
    """Whether a driver's relation gives the rate of a term and nothing else."""
    chain = (*relation.left, *relation.right)
    return len(chain) == 1 and not relation.turning and chain[0].rate == term.rate


def _circles_beside(relation: Relation, term: Term) -> bool:
    """Whether a driver moves another point about the fixed centre about which a point moves."""
    chain = (*relation.left, *relation.right)
    if len(chain) != 1 or relation.turning:
        return False
    driven = chain[0]
    fixed = driven.frame == term.frame == GROUND
    return fixed and driven.kind == term.kind == "arc" and driven.base == term.base


def find_positive_sense(term: Term, case: Case, level: Level) -> Vector:
    """The direction along which a term's stated value counts as positive."""
    coefficient = term.coefficient()
    return coefficient if find_stated_sense(term, case, level) > 0 else -coefficient


def is_stated_negative(term: Term, case: Case, level: Level) -> bool:
    """Whether a negative algebraic value has been stated for a term: for one fixed to the ground
    given or solved for, for a relative one by the rotation of what rolls.
    """
    rate = case.rates(level)[term.rate]
    if double(rate) * find_stated_sense(term, case, level) >= 0:
        return False
    if term.frame != GROUND:
        return _is_rolled(term, case)
    return term.kind != "rotation" or _is_vector_result(term.rate, case)


def _is_rolled(term: Term, case: Case) -> bool:
    """Whether no slip links the motion of a point to a rotation."""
    return any(
        find_rolling(relation.source) is not None and relation.turning[0][0] == term.rate
        for relation in case.motion.frames.relations
    )


def find_path_term(chain: Chain, case: Case) -> Term | None:
    """The single term that gives the same motion as a chain does, by another way; None where there
    is none.
    """
    for relation in case.motion.frames.relations:
        for same, other in ((relation.left, relation.right), (relation.right, relation.left)):
            if chain and list_ways(same) == list_ways(chain) and len(other) == 1:
                return other[0]
    return None


def list_ways(chain: Chain) -> Ways:
    """What distinguishes chains: the rate, the point and the base of each term."""
    return tuple((term.rate, term.point, term.base) for term in chain)


def _is_vector_result(rate: Rate, case: Case) -> bool:
    """Whether a rate results from a vector equation, so that the vector's value has been written
    with it.
    """
    step = next((step for step in case.motion.plan.steps if rate in step.unknowns), None)
    relations = [case.motion.frames.relations[index] for index in step.relations] if step else []
    return any(relation.is_vector for relation in relations)
