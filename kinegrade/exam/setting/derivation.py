"""A question of a paper derived again from what an exam folder keeps: its copy of the template and
the values drawn.

The result is compared with the folder's key, by which marks are decided: a worked solution that
contradicts the key is never made, whether the folder or this program has changed since.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from typing import TypeAlias, assert_never

import msgspec
from msgspec.structs import replace

from kinegrade.draws.deck import Combination
from kinegrade.errors import FieldError, KinegradeError, Problem
from kinegrade.exam.bank.blueprint import BankAsk, BankQuestion
from kinegrade.exam.folder.contradictions import (
    describe_difference,
    explain_contradiction,
    list_names,
)
from kinegrade.exam.folder.key.exact_keys import read_rule
from kinegrade.exam.folder.key.lines import KeyQuestion, StatedAnswer, StatedNumber, StatedTolerance
from kinegrade.exam.folder.numbers import RATIONAL, require_number
from kinegrade.exam.setting.key_record import make_stated_answer
from kinegrade.exam.setting.setting import Drawn, SetAsk, SetQuestion, set_drawn
from kinegrade.language.message import Fault, Message, Part, Text
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.quantity import CERTIFIED_DIGITS, Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.tolerance import (
    find_effective_tolerance,
    find_scale_of_mechanism,
    may_cancel,
)
from kinegrade.students.rounding.rounding import Rounding

# Relative: between certified decimals, between doubles, and where a drawn value is only a double
_CERTIFIED = Fraction(1, 10 ** (CERTIFIED_DIGITS - 2))
_DOUBLE = Fraction(1, 10**15)
_OF_DOUBLES = Fraction(1, 10**9)
_DIGITS_SHOWN = 12


# How rounding bears on the answers at the values that a question has on a paper, by ask
FindRoundings: TypeAlias = Callable[[Combination], Mapping[str, Rounding[float]]]


def derive_question(
    question: BankQuestion,
    kept: KeyQuestion,
    where: Text,
    find_roundings: FindRoundings,
    plan: Plan | None = None,
) -> SetQuestion:
    """The question as it was set for a student whose line of the key says `kept`; `where` names
    that place in messages, `find_roundings` is asked where terms may cancel in an answer, `plan`
    is one that may serve.

    The tolerance of an honest ask is the one that the key keeps, because another version may find
    that rounding takes another; so is an amount next to zero that earlier versions allowed.

    Raises ExamError, with all differences, if the result is not what the key states.
    """
    derived = work_out(question, kept, where, find_roundings, plan)
    differences = list(find_differences(derived, kept))
    if differences:
        raise explain_contradiction(where, differences)
    return derived


def work_out(
    question: BankQuestion,
    kept: KeyQuestion,
    where: Text,
    find_roundings: FindRoundings,
    plan: Plan | None = None,
) -> SetQuestion:
    """The question with the values that its key keeps, whatever follows from them.

    Raises ExamError where nothing does.
    """
    solution = _solve(question, kept, where, plan)
    roundings = (
        find_roundings(kept.values)
        if any(_may_cancel(ask, solution) for ask in question.asks)
        else {}
    )
    tolerances = {
        ask.name: _find_tolerance(ask, solution, roundings.get(ask.name), kept, where)
        for ask in question.asks
    }
    return set_drawn(question, Drawn(kept.values, solution), tolerances)


def _solve(question: BankQuestion, kept: KeyQuestion, where: Text, plan: Plan | None) -> Solution:
    asks = tuple(ask.name for ask in question.asks)
    try:
        return solve_template(question.template, kept.values, asks, plan)
    except KinegradeError as error:
        reasons = (Message("exam.no-longer-follows", reason=each) for each in error.faults)
        raise explain_contradiction(where, reasons) from error


def _may_cancel(ask: BankAsk, solution: Solution) -> bool:
    answer = solution[ask.name]
    return may_cancel(ask.tolerance, answer.value, answer.measure, solution.doubles)


def _find_tolerance(
    ask: BankAsk,
    solution: Solution,
    rounding: Rounding[float] | None,
    kept: KeyQuestion,
    where: Text,
) -> Tolerance:
    """The tolerance by which an answer is marked: that of an honest ask as the key keeps it, but
    never less than the bank's; with what holds next to zero, where `rounding` says how it bears on
    the answer.
    """
    stated = ask.tolerance
    if rounding is not None:
        stated = find_effective_tolerance(stated, solution[ask.name].value, rounding.largest)
    answer = kept.asks.get(ask.name)
    if answer is None or not (ask.honest or _may_cancel(ask, solution)):
        return stated
    try:
        rule = read_rule(answer.tolerance)
    except FieldError as error:
        raise explain_contradiction(where, error.faults) from error
    if _may_cancel(ask, solution) and rule.absolute == _find_earlier_room(ask, solution):
        stated = replace(stated, absolute=rule.absolute)
    return replace(stated, relative=max(rule.relative, stated.relative)) if ask.honest else stated


def _find_earlier_room(ask: BankAsk, solution: Solution) -> Fraction:
    """What versions up to 0.2 allow next to zero: a share of the mechanism's scale."""
    scale = find_scale_of_mechanism(solution.doubles, solution[ask.name].measure)
    return ask.tolerance.share * scale


def find_differences(derived: SetQuestion, kept: KeyQuestion) -> Iterator[Problem]:
    """The differences between a question and its key, each with both values."""
    parameters = derived.drawn.solution.parameters
    asks = {entry.ask.name: entry for entry in derived.asks}
    if set(parameters) != set(kept.parameters):
        yield Message("exam.parameters-differ", **_name_both(parameters, kept.parameters))
    if set(asks) != set(kept.asks):
        yield Message("exam.asks-of-templates-differ", **_name_both(asks, kept.asks))
    for name, quantity in parameters.items():
        if name in kept.parameters:
            yield from _find_value_differences(name, quantity, kept.parameters[name], _CERTIFIED)
    room = _CERTIFIED if _exactly_drawn(kept) else _OF_DOUBLES
    for name, entry in asks.items():
        if name in kept.asks:
            yield from _find_value_differences(name, entry.answer, kept.asks[name], room)
            yield from _find_term_differences(entry, kept.asks[name])


def _exactly_drawn(kept: KeyQuestion) -> bool:
    """Whether the values drawn are known exactly."""
    return bool(kept.drawn) or all(each.exact is not None for each in kept.parameters.values())


def _name_both(derived: Collection[str], kept: Collection[str]) -> dict[str, Part]:
    """The names on both sides of a difference, as parts of a message."""
    return {"found": list_names(sorted(kept)), "derived": list_names(sorted(derived))}


def _find_value_differences(
    name: str, derived: Quantity, kept: StatedNumber | StatedAnswer, room: Fraction
) -> Iterator[Message]:
    """Where a quantity differs from the key: in its unit, or in one of the forms of its value,
    which is said once.

    An exact form that is no plain number is not compared: it may be printed in many ways, and
    marks go by its decimal.
    """
    if derived.unit != kept.unit:
        yield Message("exam.unit-differs", name=name, found=kept.unit, derived=derived.unit)
    plain = kept.exact if kept.exact is not None and RATIONAL.fullmatch(kept.exact) else None
    stated = (
        ("exact", plain, room),
        ("decimal", kept.decimal, room),
        ("value", kept.value, max(room, _DOUBLE)),
    )
    for way, found, allowed in stated:
        if found is not None and not _agree(way, found, derived, allowed):
            yield describe_difference(name, str(found), derived.decimal(_DIGITS_SHOWN))
            return
    if all(found is None for _, found, _ in stated):
        yield Message("exam.no-value", name=name)


def _agree(way: str, found: Decimal | str, derived: Quantity, room: Fraction) -> bool:
    """Whether a number of the key is the derived one, except for its last digits."""
    if derived.at_infinity:
        return False
    try:
        kept = require_number(way, found)
    except FieldError:
        return False
    right = Fraction(derived.certified)
    return abs(kept - right) <= room * abs(right)


def _find_term_differences(entry: SetAsk, kept: StatedAnswer) -> Iterator[Fault]:
    """Where the terms by which an answer is marked are not those of the key."""
    derived = make_stated_answer(entry, {})
    terms = (
        ("tolerance", derived.tolerance, kept.tolerance),
        ("period", derived.period, kept.period),
        ("points", derived.points, kept.points),
    )
    for term, ours, theirs in terms:
        if ours != theirs:
            found, derives = _write_value(theirs), _write_value(ours)
            what = Message("exam.term-differs", term=term, found=found, derived=derives)
            yield Fault(entry.ask.name, what)


def _write_value(term: StatedTolerance | Decimal | None) -> Text:
    match term:
        case None:
            return Message("grammar.no-names")
        case Decimal():
            return str(term)
        case StatedTolerance():
            stated = msgspec.structs.asdict(term).items()
            return ", ".join(f"{name} {amount}" for name, amount in stated if amount is not None)
        case _:
            assert_never(term)
