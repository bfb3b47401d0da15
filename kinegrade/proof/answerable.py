"""Whether each ask of a template can be answered at its drawn values, including those that are
asked only on request.

`check` examines each by itself, because a bank may ask for any of them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field

from kinegrade.draws.examining import find_unfit, lacks_sign
from kinegrade.errors import KinegradeError, Problem
from kinegrade.language.message import Fault, Message, Part
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template

_DIGITS = 30  # of a given that no small field holds


@dataclass
class Answerable:
    """What was found about a template's asks.

    `failed` has those that cannot be worked out at some drawn values, or are negative there though
    papers say that they are not, with these values and the reason; `fit` counts the instances in
    which an ask has a proper answer, `unfit` says why it had none. `solved` counts the instances
    that meet the conditions and move, `stuck` is why none did.
    """

    template: Template
    failed: dict[str, Fault] = field(default_factory=dict)
    fit: Counter[str] = field(default_factory=Counter)
    unfit: dict[str, Part] = field(default_factory=dict)
    solved: int = 0
    stuck: Fault | None = None
    plan: Plan | None = None

    @property
    def sound(self) -> tuple[str, ...]:
        """The asks that can be worked out at all drawn values."""
        return tuple(name for name in self.template.asks if name not in self.failed)

    def look(self, values: Mapping[str, str]) -> None:
        """Work out every ask at drawn values that meet the conditions."""
        if not all(
            condition_holds(self.template, condition, values)
            for condition in self.template.scheme.conditions
        ):
            return
        try:
            together = self.solution(values, self.sound)
        except KinegradeError:
            self._look_at_each(values)
            return
        self.solved += 1
        for name in together.answers:
            self.note(name, together, values)

    def _look_at_each(self, values: Mapping[str, str]) -> None:
        """Work out the asks one by one, where they cannot be worked out together."""
        try:
            self.solution(values, ())
        except KinegradeError as error:
            self.stuck = self.stuck or _describe_failure(values, error.faults[0])
            return
        self.solved += 1
        for name in self.sound:
            try:
                self.note(name, self.solution(values, (name,)), values)
            except KinegradeError as error:
                problem = _find_reason(error.faults[0], (self.template.name, name))
                self.failed[name] = _describe_failure(values, problem)

    def solution(self, values: Mapping[str, str], asks: Iterable[str]) -> Solution:
        """The instance solved for some asks. Raises MechanismError."""
        found = solve_template(self.template, values, asks, self.plan)
        self.plan = self.plan or found.motion.plan
        return found

    def note(self, name: str, solution: Solution, values: Mapping[str, str]) -> None:
        """Count an answer, or keep the reason why it is not a proper one."""
        if lacks_sign(self.template.asks[name], solution[name]):
            negative = Message("template.is-negative", ask=name)
            advised = Fault("", negative, do=Message("template.state-sign"))
            self.failed[name] = _describe_failure(values, advised)
            return
        refusal = find_unfit(self.template.asks[name], solution[name])
        if refusal is None:
            self.fit[name] += 1
        else:
            self.unfit.setdefault(name, refusal.detail)

    def faults(self) -> list[Fault]:
        """A line for every ask that is unusable at some values, or at all of them."""
        lines = [Fault(f"asks.{name}", problem) for name, problem in self.failed.items()]
        for name in self.sound:
            if self.solved and not self.fit[name]:
                what = Message("template.nothing-to-ask", reason=self.unfit[name])
                lines.append(Fault(f"asks.{name}", what))
        return lines


def _describe_failure(values: Mapping[str, str], problem: Problem) -> Fault:
    return Fault(Message("template.at-values", values=write_values(values)), problem)


def _find_reason(problem: Problem, places: Collection[str]) -> Problem:
    """A problem without the places, outermost, that are named anyway."""
    while isinstance(problem, Fault) and problem.where in places:
        problem = problem.what
    return problem


def find_answerable(template: Template, draws: Iterable[Mapping[str, str]]) -> Answerable:
    """What is found about the template's asks at these values."""
    found = Answerable(template)
    for values in draws:
        found.look(values)
    return found


def list_values(solution: Solution) -> dict[str, str]:
    """The givens of an instance as texts, by which it is solved again."""
    return {
        name: given.exact or given.decimal(_DIGITS) for name, given in solution.parameters.items()
    }


def write_values(values: Mapping[str, str]) -> str:
    """Values for a message: "r = 1, phi = 30"."""
    return ", ".join(f"{name} = {text}" for name, text in values.items())
