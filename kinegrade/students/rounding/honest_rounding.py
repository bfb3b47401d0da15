"""How far off a student can be who works correctly and writes every intermediate value down
rounded.

Three ways of working are followed, because none is the strictest everywhere:

by coordinates, where each constructed point is written down and used for the next; by arms, where
positions stay in the calculator, and lengths, directions and every term of a vector equation are
written down; sparingly, where the solved rates alone are written down.

Given lengths and angles are used as the paper states them; rates are written down, given ones too.
The answer counts as it comes out, and rounded like everything else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import pi
from typing import Any

from kinegrade.errors import KinegradeError
from kinegrade.expressions.evaluation import (
    evaluate,
    make_elementary_functions,
)
from kinegrade.language.message import Message
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.rounding import Rounded, Sparing
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.assemble import assemble
from kinegrade.problem.quantities.functions import make_quantities, needs_configurations
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.students.rounding.by_hand import solve_by_hand, write_down
from kinegrade.students.rounding.targets import find_targets, list_carried_figures

_DEGREES = 180 / pi  # as `math.degrees` has it
LOST = (
    KinegradeError,
    Singular,
    ValueError,
    ZeroDivisionError,
)  # rounded circles that do not meet, a dead point


@dataclass(frozen=True)
class Stray:
    """An answer that honest work leaves too far off: the result with that many significant figures,
    in the ask's unit; None where rounding makes it impossible to find.
    """

    ask: str
    figures: int
    answer: float | None

    def said(self) -> Message:
        """What becomes of the answer, in a line."""
        ask, figures = self.ask, self.figures
        if self.answer is None:
            return Message("template.lost-by-rounding", ask=ask, figures=figures)
        answer = f"{self.answer:.6g}"
        return Message("template.strays-by-rounding", ask=ask, figures=figures, answer=answer)


def find_stray(solution: Solution, tolerances: Mapping[str, Tolerance]) -> Stray | None:
    """The first answer that honest work leaves outside its tolerance (1 % where none is stated), if
    there is one.
    """
    aims = find_targets(solution, tolerances)
    for figures, every in list_carried_figures(aims):
        concerned = {
            name: aim for name, aim in aims.items() if aim.figures in (figures, figures - 1)
        }
        for worked in work_honestly(solution, solution.doubles, figures, every=every):
            for name, aim in concerned.items():
                if not aim.met(worked.get(name), figures):
                    return Stray(name, figures, worked.get(name))
    return None


def work_honestly(
    solution: Solution, motion: Motion, figures: int, *, every: bool
) -> Iterator[dict[str, float]]:
    """The answers of honest students who carry so many significant figures, in the asks' units;
    what cannot be found is left out. `motion` is the solution's in doubles. All three ways where
    `every` is true, else the quickest one.
    """
    yield work_by_arms(solution, motion, Rounded(figures))
    if every:
        yield work_by_arms(solution, motion, Sparing(figures))
        yield work_by_coordinates(solution, Rounded(figures))


def work_by_coordinates(solution: Solution, rounded: Rounded) -> dict[str, float]:
    """The answers of a student who writes every constructed point down and continues from it."""
    template = solution.template
    givens = {name: convert_number(solution.assembly.values[name]) for name in template.parameters}
    try:
        assembly = assemble(template, givens, rounded, lambda point: write_down(point, rounded))
        motion = Motion(build_frames(assembly.mechanism, rounded), solution.motion.plan, {}, {})
        return _find_answers(
            solution, assembly.values, assembly.functions, solve_by_hand(motion, rounded), rounded
        )
    except LOST:
        return {}


def work_by_arms(solution: Solution, motion: Motion, rounded: Rounded) -> dict[str, float]:
    """The answers of a student who keeps positions in the calculator; `rounded` determines what
    else is written down.
    """
    values = {
        name: convert_value(value)
        for name, value in solution.assembly.values.items()
        if name not in motion.points
    }
    functions = {**make_elementary_functions(rounded), **make_constructions(rounded, motion.points)}
    try:
        return _find_answers(
            solution,
            {**values, **motion.points},
            functions,
            solve_by_hand(motion, rounded),
            rounded,
        )
    except LOST:
        return {}


def _find_answers(
    solution: Solution,
    values: Mapping[str, Any],
    functions: Mapping[str, Callable[..., Any]],
    motion: Motion,
    rounded: Rounded,
) -> dict[str, float]:
    """The answers that a motion worked out by hand gives, without those that cannot be found."""
    known = {**find_body_names(motion.frames.mechanism), **values}
    may_call = {**functions, **make_quantities(motion, rounded)}
    found = {
        name: _work_answer(solution.template.asks[name], answer, known, may_call, rounded)
        for name, answer in solution.answers.items()
    }
    return {name: number for name, number in found.items() if number is not None}


def _work_answer(
    ask: Ask,
    answer: Quantity,
    values: Mapping[str, Any],
    functions: Mapping[str, Callable[..., Any]],
    rounded: Rounded,
) -> float | None:
    """One answer in its unit; a centrode is not worked out by numbers but known in closed form."""
    if needs_configurations(ask.quantity):
        return answer.value
    try:
        number = convert_number(evaluate(ask.quantity, values, functions, rounded))
    except LOST:
        return None
    answered: float = (
        number * _DEGREES if ask.unit.degrees else number / convert_number(ask.unit.factor)
    )
    return answered


def convert_value(value: Any) -> Any:
    """A value that expressions may name, in doubles: a number, a point or a word."""
    if isinstance(value, str):
        return value
    return value.map(float) if isinstance(value, Vector) else convert_number(value)
