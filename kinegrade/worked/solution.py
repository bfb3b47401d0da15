"""The worked solution of a solved instance, derived from its plan: nothing in it is written for a
particular template.

How each body moves; where everything is; the steps of the plan for velocities, then for
accelerations, as far as the answers need them; how each answer follows; the answers, whose values
are those of the key.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import assert_never

from kinegrade.language import Language
from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import Parallel, Sleeve
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities import Quantities
from kinegrade.problem.solving import Solution
from kinegrade.problem.template import Ask, Method
from kinegrade.worked.answers import answer_blocks, result
from kinegrade.worked.deductions import Stage
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Results,
    TermTable,
    WorkedSolution,
)
from kinegrade.worked.kinds import kinds
from kinegrade.worked.methods import method_blocks, method_title
from kinegrade.worked.needed_rates import NOTHING, Needs, needs_of, steps_needed
from kinegrade.worked.phrases import phrase
from kinegrade.worked.pictures import (
    answer_pictures,
    given_pictures,
    mechanism_picture,
    stage_pictures,
)
from kinegrade.worked.points import Findings
from kinegrade.worked.pose_answers import is_positional, pose_answers
from kinegrade.worked.positions import positions
from kinegrade.worked.scalars import single_rate
from kinegrade.worked.solution_case import Case
from kinegrade.worked.steps import stage_of, step_blocks
from kinegrade.worked.wording import title


def worked_solution(
    solution: Solution, asks: Iterable[str], language: Language, method: Method | None = None
) -> WorkedSolution:
    """The worked solution for the asks named, by the given method where several apply (by default
    the template's, else the base point).
    """
    case = Case(solution, language, method or solution.template.about.method)
    asked = tuple(solution.template.asks[name] for name in asks)
    return WorkedSolution(tuple(begun(block) for block in blocks(case, asked)))


def begun(block: Block) -> Block:
    """The block with a capital letter at the start of its prose."""
    match block:
        case Prose(text=text):
            return Prose(capitalised(text))
        case Heading() | Display() | TermTable() | Pictures() | Results():
            return block
        case _:
            assert_never(block)


def blocks(case: Case, asked: Sequence[Ask]) -> Iterator[Block]:
    """The chapters in order."""
    findings = Findings()
    if case.motion.rates:
        yield Heading(phrase("kinds", case.language), 1)
        yield from kinds(case)
    yield from position_chapter(case, asked)
    needs = all_needs(case, asked)
    velocities, accelerations = steps_needed(case.motion, needs)
    if velocities:
        yield Heading(phrase("velocities", case.language), 1)
        yield Prose(phrase("positive", case.language))
        yield from level_chapter(velocities, case, "velocity", findings)
    if accelerations:
        yield Heading(phrase("accelerations", case.language), 1)
        yield from level_chapter(accelerations, case, "acceleration", findings)
    yield Heading(phrase("answers", case.language), 1)
    yield from pose_answers(
        case.solution, (ask.name for ask in asked if is_positional(ask)), case.language
    )
    for ask in asked:
        if not is_positional(ask):
            yield from answer_blocks(ask, case, findings)
    yield from answer_pictures(asked, case)
    yield Results(tuple(result(ask, case) for ask in asked))


def all_needs(case: Case, asked: Iterable[Ask]) -> Needs:
    """The rates that all answers together need."""
    quantities = Quantities(case.motion, case.arithmetic)
    needs = NOTHING
    for ask in asked:
        needs |= needs_of(ask.quantity, case.motion, quantities)
    return needs


def position_chapter(case: Case, asked: Sequence[Ask]) -> Iterator[Block]:
    """Where the points of the mechanism are; for a problem of positions alone the answers show
    it.
    """
    yield Heading(phrase("positions", case.language), 1)
    if all(is_positional(ask) for ask in asked):
        yield Pictures((mechanism_picture(case),))
    yield from positions(case.solution, tuple(case.template.scheme.points), case.language)


def level_chapter(
    steps: Sequence[Step], case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The steps of velocities, or of accelerations, numbered; the given motions come first and
    count as one step.
    """
    imposed = [step for step in steps if is_given(step, case)]
    known: set[str] = {rate for step in imposed for rate in step.unknowns}
    number = 0
    if imposed:
        number = 1
        given = capitalised(phrase("title_given", case.language))
        yield Heading(phrase("step", case.language, number=1, title=given), 2)
        for step in imposed:
            yield from step_blocks(step, stage_of(step, case, level, set()), findings)
        yield from given_pictures(imposed, case, level)
    for step in steps:
        if step in imposed:
            continue
        if not holds_still(step, case):
            number += 1
            yield from numbered_step(number, step, stage_of(step, case, level, known), findings)
        known |= set(step.unknowns)


def numbered_step(number: int, step: Step, stage: Stage, findings: Findings) -> Iterator[Block]:
    """One step under its title: the equations, their results, the pictures."""
    by_method = tuple(method_blocks(step, stage, findings))
    name = (method_title(stage) if by_method else None) or title(step, stage)
    yield Heading(phrase("step", stage.case.language, number=number, title=capitalised(name)), 2)
    yield from by_method or step_blocks(step, stage, findings)
    yield from stage_pictures(step, stage)
    for equation in stage.equations:
        findings.note(equation, stage.case)


def is_given(step: Step, case: Case) -> bool:
    """Whether a step only says what a driver imposes on one rate."""
    relations = [case.motion.frames.relations[index] for index in step.relations]
    imposed = isinstance(relations[0].source, (Rotation, Component, Circulation))
    return len(relations) == 1 and imposed and single_rate(relations[0])


def holds_still(step: Step, case: Case) -> bool:
    """Whether a step only says that a body does not turn, which the first chapter has already
    said.
    """
    relations = [case.motion.frames.relations[index] for index in step.relations]
    held = isinstance(relations[0].source, (Parallel, Sleeve))
    return len(relations) == 1 and held and len(relations[0].turning) == 1


def capitalised(title_: str) -> str:
    """A title with a capital letter first, unless it begins with a symbol."""
    return title_[0].upper() + title_[1:]
