"""Published results held against the engine's answers, exactly."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kinegrade.draws.deck import Combination, make_deck
from kinegrade.errors import ExpressionError, KinegradeError, Problem
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.angle import Angle, Inexact
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Ask, Published, Template
from kinegrade.proof.report import Report

_Proof = tuple[Solution, dict[str, Problem]]  # an instance with what differs there
_INSTANCES = 5  # values at which a published formula is proved, besides the values it states


def prove_published(report: Report, published: Published) -> None:
    """Compare the published results with the engine's: at the stated values, and at several for
    those left open, of an exact field where there are such.
    """
    where, complete = (
        f"published ({published.source})",
        set(published.given) == set(report.template.parameters),
    )
    proofs: list[_Proof] = []
    inexact: list[_Proof] = []
    problem: Problem = ""
    gives = [name for name in published.gives if name in report.sound]
    for values in _choose_settled(report, published, 1 if complete else 20 * _INSTANCES):
        try:
            solution = solve_template(report.template, values, gives)
            found = dict(_find_differences(report.template, published, solution))
            (proofs if solution.arithmetic.exact else inexact).append((solution, found))
        except KinegradeError as error:
            problem = error.faults[0]
        except Inexact:
            problem = Message("template.no-small-field")
        if len(proofs) == _INSTANCES:
            break
    wrong: dict[str, Fault] = {}
    proofs = proofs or inexact[:_INSTANCES]
    for solution, found in proofs:
        report.proved += len(gives) - len(found)
        for name, fault in found.items():
            place = Message("template.at-instance", where=where, values=_write_instance(solution))
            wrong.setdefault(name, Fault(place, fault))
    report.faults += wrong.values()
    if not proofs:
        what = Message("template.no-instance-solved", reason=problem)
        report.faults.append(Fault(where, what))


def _choose_settled(report: Report, published: Published, count: int) -> list[Combination]:
    """The values that a source states, with `count` draws of those it leaves open."""
    fixed = {name: (text,) for name, text in published.given.items()}
    return make_deck(report.template, report.secret, published.source, fixed).first(count)


def _write_instance(solution: Solution) -> str:
    """The values of an instance, for a message."""
    return ", ".join(
        f"{name} = {quantity.exact or quantity.decimal(6)}"
        for name, quantity in solution.parameters.items()
    )


def _find_differences(
    template: Template, published: Published, solution: Solution
) -> Iterator[tuple[str, Problem]]:
    """The published results that the engine's answers do not equal exactly, by name, and how."""
    for name, answer in solution.answers.items():
        ask, tree = template.asks[name], published.gives[name]
        try:
            expected = evaluate(
                tree,
                _quote(solution),
                make_elementary_functions(solution.arithmetic),
                solution.arithmetic,
            )
        except ExpressionError as error:
            yield name, Fault(name, error.faults[0])
            continue
        if not solution.arithmetic.exact:
            yield name, Fault(name, Message("template.stated-in-no-field"))
        elif not _is_equal(expected, answer.number, ask, solution.arithmetic):
            stated, given = published.texts[name], str(answer.exact)
            yield name, Message("template.engine-gives", ask=name, stated=stated, given=given)


def _quote(solution: Solution) -> dict[str, Any]:
    """The parameters as a source quotes them: numbers in their units, degrees as angles."""
    values = {name: quantity.number for name, quantity in solution.parameters.items()}
    return {**values, "pi": solution.arithmetic.turns(1)}


def _is_equal(expected: Any, answer: Any, ask: Ask, field_: Any) -> bool:
    """Exact equality within one field; angles are equal when they point the same way."""
    number = field_.embed(answer)
    if isinstance(number, Angle) or isinstance(expected, Angle):
        if not isinstance(expected, Angle):
            expected = field_.turns(expected / 180) if ask.unit.degrees else field_.turns(expected)
        return bool((expected - number).direction(field_) == (1, 0))
    return bool(field_.is_zero(expected - number))
