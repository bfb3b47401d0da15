"""Racks and ropes that run over a wheel whose centre is fixed: they move with its rim, so that no
motion seen from them is told.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rolling
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.terms import Term
from kinegrade.worked.case import Case
from kinegrade.worked.vectors.needed_rates import Needs


def join_rims(steps: Sequence[Step], needs: Needs, case: Case) -> tuple[Step, ...]:
    """The steps, with one in place of two where a track that translates moves with the rim of a
    wheel: the condition of no slip for the track itself, which the notebook keeps.
    """
    joined = tuple(steps)
    for step in steps:
        roll, track = _find_rim(step, case)
        if roll is None or track is None or roll.rate in needs.rates | needs.changes:
            continue
        both = [one for one in joined if _involves(one, roll.rate, case)]
        if len(both) == 2 and both[0].unknowns == (roll.rate,):
            case.findings.rim_tracks[roll.joint] = track
            merged = Step(step.relations, both[1].unknowns)
            joined = tuple(merged if one == both[1] else one for one in joined if one != both[0])
    return joined


def _involves(step: Step, rate: Rate, case: Case) -> bool:
    relations = (case.motion.frames.relations[index] for index in step.relations)
    return any(rate in relation.unknowns() for relation in relations)


def _find_rim(step: Step, case: Case) -> tuple[NoSlip | None, Term | None]:
    """The condition of no slip that is all of a step, and the term by which its track moves where
    that translates and the wheel's centre is fixed.
    """
    relations = case.motion.frames.relations
    law = relations[step.relations[0]].source if len(step.relations) == 1 else None
    roll = find_rolling(law)
    if roll is None or roll.of not in case.translating:
        return None, None
    for other in relations:
        terms = [term for term in (*other.left, *other.right) if term.rate not in case.held_rates]
        alone = other.is_vector and not (other.left and other.right)
        if alone and [term.kind for term in terms] == ["sliding", "sliding"]:
            track, seen = terms
            if seen.rate == roll.rate and track.frame == GROUND:
                return roll, track
    return None, None
