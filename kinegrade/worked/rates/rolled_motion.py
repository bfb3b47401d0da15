"""The motion that goes with the rotation of a rolling body: that of its centre, or of a track that
moves with its rim.
"""

from __future__ import annotations

from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.rates.speeds import find_term, state_radius
from kinegrade.worked.vectors.known_vectors import find_stated_sense


def find_linked_term(roll: NoSlip, relation: Relation, case: Case) -> Term:
    """The motion that goes with a rotation: of a track with the speed of the rim, else of the
    centre.
    """
    track = case.findings.rim_tracks.get(roll.joint)
    return track or find_term(relation.turning[0][0], case)


def find_slip_sign(roll: NoSlip, relation: Relation, case: Case, level: Level) -> int:
    """1 where the rotation has the sign of the speed that goes with it as stated, else -1."""
    turning = make_turning(roll.body)
    factor = double(next(factor for rate, factor in relation.turning if rate == turning))
    term, centre = find_linked_term(roll, relation, case), find_term(relation.turning[0][0], case)
    if term != centre:
        # Seen from the track, its wheel moves the opposite way
        factor *= -double(term.coefficient().dot(centre.coefficient()))
    return -1 if factor * find_stated_sense(term, case, level) > 0 else 1


def state_rolled_radius(roll: NoSlip, case: Case) -> Formula:
    """The radius of the rolling circle."""
    circle = case.template.scheme.joints[roll.joint].circle
    return state_radius(circle, roll.circle.radius, case)
