"""Steps of the plan that say nothing new: what a driver imposes."""

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
