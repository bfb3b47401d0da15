"""Steps of the plan that say nothing new: what a driver imposes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce

from kinegrade.language.message import Message, Text
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.rates.scalars import explain_scalar_step, imposes_single_rate, state_relation


def is_given(step: Step, case: Case) -> bool:
    """Whether a step only says what a driver imposes on one rate."""
    relations = [case.motion.frames.relations[index] for index in step.relations]
    law = relations[0].source
    imposed = law is not None and law.is_given and not law.keeps_parallel
    return len(relations) == 1 and imposed and imposes_single_rate(relations[0])


def explain_given(steps: Sequence[Step], case: Case, level: Level) -> Iterator[Block]:
    """What is given: rotations about fixed axes in one sentence where there are several."""
    turning = [step for step in steps if _is_plain_rotation(step, case, level)]
    together = turning if len(turning) > 1 else []
    if together:
        relations = (case.motion.frames.relations[step.relations[0]] for step in together)
        told: list[Text] = [
            case.tell(state_relation(relation, case, level).equation) for relation in relations
        ]
        listed = reduce(_list_equations, told)
        yield case.say(Message("solution.given-together", equations=listed))
    for step in steps:
        if step not in together:
            relation = case.motion.frames.relations[step.relations[0]]
            yield from explain_scalar_step(relation, step.unknowns[0], case, level)


def _is_plain_rotation(step: Step, case: Case, level: Level) -> bool:
    """Whether a rotation relative to the ground is given, whose letter says whose it is."""
    relation, rate = case.motion.frames.relations[step.relations[0]], step.unknowns[0]
    body = case.naming.body(rate.body)
    plain = Message(f"solution.given-rotation-{level}", body=body)
    return state_relation(relation, case, level).reason == plain


def _list_equations(first: Text, following: Text) -> Text:
    return Message("solution.equation-list", first=first, next=following)
