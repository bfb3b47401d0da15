"""The author's proof of a template: its published results hold exactly, and what is drawn is fit for students."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.exact.angle import Angle
from kinegrade.expression import elementary, evaluate
from kinegrade.problem.drawing import Deck, Refused, address, examine
from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.statement import check_statements
from kinegrade.problem.template import Ask, Published, Template

INSTANCES = 5  # values at which a published formula is proved, besides the values it states


@dataclass
class Report:
    """What the check of a template found; `faults` is empty when the template is sound."""

    template: Template
    proved: int = 0
    instances: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    smallest: dict[str, float] = field(default_factory=dict)
    largest: dict[str, float] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)


def check(template: Template, sample: int = 200) -> Report:
    """Check published results exactly, and `sample` drawn instances (all, where there are no more)."""
    report = Report(template)
    check_statements(template)
    if not template.published:
        report.faults.append("no published result: a template is finished when [[published]] proves it")
    for published in template.published:
        prove(report, published)
    for values in drawable(template, sample):
        try:
            solution = examine(template, values, template.asked())
        except Refused as refusal:
            report.refused[refusal.reason] += 1
            continue
        note(report, solution)
    if not report.instances:
        report.faults.append("no acceptable instance was found: widen the domains or relax the conditions")
    return report


def drawable(template: Template, sample: int) -> Iterator[Mapping[str, str]]:
    """Values of `sample` different combinations, evenly addressed; all of them where there are no more."""
    total = template.combinations
    if total <= sample:
        yield from (combination(template, index) for index in range(total))
        return
    addresses = (address("check", template.name, number) % total for number in range(3 * sample))
    yield from (combination(template, index) for index in islice(dict.fromkeys(addresses), sample))


def combination(template: Template, index: int) -> dict[str, str]:
    """The combination of that index, counting through the domains."""
    values = {}
    for name, parameter in template.parameters.items():
        index, place = divmod(index, len(parameter.choices))
        values[name] = parameter.choices[place]
    return values


def note(report: Report, solution: Solution) -> None:
    """Count an accepted instance and the spread of its answers."""
    report.instances += 1
    for name, answer in solution.answers.items():
        value = answer.value
        report.smallest[name] = min(value, report.smallest.get(name, value))
        report.largest[name] = max(value, report.largest.get(name, value))


def prove(report: Report, published: Published) -> None:
    """Hold the published results against the engine: at the stated values, and at several for those left open."""
    template = report.template
    deck = Deck(template, template.asked(), "published", published.source,
                {name: (text,) for name, text in published.given.items()})
    wanted = 1 if set(published.given) == set(template.parameters) else INSTANCES
    shown = 0
    for attempt in range(20 * INSTANCES):
        values = {**deck.values("check", attempt), **published.given}
        try:
            solution = solve_template(template, values, published.gives)
        except MechanismError as error:
            if wanted == 1:
                report.faults.append(f"published ({published.source}): {error.problems[0]}")
                return
            continue
        report.faults += [f"published ({published.source}) at {values}: {fault}"
                          for fault in differences(template, published, solution)]
        shown += 1
        if shown == wanted:
            break
    report.proved += shown * len(published.gives)


def differences(template: Template, published: Published, solution: Solution) -> Iterator[str]:
    """The published results that the engine's answers do not equal exactly."""
    for name, tree in published.gives.items():
        ask, answer = template.asks[name], solution[name]
        try:
            expected = evaluate(tree, quoted(solution), elementary(solution.arithmetic), solution.arithmetic)
        except ExpressionError as error:
            yield f"{name}: {error.problems[0]}"
            continue
        if not solution.arithmetic.exact:
            yield f"{name}: the stated values lie in no small exact field: state values that prove it exactly"
        elif not equal(expected, answer.number, ask, solution.arithmetic):
            yield f"{name} = {published.texts[name]}, but the engine gives {answer.exact}"


def quoted(solution: Solution) -> dict[str, Any]:
    """The parameters as a source quotes them: numbers of their own unit, degrees as angles."""
    values = {name: quantity.number for name, quantity in solution.parameters.items()}
    return {**values, "pi": solution.arithmetic.turns(1)}


def equal(expected: Any, answer: Any, ask: Ask, field_: Any) -> bool:
    """Exact equality within one field; angles are equal when they point the same way."""
    number = field_.embed(answer)
    if isinstance(number, Angle) or isinstance(expected, Angle):
        if not isinstance(expected, Angle):
            expected = field_.turns(expected / 180) if ask.unit.degrees else field_.turns(expected)
        return bool((expected - number).direction(field_) == (1, 0))
    return bool(field_.is_zero(expected - number))
