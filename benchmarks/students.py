"""Simulated students: those who work rightly with rounded numbers, and those who make a known
mistake.

Each gives for every paper of a class what is typed in, by ask. They round in the arithmetic of
`jotting`, which knows nothing of the bound by which draws are accepted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import degrees, isfinite
from typing import Any

import numpy as np

from benchmarks.jotting import Jotting
from benchmarks.simulated_class import FIGURES, Answer, SimulatedClass
from kinegrade.errors import KinegradeError
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.tolerance import USUAL_CARRY
from kinegrade.problem.quantities.functions import needs_configurations
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistake_kinds import Mistake, find_candidates
from kinegrade.students.mistaking.mistakes import choose_way, work_out
from kinegrade.students.rounding.working import Working

CARRIED = 3  # by mistaken students
DISPLAY = 10  # digits of a calculator
EVERY = 10  # of so many papers one is also worked out with a mistake and rounded numbers

Answers = list[Mapping[str, Answer]]


def honest_students(simulated: SimulatedClass) -> Iterator[tuple[str, Answers]]:
    """Those to whom full marks are promised: they carry what the paper asks for, and every
    operation is rounded, or off by anything that rounding can leave; as many figures are typed in,
    one more, or all.
    """
    chance = np.random.default_rng(simulated.number)
    for way, source in (("rounded", None), ("any error within rounding", chance)):
        found = [honest(solution, source) for solution in simulated.solutions]
        for figures in (USUAL_CARRY, USUAL_CARRY + 1, DISPLAY):
            answers = [typed(each, figures) for each in found]
            yield f"every operation {way}, {figures} figures typed in", answers


def honest(solution: Solution, chance: np.random.Generator | None) -> Mapping[str, float]:
    """The answers of one who works rightly, in the asks' units."""
    template, jotting = solution.template, Jotting(USUAL_CARRY, chance)
    asks = {ask: template.asks[ask] for ask in solution.answers}
    with jotting.context():
        givens = write_givens(template, find_givens(solution), jotting)
        found = Working(jotting).answer(template, asks, givens, solution.motion.plan)
    answers = {ask: in_unit(float(value), asks[ask]) for ask, value in found.items()}
    # A centrode is not worked out by numbers but known in closed form
    return {ask: answers.get(ask, answer.value) for ask, answer in solution.answers.items()}


def find_givens(solution: Solution) -> dict[str, float]:
    """The parameters of an instance, SI."""
    values = solution.assembly.values
    return {name: convert_number(values[name]) for name in solution.template.parameters}


def write_givens(template: Template, values: Mapping[str, Any], jotting: Jotting) -> dict[str, Any]:
    """Parameters, SI, as they are written down."""
    return {
        name: jotting.write(value, angle=template.parameters[name].unit.degrees)
        for name, value in values.items()
    }


def in_unit(value: float, ask: Ask) -> float:
    """A value of SI in the unit of an ask."""
    return degrees(value) if ask.unit.degrees else value / Floats().scale(ask.unit.scale)


def mistaken_students(simulated: SimulatedClass, *, rounded: bool) -> Iterator[Answers]:
    """For each known mistake a class that makes it; asks whose answer it does not change are left
    blank.

    Worked out exactly and typed in with four figures; or for one paper of EVERY with three figures
    carried.
    """
    names = {
        name
        for solution in simulated.solutions
        for answer in solution.answers.values()
        for name in answer.mistakes
    }
    for name in sorted(names):
        yield [mistaken(simulated, place, name, rounded) for place in range(len(simulated.papers))]


def mistaken(
    simulated: SimulatedClass, place: int, name: str, rounded: bool
) -> Mapping[str, Answer]:
    """The answers of one who makes a mistake, by ask."""
    solution = simulated.solutions[place]
    exact = {
        ask: answer.mistakes[name]
        for ask, answer in solution.answers.items()
        if name in answer.mistakes
    }
    if not rounded:
        return {ask: Answer(f"{value:.{FIGURES}g}", value, name) for ask, value in exact.items()}
    if place % EVERY:
        return {}
    found = carried(solution, name)
    return {
        ask: Answer(f"{found[ask]:.{CARRIED}g}", value, name)
        for ask, value in exact.items()
        if ask in found
    }


def carried(solution: Solution, name: str) -> Mapping[str, float]:
    """What a mistake on the way leads to when three figures are carried; nothing for mistakes in
    the answer alone.
    """
    template = solution.template
    asks = {ask: template.asks[ask] for ask in solution.answers if by_numbers(template.asks[ask])}
    mistake = next((each for each in find_candidates(template, asks) if each.label == name), None)
    return worked(solution, asks, mistake) if mistake else {}


def worked(solution: Solution, asks: Mapping[str, Ask], mistake: Mistake) -> Mapping[str, float]:
    """The answers that can be found, in the asks' units."""
    jotting, template = Jotting(CARRIED), solution.template
    try:
        with jotting.context():
            way = choose_way(mistake, template, find_givens(solution), jotting)
            taken = replace(way, values=write_givens(template, way.values, jotting))
            found = work_out(template, asks, taken, solution.motion.plan, jotting)
    except (KinegradeError, Singular, ArithmeticError):
        return {}
    return {name: float(value) for name, value in found.items() if isfinite(float(value))}


def by_numbers(ask: Ask) -> bool:
    """Whether an ask is worked out by numbers; a centrode is known in closed form."""
    return not needs_configurations(ask.quantity)


def typed(found: Mapping[str, float], figures: int) -> Mapping[str, Answer]:
    """Values as they are typed in, by ask."""
    return {ask: Answer(f"{value:.{figures}g}", value) for ask, value in found.items()}
