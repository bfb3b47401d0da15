"""Whether an instance is fit for students: its solution, or the reason why it is not.

`kinegrade.draws.draw_filter` asks this of the combinations of a deck, `kinegrade check` of a
sample.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite
from typing import Literal

from kinegrade.errors import MechanismError, Problem
from kinegrade.figure.legibility import find_illegible
from kinegrade.figure.sketch import Sketcher
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.holding import choose_wording, condition_holds
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.template import Ask, Template
from kinegrade.problem.tolerance import find_scale_of_mechanism
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.rounding.kept_decimals import RightRange, find_fitting_factor
from kinegrade.students.rounding.rounding import UNBOUNDED, Rounding

SMALLEST, LARGEST = (
    1e-3,
    1e5,
)  # sizes of answers, in the ask's unit, that a student can be asked to write
Reason = Literal[
    #: A student of an exam that is to be avoided had it.
    "earlier",
    #: The template's own conditions do not hold.
    "condition",
    #: The mechanism cannot be assembled, or is at a dead point.
    "mechanism",
    #: An answer is zero that should not be, or is not in other draws.
    "degenerate",
    #: An answer is too large or too small to be asked for.
    "absurd",
    #: Honest rounding could leave the tolerance.
    "rounding",
    #: A known mistake leads to a right answer.
    "mistake",
    #: The right answer is not right with the decimals that the LMS keeps.
    "decimals",
    #: The figure would be hard to read: a symbol has no room, or a part is under 4 mm on paper.
    "figure",
]


class Refused(Exception):
    """A drawn instance is not fit for students; `ask` names the answer to blame, `detail` says
    more.
    """

    def __init__(self, reason: Reason, detail: Problem, ask: str = "") -> None:
        self.reason, self.detail, self.ask = reason, detail, ask
        super().__init__(detail)

    def __str__(self) -> str:
        return open_catalogue(ENGLISH).write(self.detail)


@dataclass(frozen=True)
class Examined:
    """An instance fit for students: its solution, and by ask how far an answer may be off."""

    solution: Solution
    tolerances: Mapping[str, Tolerance]


def name_reason(reason: Reason) -> Message:
    """A reason in a word."""
    return Message(f"template.refused-{reason}")


def solve_sensible(
    template: Template, values: Mapping[str, str], asks: Iterable[str], plan: Plan | None
) -> Solution:
    """The solution of an instance that meets the conditions and whose answers can be asked for.
    Raises Refused.
    """
    try:
        for condition in template.scheme.conditions:
            if not condition_holds(template, condition, values):
                raise Refused("condition", condition.text)
        for name in template.words.texts:
            if choose_wording(template, name, values) is None:
                raise Refused("condition", Message("template.no-text-applies", text=name))
        solution = solve_template(template, values, asks, plan)
    except MechanismError as error:
        reason: Reason = "mechanism" if template.scheme.has_mechanism else "degenerate"
        raise Refused(reason, error.faults[0]) from error
    for name, answer in solution.answers.items():
        if refusal := find_unfit(template.asks[name], answer):
            raise refusal
    require_doubles(solution)
    return solution


def require_doubles(solution: Solution) -> None:
    """Raises Refused for an instance with sizes beyond the doubles in which it is worked out again
    by hand.
    """
    try:
        for answer in solution.answers.values():
            find_scale_of_mechanism(solution.doubles, answer.measure)
    except OverflowError as error:
        raise Refused("absurd", Message("template.size-beyond")) from error


def require_room(
    solution: Solution, accuracy: Accuracy, roundings: Mapping[str, Rounding[float]]
) -> Examined:
    """The solution with the tolerance of each answer. Raises Refused where honest rounding may
    leave one.
    """
    allowed = {}
    for name, tolerance in accuracy.allow(solution, roundings).items():
        if tolerance is None:
            bound = roundings.get(name, UNBOUNDED).bound
            raise Refused("rounding", explain_rounding(name, bound, accuracy), name)
        allowed[name] = tolerance
    return Examined(solution, allowed)


def explain_rounding(ask: str, bound: float, accuracy: Accuracy) -> Message:
    """How far honest rounding may put an answer off."""
    if not isfinite(bound):
        return Message("template.lost-by-rounding", ask=ask, figures=accuracy.carry)
    return Message(
        "template.strays-by-rounding", ask=ask, figures=accuracy.carry, error=f"{bound:.2g}"
    )


def require_legible(solution: Solution, hints: FigureHints, sketcher: Sketcher) -> None:
    """Raises Refused for an instance whose figure with these marks cannot be read well."""
    if not solution.template.scheme.has_mechanism:
        return
    why = find_illegible(solution.assembly.mechanism.map(float), hints, sketcher)
    if why is not None:
        raise Refused("figure", why)


def find_too_fine(examined: Examined) -> str:
    """The first ask whose right answer is no longer right with four decimals, in any unit; "" where
    there is none.
    """
    for name, answer in examined.solution.answers.items():
        value = Fraction(answer.certified)
        right = RightRange(value, *examined.tolerances[name].interval(value))
        if find_fitting_factor(answer.unit, right) is None:
            return name
    return ""


def find_unfit(ask: Ask, answer: Quantity) -> Refused | None:
    """Why an answer cannot be asked for: it is at infinity, zero although the ask does not allow
    it, of an absurd size, or negative where the paper gives it no sign; None if it can.
    """
    if answer.at_infinity:
        return Refused("degenerate", Message("template.at-infinity", ask=ask.name))
    if answer.is_zero:
        return (
            None
            if ask.vanishes
            else Refused("degenerate", Message("template.is-zero", ask=ask.name))
        )
    if not SMALLEST <= abs(answer.value) <= LARGEST:
        size = f"{answer.decimal(3)} {answer.unit}"
        return Refused("absurd", Message("template.is-of-size", ask=ask.name, size=size))
    if lacks_sign(ask, answer):
        return Refused("degenerate", Message("template.is-negative", ask=ask.name), ask.name)
    return None


def lacks_sign(ask: Ask, answer: Quantity) -> bool:
    """Whether an answer is negative although papers say that it is not."""
    return ask.sign in UNSIGNED and answer.is_negative
