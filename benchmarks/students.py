"""Simulated students: those who work rightly with rounded numbers, and those who make a known
mistake.

Each gives for every paper of a class what is typed in, by ask. Working by hand is that of
`kinegrade.students.rounding.honest_rounding`; the unpromised ways round in another manner, so that
they are no copy of what draws are accepted by.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import isfinite
from random import Random
from typing import Any

from benchmarks.simulated_class import FIGURES, Answer, SimulatedClass
from kinegrade.errors import KinegradeError
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.rounding import Rounded, Sparing
from kinegrade.problem.quantities.functions import needs_configurations
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.students.mistake_kinds import Mistake, find_candidates
from kinegrade.students.mistakes import choose_way, work_out
from kinegrade.students.rounding.honest_rounding import (
    LOST,
    work_by_arms,
    work_by_coordinates,
)

CARRIED = 3
DISPLAY = 10  # digits of a calculator
EVERY = 10  # of so many papers one is also worked out with a mistake and rounded numbers

Answers = list[Mapping[str, Answer]]
Working = Callable[[Solution, Rounded], Mapping[str, float]]


class Moody(Rounded):
    """The arithmetic of one who writes some intermediate values down rounded, and keeps others in
    the calculator.
    """

    def __init__(self, figures: int, chance: Random) -> None:
        super().__init__(figures)
        self.chance = chance

    def written(self, number: float) -> float:
        """The number, rounded half of the time."""
        return (
            super().written(number)
            if self.chance.random() < 0.5
            else Sparing(self.figures).noted(number)
        )


class Vague(Moody):
    """The arithmetic of one whose intermediate values may be off by anything that rounding can
    leave.
    """

    def written(self, number: float) -> float:
        """The number and up to half a unit of its last figure more or less, with equal
        probability.
        """
        rounded = Rounded(self.figures).written(number)
        if not rounded:
            return 0.0
        unit = 10.0 ** (int(f"{rounded:e}".partition("e")[2]) + 1 - self.figures)
        return number + self.chance.uniform(-0.5, 0.5) * unit


def arms(solution: Solution, rounded: Rounded) -> Mapping[str, float]:
    """Worked by arms: positions stay in the calculator."""
    return work_by_arms(solution, solution.motion.map(float), rounded)


def honest_students(simulated: SimulatedClass) -> Iterator[tuple[str, Answers]]:
    """The three ways in which full marks are promised, each typed in with three figures, with four
    and with all.
    """
    ways: tuple[tuple[str, Working, Rounded], ...] = (
        ("by coordinates", work_by_coordinates, Rounded(CARRIED)),
        ("by arms", arms, Rounded(CARRIED)),
        ("rates alone rounded", arms, Sparing(CARRIED)),
    )
    for way, working, rounded in ways:
        found = [working(paper.questions[0].drawn.solution, rounded) for paper in simulated.papers]
        for figures in (CARRIED, CARRIED + 1, DISPLAY):
            yield f"{way}, {figures} figures typed in", [typed(each, figures) for each in found]


def unpromised_students(simulated: SimulatedClass) -> Iterator[tuple[str, Answers]]:
    """Other ways of rounding, three figures typed in."""
    ways: tuple[tuple[str, Working, type[Moody]], ...] = (
        ("by coordinates, some values rounded", work_by_coordinates, Moody),
        ("by arms, some values rounded", arms, Moody),
        ("by coordinates, any error within rounding", work_by_coordinates, Vague),
        ("by arms, any error within rounding", arms, Vague),
    )
    for way, working, arithmetic in ways:
        chance = Random(f"{way} {simulated.number}")
        yield (
            way,
            [
                typed(
                    working(paper.questions[0].drawn.solution, arithmetic(CARRIED, chance)), CARRIED
                )
                for paper in simulated.papers
            ],
        )


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
    mistake = next(
        (each for each in find_candidates(template, asks) if each.identifier == name), None
    )
    return worked(solution, asks, mistake) if mistake else {}


def worked(solution: Solution, asks: Mapping[str, Ask], mistake: Mistake) -> Mapping[str, float]:
    """The answers that can be found, in the asks' units."""
    rounded, template = Rounded(CARRIED), solution.template
    values: Mapping[str, Any] = {
        name: convert_number(solution.assembly.values[name]) for name in template.parameters
    }
    try:
        found = work_out(
            template,
            asks,
            choose_way(mistake, template, values, rounded),
            solution.motion.plan,
            rounded,
        )
    except (*LOST, KinegradeError, Singular):
        return {}
    return {name: float(value) for name, value in found.items() if isfinite(value)}


def by_numbers(ask: Ask) -> bool:
    """Whether an ask is worked out by numbers; a centrode is known in closed form."""
    return not needs_configurations(ask.quantity)


def typed(found: Mapping[str, float], figures: int) -> Mapping[str, Answer]:
    """Values as they are typed in, by ask."""
    return {ask: Answer(f"{value:.{figures}g}", value) for ask, value in found.items()}
