"""Solving an instance: exactly where a small field holds its values, by certified balls everywhere else."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from flint import arb

from kinegrade.errors import ExpressionError, KinegradeError, MechanismError, TemplateError, did_you_mean
from kinegrade.exact.angle import Inexact
from kinegrade.exact.balls import PRECISIONS, Balls, Undecided
from kinegrade.exact.field import Field
from kinegrade.expression import Expression, evaluate, read
from kinegrade.mechanics.motion import Motion, solve
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.assemble import Assembly, assemble, parameter_value
from kinegrade.problem.quantities import body_names, quantities
from kinegrade.problem.quantity import Quantity, in_unit
from kinegrade.problem.template import Ask, Parameter, Template

Result = TypeVar("Result")
CERTIFIED = 120  # bits: an enclosure counts as certified when narrower than 2^-120, below 1e-36, relative


@dataclass(frozen=True)
class Solution:
    """An instance solved: its parameters and answers in their units, and the motion they come from."""

    template: Template
    parameters: Mapping[str, Quantity]
    answers: Mapping[str, Quantity]
    assembly: Assembly
    motion: Motion
    arithmetic: Any

    def __getitem__(self, ask: str) -> Quantity:
        """The answer of an ask."""
        return self.answers[ask]


def solve_template(template: Template, given: Mapping[str, str], asks: Iterable[str] | None = None,
                   plan: Plan | None = None) -> Solution:
    """Solve `template` at the values given as texts in the parameters' units; the rest take their default.

    Raises TemplateError for unknown names or unreadable values, MechanismError with the reason in mechanics.
    """
    trees = read_values(template, given)
    wanted = require_asks(template, asks)
    try:
        return certified(lambda arithmetic: attempt(template, trees, wanted, plan, arithmetic))
    except (ExpressionError, MechanismError) as error:
        raise MechanismError(*(f"{template.name}: {problem}" for problem in error.problems)) from error


def certified(work: Callable[[Any], Result]) -> Result:
    """What `work` gives in the first arithmetic that holds its values: exact, then balls of growing precision.

    Raises MechanismError when even the narrowest balls leave a sign or a pivot open.
    """
    for arithmetic in (Field(), *(Balls(precision) for precision in PRECISIONS)):
        try:
            with arithmetic.context():
                return work(arithmetic)
        except (Inexact, Undecided):
            continue
    raise MechanismError("at these values the configuration cannot be told from a degenerate one "
                         f"even with {PRECISIONS[-1]} bits: choose other values")


def read_values(template: Template, given: Mapping[str, str]) -> dict[str, Expression]:
    """The trees of all parameters' values. Raises TemplateError with every fault."""
    faults, trees = [], {}
    for name in given:
        if name not in template.parameters:
            faults.append(f'{template.name}: no parameter "{name}": {did_you_mean(name, template.parameters)}')
    for name, parameter in template.parameters.items():
        text = given.get(name, parameter.default)
        try:
            trees[name] = read(text)
            check_number(parameter, trees[name])
        except KinegradeError as error:
            faults += [f"{template.name}: {name} = {text[:60]}: {problem}" for problem in error.problems]
    if faults:
        raise TemplateError(*faults)
    return trees


def check_number(parameter: Parameter, tree: Expression) -> None:
    """Raises ExpressionError for a value that is no number at all (unknown names, roots of negative numbers)."""
    try:
        parameter_value(parameter, tree, Field())
    except Inexact:
        with Balls(PRECISIONS[0]).context():
            parameter_value(parameter, tree, Balls(PRECISIONS[0]))


def require_asks(template: Template, asks: Iterable[str] | None) -> tuple[Ask, ...]:
    """The asks named, or all. Raises TemplateError for unknown ones."""
    chosen = tuple(template.asks if asks is None else asks)
    unknown = [f'{template.name}: no ask "{name}": {did_you_mean(name, template.asks)}'
               for name in chosen if name not in template.asks]
    if unknown:
        raise TemplateError(*unknown)
    return tuple(template.asks[name] for name in chosen)


def attempt(template: Template, trees: Mapping[str, Expression], asks: Iterable[Ask], plan: Plan | None,
            arithmetic: Any) -> Solution:
    """Solve in one arithmetic. Raises Inexact or Undecided when another is needed."""
    values = {name: parameter_value(parameter, trees[name], arithmetic)
              for name, parameter in template.parameters.items()}
    assembly = assemble(template, values, arithmetic)
    motion = solve(assembly.mechanism, arithmetic, plan)
    answers = {ask.name: answer(ask, assembly, motion, arithmetic) for ask in asks}
    return Solution(template, givens(template, trees, values), answers, assembly, motion, arithmetic)


def answer(ask: Ask, assembly: Assembly, motion: Motion, arithmetic: Any) -> Quantity:
    """The answer of one ask; roots that it alone needs stay out of the others' field."""
    own = arithmetic.fork()
    values = {**body_names(assembly.mechanism), **assembly.values}
    functions = {**assembly.functions, **quantities(motion, own)}
    try:
        quantity = in_unit(ask.name, evaluate(ask.quantity, values, functions, own), ask.unit)
    except KinegradeError as error:
        raise type(error)(*(f"{ask.name}: {problem}" for problem in error.problems)) from error
    require_certified(quantity.number)
    return quantity


def require_certified(number: Any) -> None:
    """Raises Undecided for a ball that is too wide to be a reference."""
    if isinstance(number, arb) and 0 not in number and number.rel_accuracy_bits() < CERTIFIED:
        raise Undecided("an enclosure is too wide")


def givens(template: Template, trees: Mapping[str, Expression], values: Mapping[str, Any]) -> dict[str, Quantity]:
    """The parameters in their units, exact wherever they are, whatever arithmetic the instance needed."""
    found = {}
    for name, parameter in template.parameters.items():
        try:
            number = parameter_value(parameter, trees[name], Field())
        except Inexact:
            number = values[name]
        found[name] = in_unit(name, number, parameter.unit)
    return found
