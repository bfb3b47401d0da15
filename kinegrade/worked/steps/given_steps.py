"""Steps of the plan that say nothing new: what a driver imposes, what holds still."""

from __future__ import annotations

from kinegrade.mechanics.plan import Step
from kinegrade.worked.case import Case
from kinegrade.worked.rates.scalars import imposes_single_rate


def is_given(step: Step, case: Case) -> bool:
    """Whether a step only says what a driver imposes on one rate."""
    relations = [case.motion.frames.relations[index] for index in step.relations]
    law = relations[0].source
    imposed = law is not None and law.is_given and not law.keeps_parallel
    return len(relations) == 1 and imposed and imposes_single_rate(relations[0])


def holds_still(step: Step, case: Case) -> bool:
    """Whether a step only says that a body does not turn, which the first chapter has already
    said.
    """
    relations = [case.motion.frames.relations[index] for index in step.relations]
    law = relations[0].source
    held = law is not None and law.keeps_parallel
    return len(relations) == 1 and held and len(relations[0].turning) == 1
