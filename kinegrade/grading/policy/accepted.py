"""Answers that a policy accepts beside the key, worked out for every paper.

`alternatives` is called by `grade`. Values are expressions in the grammar of templates: exact where
a small field holds them, otherwise known to 38 digits. A name in them is a parameter of the
question or one of its right answers, in SI units.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from types import MappingProxyType
from typing import Any, assert_never

from kinegrade.errors import ExpressionError, PolicyError
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import find_names
from kinegrade.grading.policy.policy import Accepted, Policy
from kinegrade.grading.typed.amount import PRECISION, Amount, convert, make_rational_amount
from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.grading.typed.unit_spelling import WrittenUnit, read_unit
from kinegrade.language.message import Fault, Message, Part, Quoted, list_first
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls, Undecided
from kinegrade.numbers.field import Field
from kinegrade.numbers.refusals import Inexact

_PURE = WrittenUnit(Fraction(1), 0, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class Alternative:
    """An accepted answer on one paper, in the ask's unit; `error` bounds how far an irrational
    value may be off.
    """

    accepted: Accepted
    value: Fraction
    error: Fraction


_Number = tuple[str | Fraction, str]  # the text of a given or a right answer, and its unit
# Student, the student whose line of the key holds the ask, answer column
Which = tuple[str, str, str]
Alternatives = Mapping[Which, tuple[Alternative, ...]]
_Failure = ExpressionError | Unreadable | ArithmeticError
_NO_SOURCES: Mapping[str, Paper] = MappingProxyType({})


def alternatives(
    exam: Sitting,
    policy: Policy,
    folder: ExamFolder,
    pooled: Iterable[Paper] = (),
    sources: Mapping[str, Paper] = _NO_SOURCES,
) -> Alternatives:
    """All accepted answers for all papers, including those put together from a pool.

    `sources` are the papers from which pool papers were put together. The names in a value stand
    for the numbers of the paper that the ask comes from, wherever the other asks of its question
    come from.

    Raises PolicyError where an accepted answer has no value.
    """
    wanted = [
        (ask, accepted) for ask in exam.asks for accepted in policy.ruling(ask.column).accepted
    ]
    found: dict[Which, tuple[Alternative, ...]] = {}
    failing: dict[tuple[str, int], list[tuple[str, _Failure]]] = {}
    constant: dict[tuple[str, int], Alternative] = {}
    papers = chain(exam.papers(), pooled) if wanted else ()
    for ask, accepted, whole, place in _find_places(exam, wanted, papers, sources):
        which = ask.column, accepted.number
        try:
            alternative = constant.get(which) or _work_out(exam, ask, accepted, whole, folder)
        except (ExpressionError, Unreadable, ArithmeticError) as fault:
            failing.setdefault(which, []).append((place[0], fault))
            continue
        found[place] = (*found.get(place, ()), alternative)
        if not _find_used(accepted):
            constant[which] = alternative
    faults = [
        _explain(ask, accepted, failing[ask.column, accepted.number])
        for ask, accepted in wanted
        if (ask.column, accepted.number) in failing
    ]
    if faults:
        raise PolicyError(*faults)
    return found


def _find_places(
    exam: Sitting,
    wanted: Sequence[tuple[Ask, Accepted]],
    papers: Iterable[Paper],
    sources: Mapping[str, Paper],
) -> Iterator[tuple[Ask, Accepted, Paper, Which]]:
    """Where an answer is accepted, each with the whole paper that the ask comes from; asks that
    were put to no student are left out.
    """
    numbers = {ask.column: number for number, ask in enumerate(exam.asks)}
    for paper in papers:
        for ask, accepted in wanted:
            number = numbers[ask.column]
            meant = accepted.students is None or paper.student in accepted.students
            put = not paper.put or paper.put[number]
            if meant and put and number not in paper.lacks:
                source = paper.source(number)
                place = paper.student, source, ask.column
                yield ask, accepted, sources.get(source, paper), place


def _find_used(accepted: Accepted) -> set[str]:
    """The names of the paper's numbers that it uses; without any, it has one value for the whole
    class.
    """
    return set(find_names(accepted.tree)) - {"pi"}


def _explain(ask: Ask, accepted: Accepted, failing: Sequence[tuple[str, _Failure]]) -> Fault:
    """One line however many papers are affected: a fault in an expression shows on most of them."""
    _, fault = failing[0]
    problem = Message(
        "policy.no-value",
        number=accepted.number,
        text=Quoted(accepted.text),
        students=list_first([Quoted(student) for student, _ in failing], 1),
        reason=_find_reason(fault),
    )
    where = Message("policy.place", ask=ask.column)
    return Fault(where, problem, Message("policy.one-number"), Message("policy.fix-it"))


def _find_reason(fault: _Failure) -> Part:
    match fault:
        case ExpressionError():
            return fault.faults[0]
        case Unreadable():
            return fault.reason
        case Undecided():
            return Message("policy.undecided")
        case ArithmeticError():
            return Message("expression.undefined")
        case _:
            assert_never(fault)


def _work_out(
    exam: Sitting, ask: Ask, accepted: Accepted, paper: Paper, folder: ExamFolder
) -> Alternative:
    return _find_alternative(
        accepted, _find_numbers(exam, ask, paper, folder, _find_used(accepted))
    )


def _find_numbers(
    exam: Sitting, ask: Ask, paper: Paper, folder: ExamFolder, used: set[str]
) -> Mapping[str, _Number]:
    """What the names stand for, with units: a text for a parameter, a number for a right answer."""
    found: dict[str, _Number] = {}
    for number, other in enumerate(exam.asks):
        if other.question == ask.question and other.ask in used:
            found[other.ask] = paper.key(number, ()).value, other.unit
    if used - found.keys():
        drawn = folder.keys.parameters(paper.student, ask.question)
        found |= {name: (each.text, each.unit) for name, each in drawn.items() if name in used}
    return found


def _find_alternative(accepted: Accepted, numbers: Mapping[str, _Number]) -> Alternative:
    try:
        amount = _work_out_amount(accepted, numbers, Field())
    except Inexact:
        balls = Balls(PRECISION)
        with balls.context():
            amount = _work_out_amount(accepted, numbers, balls)
    value, error = convert(amount, accepted.scale.factor, accepted.scale.pi)
    return Alternative(accepted, value, error)


def _work_out_amount(accepted: Accepted, numbers: Mapping[str, _Number], arithmetic: Any) -> Amount:
    functions = make_elementary_functions(arithmetic)
    values = {name: _convert_to_si(number, arithmetic) for name, number in numbers.items()}
    value = evaluate(accepted.tree, {**values, "pi": arithmetic.turns(1)}, functions, arithmetic)
    if not isinstance(value, Angle):
        return Amount(value)
    if value.parts:
        raise Inexact  # an angle that is not a rational part of a turn
    return Amount(value.half_turns, 1)


def _convert_to_si(number: _Number, arithmetic: Any) -> Any:
    """A number with its unit, in SI; an exact field holds angles only as fractions of a turn."""
    amount, unit = number
    written = read_unit(unit) if unit != "1" else _PURE
    if written is None:
        raise ExpressionError(Message("policy.unknown-unit", unit=Quoted(unit)))
    size = (
        arithmetic.number(make_rational_amount(amount).size)
        if isinstance(amount, Fraction)
        else evaluate(
            read_expression(amount),
            {"pi": arithmetic.turns(1)},
            make_elementary_functions(arithmetic),
            arithmetic,
        )
    )
    size = size * arithmetic.number(make_rational_amount(written.factor).size)
    if (written.length, written.time, written.angle) == (0, 0, 1) and not isinstance(size, Angle):
        return _make_angle(size, written.pi, arithmetic)
    if written.pi and arithmetic.exact:
        raise Inexact  # a rate in turns
    return size * arithmetic.turns(1) ** written.pi if written.pi else size


def _make_angle(size: Any, pi: int, arithmetic: Any) -> Any:
    if pi == 1:
        return arithmetic.turns(size)
    if arithmetic.exact:
        raise Inexact  # an angle in radians that is not a part of a turn
    return size
