"""The chapters on velocities and accelerations of a worked solution: the steps of the plan, each
answer as soon as all that it needs is found.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.answers import explain_answer
from kinegrade.worked.answers.boxes import AnswerBoxes
from kinegrade.worked.answers.point_vectors import list_asked_velocities
from kinegrade.worked.case import Case
from kinegrade.worked.checks.chapters import check_rates
from kinegrade.worked.document import Block, Heading, TermTable
from kinegrade.worked.steps.couplers import name_method
from kinegrade.worked.steps.given_steps import explain_given, is_given
from kinegrade.worked.steps.methods import explain_by_method
from kinegrade.worked.steps.pictures import draw_stage
from kinegrade.worked.steps.polygons import find_common_scale
from kinegrade.worked.steps.steps import explain_step, find_stage
from kinegrade.worked.steps.titles import name_step
from kinegrade.worked.steps.two_tracks import find_two_tracks
from kinegrade.worked.vectors.facts import note_equation
from kinegrade.worked.vectors.needed_rates import find_needs
from kinegrade.worked.vectors.stage import Stage


def write_rate_chapters(
    case: Case,
    moving: Sequence[Ask],
    boxes: AnswerBoxes,
    steps: tuple[Sequence[Step], Sequence[Step]],
) -> Iterator[Block]:
    """The chapters on velocities and on accelerations, with the answers that need them."""
    velocities, accelerations = steps
    later = [ask for ask in moving if _belongs_to_accelerations(ask, case, accelerations)]
    if velocities:
        yield Heading(case.write(Message("solution.velocities")), 1)
        wanted = [ask for ask in moving if ask not in later]
        yield from _write_level_chapter(
            velocities, case, "velocity", _Answers(wanted, boxes), not accelerations
        )
    if accelerations:
        yield Heading(case.write(Message("solution.accelerations")), 1)
        yield from _write_level_chapter(
            accelerations, case, "acceleration", _Answers(later, boxes), True
        )


@dataclass
class _Answers:
    """The answers of a chapter, each given as soon as all rates are known that it needs."""

    wanted: list[Ask]
    boxes: AnswerBoxes

    @cached_property
    def _needed(self) -> Mapping[str, Set[Rate]]:
        """The rates that each of them needs, by its name."""
        reader = self.boxes.case.reader
        return {ask.name: find_needs(ask.quantity, reader).rates for ask in self.wanted}

    def list_due(self, known: Set[Rate] | None) -> tuple[Ask, ...]:
        """Those that follow from the rates known, or all that are left."""
        return tuple(ask for ask in self.wanted if known is None or self._needed[ask.name] <= known)

    def follow(self, known: Set[Rate] | None) -> Iterator[Block]:
        """Those that follow from the rates known, or all that are left, each with its way."""
        for ask in self.list_due(known):
            self.wanted.remove(ask)
            yield from explain_answer(ask, self.boxes.case)
            yield from self.boxes.state_missing((ask,))


def _write_level_chapter(
    steps: Sequence[Step], case: Case, level: Level, answers: _Answers, last: bool
) -> Iterator[Block]:
    """The given motions, then the steps of velocities, or of accelerations, each with the answers
    that follow.
    """
    imposed = [step for step in steps if is_given(step, case)]
    known = case.held_rates | list_found(imposed)
    if not case.findings.places_alone:
        yield from explain_given(imposed, case, level)
    stages, asked = find_stages(steps, case, level, known), tuple(answers.wanted)
    yield from _write_steps(steps, stages, known, answers)
    yield from answers.follow(None)
    yield from check_rates(stages, asked, level, case, last=last)


def _write_steps(
    steps: Sequence[Step], stages: Mapping[Step, Stage], given: Collection[Rate], answers: _Answers
) -> Iterator[Block]:
    """The steps that find something, each with the answers that follow from what is known then."""
    known, scale = set(given), find_common_scale(stages.values())
    for step in steps:
        known |= set(step.unknowns)
        if step in stages:
            yield from _write_step(step, stages[step], scale, answers.list_due(known))
        yield from answers.follow(known)


def find_stages(
    steps: Sequence[Step], case: Case, level: Level, given: frozenset[Rate]
) -> dict[Step, Stage]:
    """The steps that find what is neither given nor said of bodies that do not turn."""
    known, stages = case.held_rates | given, {}
    for step in steps:
        if not known.issuperset(step.unknowns):
            stages[step] = find_stage(step, case, level, known)
            known |= {*step.unknowns}
    return stages


def list_found(steps: Iterable[Step]) -> frozenset[Rate]:
    """The rates that steps give."""
    return frozenset(rate for step in steps for rate in step.unknowns)


def _belongs_to_accelerations(ask: Ask, case: Case, steps: Sequence[Step]) -> bool:
    """Whether an answer needs changes of rates, or is a Coriolis acceleration, which follows from
    velocities, and steps of accelerations say by which theorem there is one.
    """
    calls = find_motion_calls(ask.quantity)
    turned = any(MOTION_FUNCTIONS[call.function].derivation == "coriolis" for call in calls)
    return bool(find_needs(ask.quantity, case.reader).changes) or (turned and bool(steps))


def _write_step(
    step: Step, stage: Stage, scale: float | None, due: Iterable[Ask]
) -> Iterator[Block]:
    """One step under its title: the equations, their results, the pictures to that scale, with the
    velocities of the answers that are due then; nothing where an earlier answer has told all of it.
    """
    wheel = find_two_tracks(step, stage)
    if wheel is not None:
        yield _head(
            stage, Message("solution.title-two-tracks", body=stage.case.naming.body(wheel.body))
        )
        yield from wheel.explain()
        return
    by_method = tuple(explain_by_method(step, stage))
    title = (name_method(stage) if by_method else None) or name_step(step, stage)
    blocks = by_method or tuple(explain_step(step, stage))
    if blocks:
        yield _head(stage, title)
        asked = tuple(list_asked_velocities(due, stage.case))
        yield from _place_pictures(blocks, draw_stage(stage, scale, asked))
    for equation in stage.equations:
        note_equation(equation, stage.case)


def _head(stage: Stage, title: Message) -> Heading:
    return Heading(stage.case.write(Message("solution.step-title", title=title)), 2)


def _place_pictures(blocks: Sequence[Block], pictures: Iterable[Block]) -> Iterator[Block]:
    """The blocks of a step with its pictures below the vector equations, so that what follows from
    these stands beside them.
    """
    tables = [place for place, block in enumerate(blocks) if isinstance(block, TermTable)]
    below = max(tables) + 1 if tables else 0
    yield from blocks[:below]
    yield from pictures
    yield from blocks[below:]
