"""Published results held against the engine's answers: exactly, or to their printed figures."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

from kinegrade.draws.deck import Combination, make_deck
from kinegrade.errors import ExpressionError, KinegradeError, Problem
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import find_names
from kinegrade.language.lines import shorten
from kinegrade.language.message import Fault, Message, list_all
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Undecided
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Ask, Published, Template
from kinegrade.proof.report import Report

_Proof = tuple[Solution, dict[str, Problem]]  # an instance with what differs there
_PRINTED = re.compile(r"-?\d+\.\d*", re.ASCII)
_NUMBER = re.compile(r"-?0*[1-9]\d*", re.ASCII)
_SHOWN = 10  # digits of an answer that no small field holds
_LONGEST = 60  # characters of an exact answer
_INSTANCES = 5  # values at which a published formula is proved, besides the values it states


def prove_published(report: Report, published: Published) -> None:
    """Compare the published results with the engine's: at the stated values, and at several for
    those left open, of an exact field where there are such.
    """
    where = f"published ({published.source})"
    gives = [name for name in published.gives if name in report.sound]
    proofs, problem = _compare_instances(report, published, gives)
    wrong: dict[str, Fault] = {}
    for solution, found in proofs:
        right = [name for name in gives if name not in found]
        report.rounded += sum(is_printed_decimal(published.texts[name]) for name in right)
        report.proved += len(right)
        for name, fault in found.items():
            place = Message("template.at-instance", where=where, values=_write_instance(solution))
            wrong.setdefault(name, Fault(place, fault))
    report.faults += wrong.values()
    if proofs:
        report.remarks += _note_unmet(report, published, where)
    else:
        what = Message("template.no-instance-solved", reason=problem)
        report.faults.append(Fault(where, what))


def _note_unmet(report: Report, published: Published, where: str) -> Iterator[Message]:
    """The conditions that hold at none of the source's values: seldom what their author means."""
    template = report.template
    instances = _choose_settled(report, published, _INSTANCES)
    for condition in template.scheme.conditions:
        if not any(condition_holds(template, condition, values) for values in instances):
            yield Message("template.source-unmet", where=where, condition=condition.text)


def _compare_instances(
    report: Report, published: Published, gives: Sequence[str]
) -> tuple[list[_Proof], Problem]:
    """The instances at which results are compared, those of an exact field if there are any, and
    why the last one that has no solution has none.
    """
    stated = _list_stated(report.template, published)
    complete = set(stated) == set(report.template.parameters)
    exact: list[_Proof] = []
    inexact: list[_Proof] = []
    problem: Problem = ""
    for values in _choose_settled(report, published, 1 if complete else 20 * _INSTANCES):
        try:
            solution = solve_template(report.template, values, gives)
            found = dict(_find_differences(report.template, published, solution))
            (exact if solution.arithmetic.exact else inexact).append((solution, found))
        except KinegradeError as error:
            problem = error.faults[0]
        except Inexact:
            problem = Message("template.no-small-field")
        if len(exact) == _INSTANCES:
            break
    return exact or inexact[:_INSTANCES], problem


def _choose_settled(report: Report, published: Published, count: int) -> list[Combination]:
    """The values that a source states, with `count` draws of those it leaves open."""
    fixed = {name: (text,) for name, text in _list_stated(report.template, published).items()}
    return make_deck(report.template, report.secret, published.source, fixed).first(count)


def _list_stated(template: Template, published: Published) -> Mapping[str, str]:
    """The values for which results hold; a number other than zero belongs to the data of the
    source.
    """
    texts = published.texts.values()
    if not any(is_printed_decimal(text) or _NUMBER.fullmatch(text) for text in texts):
        return published.given
    parameters = template.parameters.items()
    data = {name: each.published for name, each in parameters if each.published is not None}
    return {**data, **published.given}


def _write_instance(solution: Solution) -> str:
    """The values of an instance, for a message."""
    return ", ".join(
        f"{name} = {quantity.exact or quantity.decimal(6)}"
        for name, quantity in solution.parameters.items()
    )


def _find_differences(
    template: Template, published: Published, solution: Solution
) -> Iterator[tuple[str, Problem]]:
    """The published results that the engine's answers do not meet, by name, and how: a decimal to
    its printed figures, all others exactly, or to within the enclosure where no field holds them.
    """
    for name, answer in solution.answers.items():
        try:
            with solution.arithmetic.context():
                met = _is_met(template.asks[name], published, solution)
        except ExpressionError as error:
            if not answer.at_infinity:  # where it is, neither has a value
                yield name, Fault(name, error.faults[0])
        except Undecided:
            yield name, Fault(name, Message("template.stated-in-no-field"))
        else:
            if not met:
                yield name, _describe_difference(template.asks[name], published, solution)


def _describe_difference(ask: Ask, published: Published, solution: Solution) -> Problem:
    """What the source gives and what the engine gives; of an expression its own value as well, and
    the units in which it counts where they are not those of SI.
    """
    answer, stated = solution[ask.name], published.texts[ask.name]
    parts = {"ask": ask.name, "stated": stated, "given": _write_answer(answer)}
    named = set(find_names(published.gives[ask.name])) & solution.parameters.keys()
    if not named:
        return _advise_point(Message("template.engine-gives", **parts), stated, answer)
    with solution.arithmetic.context():
        value = Quantity(ask.name, _evaluate_stated(ask, published, solution), ask.unit)
        what = Message("template.engine-gives-other", value=_write_answer(value), **parts)
    units = {ask.name: ask.unit} | {
        name: given.measure for name, given in solution.parameters.items() if name in named
    }
    counted = [
        Message("template.counts-in", name=name, unit=unit.printed)
        for name, unit in units.items()
        if unit.text != "1"
    ]
    if all(unit.is_si for unit in units.values()):
        return what
    return Fault("", what, do=Message("template.own-units", units=list_all(counted)))


def _advise_point(what: Message, stated: str, answer: Quantity) -> Problem:
    """The difference; where a whole number is what the answer rounds to, how that is stated."""
    rounded = _NUMBER.fullmatch(stated) is not None and _is_rounded(stated, answer)
    do = Message("template.write-point", stated=f"{stated}.")
    return Fault("", what, do=do) if rounded else what


def _write_answer(answer: Quantity) -> str:
    """An answer as it is compared with a printed one: a root behind its decimal."""
    decimal = answer.decimal(_SHOWN)
    if answer.exact is None or answer.is_plain or answer.at_infinity:
        return answer.exact or decimal
    return f"{decimal} ({shorten(answer.exact, _LONGEST)})"


def _is_met(ask: Ask, published: Published, solution: Solution) -> bool:
    """Whether the engine's answer is the one that the source gives."""
    answer, arithmetic = solution[ask.name], solution.arithmetic
    if is_printed_decimal(published.texts[ask.name]):
        return _is_rounded(published.texts[ask.name], answer)
    expected = _evaluate_stated(ask, published, solution)
    if arithmetic.exact:
        return _is_equal(expected, answer.number, ask, arithmetic)
    return bool(arithmetic.is_zero(_turn_back(expected - answer.number, answer)))


def _evaluate_stated(ask: Ask, published: Published, solution: Solution) -> Any:
    """The value of a published expression, in the ask's unit."""
    arithmetic, tree = solution.arithmetic, published.gives[ask.name]
    functions = make_elementary_functions(arithmetic)
    expected = evaluate(tree, _quote(solution), functions, arithmetic)
    angular = ask.unit.degrees and is_angle(tree, solution.template.angles)
    return expected * 180 / arithmetic.turns(1) if angular and not arithmetic.exact else expected


def is_printed_decimal(text: str) -> bool:
    """Whether a result is stated as a decimal, as a book prints it: `4.08`, not `4` or `204/50`.

    >>> is_printed_decimal("-4.08"), is_printed_decimal("2*omega"), is_printed_decimal("4")
    (True, False, False)
    """
    return _PRINTED.fullmatch(text) is not None


def _is_rounded(stated: str, answer: Quantity) -> bool:
    """Whether an answer is as near to a printed decimal as half a unit of its last place."""
    if answer.at_infinity:
        return False
    printed = Decimal(stated)
    half_unit = Decimal(5).scaleb(int(printed.as_tuple().exponent) - 1)
    return bool(abs(_turn_back(Decimal(answer.certified) - printed, answer)) <= half_unit)


def _turn_back(difference: Any, answer: Quantity) -> Any:
    """A difference of answers, without the full turns in which angles may differ."""
    turn = int(answer.full_turn) if answer.measure.degrees else 0
    return difference - turn * round(float(difference) / turn) if turn else difference


def _quote(solution: Solution) -> dict[str, Any]:
    """The parameters as a source quotes them: numbers in their units, degrees as angles."""
    values: dict[str, Any] = {"pi": solution.arithmetic.turns(1)}
    return values | {name: _quote_given(name, solution) for name in solution.parameters}


def _quote_given(name: str, solution: Solution) -> Any:
    """The number of a parameter; where no field holds the values, enclosed."""
    given = solution.parameters[name]
    if solution.arithmetic.exact:
        return given.number
    value, unit = solution.assembly.values[name], given.measure
    return value if unit.degrees else value / solution.arithmetic.scale(unit.scale)


def _is_equal(expected: Any, answer: Any, ask: Ask, field_: Any) -> bool:
    """Exact equality within one field; angles are equal when they point the same way."""
    number = field_.embed(answer)
    if isinstance(expected, Angle) and ask.unit.time:
        expected = expected.as_number()  # a rate with pi in it, no angle
    if isinstance(number, Angle) or isinstance(expected, Angle):
        if not isinstance(expected, Angle):
            expected = field_.turns(expected / (180 if ask.unit.degrees else 1))
        return bool((expected - number).direction(field_) == (1, 0))
    try:
        return bool(field_.is_zero(expected - number))
    except Inexact:  # different powers of pi
        return False
