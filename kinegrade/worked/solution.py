"""The worked solution of a solved instance, derived from its plan: nothing in it is written for a
particular template.

How each body moves; where everything is; the steps of the plan for velocities, then for
accelerations, as far as the answers need them, each answer where it is found, its value in a box.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.as_stated import restate
from kinegrade.problem.pole_names import find_poles
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask, Method
from kinegrade.worked.answers.answers import explain_answer
from kinegrade.worked.answers.boxes import AnswerBoxes
from kinegrade.worked.answers.named_steps import explain_steps
from kinegrade.worked.answers.poses import explain_pose_answers, is_positional
from kinegrade.worked.case import Case
from kinegrade.worked.checks.chapters import check_places, check_rates
from kinegrade.worked.document import Block, Heading, TermTable, WorkedSolution
from kinegrade.worked.numbering import number_steps
from kinegrade.worked.positions.positions import explain_positions
from kinegrade.worked.rates.kinds import describe_motions
from kinegrade.worked.steps.couplers import find_coupler, goes_by_pole, name_method
from kinegrade.worked.steps.given_steps import holds_still, is_given
from kinegrade.worked.steps.ideas import explain_idea
from kinegrade.worked.steps.methods import explain_by_method
from kinegrade.worked.steps.pictures import draw_stage
from kinegrade.worked.steps.polygons import find_common_scale
from kinegrade.worked.steps.steps import explain_step, find_stage
from kinegrade.worked.steps.titles import name_step
from kinegrade.worked.steps.used_points import find_placed_points, find_used_points
from kinegrade.worked.unit_of_length import count_lengths_as_given
from kinegrade.worked.vectors.contacts import introduce_contacts
from kinegrade.worked.vectors.facts import note_equation
from kinegrade.worked.vectors.needed_rates import (
    NOTHING,
    Needs,
    are_places,
    find_needs,
    select_steps,
)
from kinegrade.worked.vectors.relatives import choose_coriolis_letters, claim_plain_symbols
from kinegrade.worked.vectors.stage import Stage


def write_worked_solution(
    solution: Solution, asks: Iterable[str], language: Language, method: Method | None = None
) -> WorkedSolution:
    """The worked solution for the asks named, in the letters of the statement, by the given method
    where several apply (by default the template's, else the base point).
    """
    names = tuple(asks)
    counted, length = count_lengths_as_given(solution, names)
    stated = restate(counted)
    case = Case(stated, language, method or stated.template.about.method, length)
    asked = tuple(stated.template.asks[name] for name in names)
    claim_plain_symbols(asked, case)
    choose_coriolis_letters(asked, case)
    boxes = AnswerBoxes.around(asked, case)
    if not stated.template.scheme.has_mechanism:
        with case.arithmetic.context():
            return WorkedSolution(tuple(boxes.frame(explain_steps(asked, case, boxes))))
    # Centrodes are worked out at other poses too: in the precision of this one
    with case.arithmetic.context():
        told = tuple(boxes.frame(_write_blocks(case, asked, boxes)))
        return WorkedSolution((*_note_idle_method(method, asked, case), *number_steps(told, case)))


def _note_idle_method(method: Method | None, asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """That the method asked for applies to no step."""
    velocities, _ = select_steps(case.motion, collect_needs(case, asked))
    stages = _find_stages(velocities, case, "velocity", frozenset())
    if method is not None and not any(map(find_coupler, stages.values())):
        yield case.say(Message("solution.method-idle"))


def _write_blocks(case: Case, asked: Sequence[Ask], boxes: AnswerBoxes) -> Iterator[Block]:
    """The chapters in order, each answer as soon as all that it needs is found."""
    still = tuple(ask for ask in asked if is_positional(ask))
    moving = tuple(ask for ask in asked if ask not in still)
    velocities, accelerations = select_steps(case.motion, collect_needs(case, moving))
    given = [step for step in velocities if is_given(step, case)]
    stages = _find_stages(velocities, case, "velocity", _list_found(given))
    places = are_places(ask.quantity for ask in moving)
    case.findings.places_alone = places and all(map(goes_by_pole, stages.values()))
    case.findings.poles_sought = find_poles(moving)
    known = () if case.findings.places_alone else given
    yield from explain_idea(known, stages.items(), asked, case)
    if accelerations and _follow_alike(stages, accelerations, case):
        yield case.say(Message("solution.idea-accelerations"))
    if case.motion.rates:
        yield Heading(case.write(Message("solution.kinds")), 1)
        yield from describe_motions(case)
    points = find_used_points(case, moving, (*velocities, *accelerations))
    yield from _write_position_chapter(case, [*points, *find_placed_points(case, still)])
    yield from explain_pose_answers(case, (ask.name for ask in still))
    yield from boxes.state_missing(still)
    if not moving:
        yield from check_places(still, case)
    if velocities:
        yield Heading(case.write(Message("solution.velocities")), 1)
        positive, rounded = Message("solution.positive"), Message("solution.rounded")
        yield case.say(Message("solution.sentences", first=positive, next=rounded))
        wanted = [ask for ask in moving if _find_level(ask, case) == "velocity"]
        yield from _write_level_chapter(velocities, case, "velocity", _Answers(wanted, boxes))
    if accelerations:
        yield Heading(case.write(Message("solution.accelerations")), 1)
        wanted = [ask for ask in moving if _find_level(ask, case) == "acceleration"]
        yield from _write_level_chapter(
            accelerations, case, "acceleration", _Answers(wanted, boxes)
        )


def find_course(case: Case, asked: Iterable[Ask]) -> tuple[tuple[Step, Stage], ...]:
    """The steps that answers take beyond what is given: for velocities, then for accelerations."""
    velocities, accelerations = select_steps(case.motion, collect_needs(case, asked))
    levels: tuple[tuple[Level, tuple[Step, ...]], ...] = (
        ("velocity", velocities),
        ("acceleration", accelerations),
    )
    course: list[tuple[Step, Stage]] = []
    for level, steps in levels:
        given = _list_found(step for step in steps if is_given(step, case))
        course += _find_stages(steps, case, level, given).items()
    return tuple(course)


def collect_needs(case: Case, asked: Iterable[Ask]) -> Needs:
    """The rates that all answers together need."""
    needs = NOTHING
    for ask in asked:
        needs |= find_needs(ask.quantity, case.reader)
    return needs


def _write_position_chapter(case: Case, used: Collection[str]) -> Iterator[Block]:
    """Where the points used are."""
    yield Heading(case.write(Message("solution.positions")), 1)
    yield from introduce_contacts(case, used)
    yield from explain_positions(case, used)


@dataclass
class _Answers:
    """The answers of a chapter, each given as soon as all rates are known that it needs."""

    wanted: list[Ask]
    boxes: AnswerBoxes

    def follow(self, known: Collection[Rate] | None) -> Iterator[Block]:
        """Those that follow from the rates known, or all that are left."""
        case = self.boxes.case
        for ask in tuple(self.wanted):
            needed = find_needs(ask.quantity, case.reader).rates
            if known is None or needed <= set(known):
                self.wanted.remove(ask)
                yield from explain_answer(ask, case)
                yield from self.boxes.state_missing((ask,))


def _write_level_chapter(
    steps: Sequence[Step], case: Case, level: Level, answers: _Answers
) -> Iterator[Block]:
    """The given motions, then the steps of velocities, or of accelerations, each with the answers
    that follow.
    """
    imposed = [step for step in steps if is_given(step, case)]
    known = set(_list_found(imposed))
    for step in () if case.findings.places_alone else imposed:
        yield from explain_step(step, find_stage(step, case, level, set()))
    stages = _find_stages(steps, case, level, known)
    yield from _write_steps(steps, stages, known, answers)
    yield from answers.follow(None)
    yield from check_rates(stages, level, case)


def _write_steps(
    steps: Sequence[Step], stages: Mapping[Step, Stage], given: Collection[Rate], answers: _Answers
) -> Iterator[Block]:
    """The steps that find something, each with the answers that follow from what is known then."""
    known, scale = set(given), find_common_scale(stages.values())
    for step in steps:
        if step in stages:
            yield from _write_step(step, stages[step], scale)
        known |= set(step.unknowns)
        yield from answers.follow(known)


def _find_stages(
    steps: Sequence[Step], case: Case, level: Level, given: Collection[Rate]
) -> dict[Step, Stage]:
    """The steps that find what neither is given nor has been said of bodies that do not turn."""
    known, stages = set(given), {}
    for step in steps:
        if not known.issuperset(step.unknowns):
            if not holds_still(step, case):
                stages[step] = find_stage(step, case, level, frozenset(known))
            known |= set(step.unknowns)
    return stages


def _follow_alike(
    velocities: Mapping[Step, Stage], accelerations: Sequence[Step], case: Case
) -> bool:
    """Whether the accelerations take the steps of the velocities, with vectors, by one method."""
    given = _list_found(step for step in accelerations if is_given(step, case))
    stages = _find_stages(accelerations, case, "acceleration", given)
    vectorial = any(stage.equations for stage in stages.values())
    alike = list(stages) == list(velocities) and not any(map(name_method, velocities.values()))
    return vectorial and alike


def _list_found(steps: Iterable[Step]) -> frozenset[Rate]:
    """The rates that steps give."""
    return frozenset(rate for step in steps for rate in step.unknowns)


def _find_level(ask: Ask, case: Case) -> Level:
    """Whether an answer needs changes of rates, or rates alone."""
    changes = find_needs(ask.quantity, case.reader).changes
    return "acceleration" if changes else "velocity"


def _write_step(step: Step, stage: Stage, scale: float | None) -> Iterator[Block]:
    """One step under its title: the equations, their results, the pictures to that scale; nothing
    where an earlier answer has told all of it.
    """
    by_method = tuple(explain_by_method(step, stage))
    title = (name_method(stage) if by_method else None) or name_step(step, stage)
    blocks = by_method or tuple(explain_step(step, stage))
    if blocks:
        yield Heading(stage.case.write(Message("solution.step-title", title=title)), 2)
        yield from _place_pictures(blocks, draw_stage(stage, scale))
    for equation in stage.equations:
        note_equation(equation, stage.case)


def _place_pictures(blocks: Sequence[Block], pictures: Iterable[Block]) -> Iterator[Block]:
    """The blocks of a step with its pictures below the vector equations, so that what follows from
    these stands beside them.
    """
    tables = [place for place, block in enumerate(blocks) if isinstance(block, TermTable)]
    below = max(tables) + 1 if tables else 0
    yield from blocks[:below]
    yield from pictures
    yield from blocks[below:]
