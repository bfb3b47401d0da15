"""How a solution has stated a vector that is already known: by an algebraic value, and along which
positive sense.
"""

from __future__ import annotations

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import double


def find_stated_sense(term: Term, case: Case) -> int:
    """1 where a term's value has been stated along the vector that its rate multiplies, -1 where
    against it.

    A driver may impose a point's motion in the direction opposite to the joint's.
    """
    for relation in case.motion.frames.relations:
        along = relation.source.find_imposed_direction() if relation.source else None
        if along is not None and _imposes(relation, term):
            return 1 if double(along.dot(term.coefficient())) > 0 else -1
    return 1


def _imposes(relation: Relation, term: Term) -> bool:
    """Whether a driver's relation gives the rate of a term and nothing else."""
    chain = (*relation.left, *relation.right)
    return len(chain) == 1 and not relation.turning and chain[0].rate == term.rate


def find_positive_sense(term: Term, case: Case) -> Vector:
    """The direction along which a term's stated value counts as positive."""
    coefficient = term.coefficient()
    return coefficient if find_stated_sense(term, case) > 0 else -coefficient


def is_stated_negative(term: Term, case: Case, level: Level) -> bool:
    """Whether a negative algebraic value has been stated for a term fixed to the ground, given or
    solved for.
    """
    rate = case.rates(level)[term.rate]
    if term.frame != GROUND or double(rate) * find_stated_sense(term, case) >= 0:
        return False
    return term.kind != "rotation" or _is_vector_result(term.rate, case)


def find_path_term(chain: Chain, case: Case) -> Term | None:
    """The single term that gives the same motion as a chain does, by another way; None where there
    is none.
    """
    for relation in case.motion.frames.relations:
        for same, other in ((relation.left, relation.right), (relation.right, relation.left)):
            if chain and list_ways(same) == list_ways(chain) and len(other) == 1:
                return other[0]
    return None


def list_ways(chain: Chain) -> tuple[tuple[Rate, str, str], ...]:
    """What distinguishes chains: the rate, the point and the base of each term."""
    return tuple((term.rate, term.point, term.base) for term in chain)


def _is_vector_result(rate: Rate, case: Case) -> bool:
    """Whether a rate results from a vector equation, so that the vector's value has been written
    with it.
    """
    step = next((step for step in case.motion.plan.steps if rate in step.unknowns), None)
    relations = [case.motion.frames.relations[index] for index in step.relations] if step else []
    return any(relation.is_vector for relation in relations)
