"""The worked solution of a solved instance, derived from its plan: nothing in it is written for a
particular template.

How each body moves; where everything is; the steps of the plan for velocities, then for
accelerations, as far as the answers need them, each answer where it is found, its value in a box.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations.terms import Chain
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.as_stated import restate
from kinegrade.problem.pole_names import find_poles
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask, Method
from kinegrade.worked.acceleration_ideas import explain_accelerations
from kinegrade.worked.answers.boxes import AnswerBoxes
from kinegrade.worked.answers.named_steps import explain_steps
from kinegrade.worked.answers.poses import explain_pose_answers, is_positional
from kinegrade.worked.asked_senses import count_as_asked
from kinegrade.worked.case import Case
from kinegrade.worked.checks.chapters import check_places
from kinegrade.worked.contacts import introduce_contacts
from kinegrade.worked.conventions import find_conventions, state_rounding
from kinegrade.worked.document import Block, Heading, WorkedSolution
from kinegrade.worked.economy import leave_out_unused
from kinegrade.worked.findings import Findings, Ways
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.precision import find_more_digits
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.numbering import number_steps
from kinegrade.worked.positions.parts import list_lines
from kinegrade.worked.positions.positions import explain_positions
from kinegrade.worked.rate_chapters import find_stages, list_found, write_rate_chapters
from kinegrade.worked.rates.kinds import describe_motions
from kinegrade.worked.rates.rim_tracks import join_rims
from kinegrade.worked.steps.couplers import goes_by_pole
from kinegrade.worked.steps.given_steps import is_given
from kinegrade.worked.steps.ideas.ideas import find_reasons, say_idea
from kinegrade.worked.steps.methods import Way, find_way
from kinegrade.worked.steps.sought import name_task
from kinegrade.worked.steps.used_points import find_placed_points, find_used_points
from kinegrade.worked.unit_of_length import count_lengths_as_given
from kinegrade.worked.vectors.needed_rates import (
    NOTHING,
    Needs,
    are_places,
    find_needs,
    find_paths,
    find_spared,
    select_steps,
)
from kinegrade.worked.vectors.relatives import claim_plain_symbols
from kinegrade.worked.vectors.stage import Stage


def write_worked_solution(
    solution: Solution, asks: Iterable[str], language: Language, method: Method | None = None
) -> WorkedSolution:
    """The worked solution for the asks named, in the letters of the statement, by the given method
    where several apply (by default the template's, else the base point).
    """
    names = tuple(asks)
    counted, length = count_lengths_as_given(solution, names)
    stated = count_as_asked(restate(counted), names)
    case = Case(stated, language, method or stated.template.about.method, length)
    asked = tuple(stated.template.asks[name] for name in names)
    written = _write(case, asked, method)
    more = find_more_digits(
        case.findings.printed
    )  # where digits are lost shows when all is written
    if not more:
        return written
    return _write(replace(case, more_digits=more, findings=Findings()), asked, method)


def _write(case: Case, asked: Sequence[Ask], method: Method | None) -> WorkedSolution:
    """The solution with the digits that the case gives its numbers."""
    claim_plain_symbols(asked, case)
    boxes = AnswerBoxes.around(asked, case)
    if not case.template.scheme.has_mechanism:
        with case.arithmetic.context():
            steps = tuple(boxes.frame(explain_steps(asked, case, boxes)))
        rounded = any(map(_is_rounded, case.findings.printed))
        return WorkedSolution(tuple(_say_rounding(iter(steps), case)) if rounded else steps)
    # Centrodes are worked out at other poses too: in the precision of this one
    with case.arithmetic.context():
        framed = tuple(boxes.frame(_write_blocks(case, asked, boxes)))
        told = leave_out_unused(framed, case.findings.told)
        blocks = (*_note_idle_method(method, asked, case), *number_steps(told, case))
        return WorkedSolution(blocks, tuple(case.findings.checked))


def _note_idle_method(method: Method | None, asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """That the method asked for applies to no step, or is the one by which all go anyway."""
    if method is None:
        return
    usual = _list_ways(asked, replace(case, method=case.template.about.method))
    ways = _list_ways(asked, case)
    if not any(ways.values()):
        yield case.say(Message("solution.method-idle"))
    elif ways == usual:
        yield case.say(Message("solution.method-usual"))


def _list_ways(asked: Sequence[Ask], case: Case) -> Mapping[Step, Way | None]:
    """By which way the velocities of each step are found."""
    velocities, _ = _select_steps(case, asked)
    stages = find_stages(velocities, case, "velocity", frozenset())
    return {step: find_way(step, stage) for step, stage in stages.items()}


def _write_blocks(case: Case, asked: Sequence[Ask], boxes: AnswerBoxes) -> Iterator[Block]:
    """The chapters in order, each answer as soon as all that it needs is found."""
    still = tuple(ask for ask in asked if is_positional(ask))
    moving = tuple(ask for ask in asked if ask not in still)
    velocities, accelerations = _select_steps(case, moving)
    needed = collect_needs(case, moving, find_paths(case.motion))
    case.findings.spared = find_spared(case.motion, velocities, accelerations, needed)
    given = [step for step in velocities if is_given(step, case)]
    stages = find_stages(velocities, case, "velocity", list_found(given))
    places = are_places(ask.quantity for ask in moving)
    case.findings.places_alone = places and all(map(goes_by_pole, stages.values()))
    case.findings.poles_sought = find_poles(moving)
    known = () if case.findings.places_alone else given
    reasons = find_reasons(stages.items(), asked, case, bool(accelerations))
    others = tuple(explain_accelerations(stages, accelerations, moving, case))
    points = find_used_points(case, moving, (*velocities, *accelerations))
    placed = explain_positions(case, [*points, *find_placed_points(case, still)])
    told = len(case.findings.told)
    poses = explain_pose_answers(case, (ask.name for ask in still))
    chapters = write_rate_chapters(case, moving, boxes, (velocities, accelerations))
    # In boxes before their turn: an answer is missing until its line has got its box
    later = tuple(boxes.frame(chapters))
    if velocities:
        said = find_conventions(later, case, accelerated=bool(accelerations))
        later = (later[0], said, *later[1:])
    checks = () if moving else tuple(check_places(still, case))
    used = (*list_lines((*poses, *later)), *case.findings.told[told:])
    task = name_task((*known, *stages), asked, used, case)
    yield from (*say_idea(task, reasons, case), *map(case.say, others))
    if case.motion.rates:
        yield from describe_motions(case, used, (*velocities, *accelerations))
    sought = (read_symbol(ask.symbol).row for ask in still)
    where = placed.write_used((*used, *sought)) if moving else placed.write()
    contacts = introduce_contacts(case, points, (*where, *poses, *later, *checks))
    positions = _head_positions((*contacts, *where), case)
    yield from _say_rounding(chain(positions, poses, boxes.state_missing(still), later), case)
    yield from checks


def _head_positions(blocks: Sequence[Block], case: Case) -> Iterator[Block]:
    """The chapter on positions under its title, where there is anything to say."""
    if blocks:
        yield Heading(case.write(Message("solution.positions")), 1)
        yield from blocks


def _is_rounded(equation: Equation) -> bool:
    return any(link.relation == r"\approx" for link in equation.links)


def _say_rounding(blocks: Iterator[Block], case: Case) -> Iterator[Block]:
    """The blocks with how values are rounded before the first number."""
    rounding, first = state_rounding(case.language, case.notation), next(blocks)
    yield from (first, rounding) if isinstance(first, Heading) else (rounding, first)
    yield from blocks


def find_course(case: Case, asked: Iterable[Ask]) -> tuple[tuple[Step, Stage], ...]:
    """The steps that answers take beyond what is given: for velocities, then for accelerations."""
    velocities, accelerations = _select_steps(case, asked)
    levels: tuple[tuple[Level, tuple[Step, ...]], ...] = (
        ("velocity", velocities),
        ("acceleration", accelerations),
    )
    course: list[tuple[Step, Stage]] = []
    for level, steps in levels:
        given = list_found(step for step in steps if is_given(step, case))
        course += find_stages(steps, case, level, given).items()
    return tuple(course)


def _select_steps(case: Case, asked: Iterable[Ask]) -> tuple[tuple[Step, ...], tuple[Step, ...]]:
    """The steps that all answers together need, for velocities and for accelerations, without the
    rotations of bodies that translate.
    """
    needs = collect_needs(case, asked)
    levels = (tuple(_leave_out_held(one, case)) for one in select_steps(case.motion, needs))
    velocities, accelerations = (join_rims(one, needs, case) for one in levels)
    return velocities, accelerations


def _leave_out_held(steps: Iterable[Step], case: Case) -> Iterator[Step]:
    for step in steps:
        left = tuple(rate for rate in step.unknowns if rate not in case.held_rates)
        if left:
            yield replace(step, unknowns=left)


def collect_needs(
    case: Case, asked: Iterable[Ask], paths: Mapping[Ways, Chain] | None = None
) -> Needs:
    """The rates that all answers together need."""
    needs = NOTHING
    for ask in asked:
        needs |= find_needs(ask.quantity, case.reader, paths)
    return needs
