"""Answers that a policy accepts beside the key, worked out for every paper.

`alternatives` is called by `grade`. Values are expressions of the grammar of templates: exact where a small field holds
them, else known to 38 digits. A name in them is a parameter of the question or one of its right answers, in SI.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kinegrade.errors import ExpressionError, PolicyError
from kinegrade.exact.angle import Angle, Inexact
from kinegrade.exact.balls import Balls
from kinegrade.exact.field import Field
from kinegrade.expression import elementary, evaluate, names, read
from kinegrade.grading.givens import Givens
from kinegrade.grading.key import Ask, Exam, Examinee
from kinegrade.grading.number_text import Unreadable
from kinegrade.grading.policy import Accepted, Policy
from kinegrade.grading.typed_value import PRECISION, Amount, converted, rational_amount
from kinegrade.grading.unit_spelling import WrittenUnit, written_unit

_PURE = WrittenUnit(Fraction(1), 0, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class Alternative:
    """An accepted answer on one paper, in the ask's unit; `error` is how far an irrational value may be off."""

    accepted: Accepted
    value: Fraction
    error: Fraction


Number = tuple[str | Fraction, str]  # a given's text or a right answer, and its unit
Alternatives = Mapping[tuple[str, str], tuple[Alternative, ...]]  # by student and answer column


def alternatives(exam: Exam, policy: Policy, givens: Givens) -> Alternatives:
    """All accepted answers of all papers. Raises PolicyError where one has no value."""
    found: dict[tuple[str, str], tuple[Alternative, ...]] = {}
    faults: list[str] = []
    for ask in exam.asks:
        for accepted in policy.ruling(ask.column).accepted:
            failing: list[tuple[str, Exception]] = []
            for student, alternative in _everybodys(exam, ask, accepted, givens, failing):
                place = student, ask.column
                found[place] = (*found.get(place, ()), alternative)
            faults += _fault(ask, accepted, failing)
    if faults:
        raise PolicyError(*faults)
    return found


def _everybodys(
    exam: Exam, ask: Ask, accepted: Accepted, givens: Givens, failing: list[tuple[str, Exception]]
) -> Iterator[tuple[str, Alternative]]:
    used = set(names(accepted.tree)) - {"pi"}
    same: Alternative | None = None
    for examinee in exam.examinees:
        if accepted.students is not None and examinee.student not in accepted.students:
            continue
        try:
            if used or same is None:
                same = _alternative(accepted, _numbers(exam, ask, examinee, givens, used))
            yield examinee.student, same
        except (ExpressionError, Unreadable, ArithmeticError) as fault:
            failing.append((examinee.student, fault))


def _fault(ask: Ask, accepted: Accepted, failing: Sequence[tuple[str, Exception]]) -> Iterator[str]:
    """One line however many papers it is: a fault in an expression shows on most."""
    if failing:
        student, fault = failing[0]
        others = f" and {len(failing) - 1} more" if len(failing) > 1 else ""
        yield (f'policy: {ask.column}: accepted answer {accepted.number}, "{accepted.text}", has no value for student '
               f'"{student}"{others} ({str(fault).partition(": check")[0]}) - expected one number - mend it')


def _numbers(
    exam: Exam, ask: Ask, examinee: Examinee, givens: Givens, used: set[str]
) -> Mapping[str, Number]:
    """What the names stand for, each with its unit: a text for a parameter, a number for a right answer."""
    found: dict[str, Number] = {}
    for other in exam.asks:
        if other.question == ask.question and other.ask in used:
            found[other.ask] = examinee.keys[other.column].value, other.unit
    if used - found.keys():
        drawn = givens.of(examinee.student, ask.question)
        found |= {name: given for name, given in drawn.items() if name in used}
    return found


def _alternative(accepted: Accepted, numbers: Mapping[str, Number]) -> Alternative:
    try:
        amount = _amount(accepted, numbers, Field())
    except Inexact:
        balls = Balls(PRECISION)
        with balls.context():
            amount = _amount(accepted, numbers, balls)
    value, error = converted(amount, accepted.scale.factor, accepted.scale.pi)
    return Alternative(accepted, value, error)


def _amount(accepted: Accepted, numbers: Mapping[str, Number], arithmetic: Any) -> Amount:
    functions = elementary(arithmetic)
    values = {name: _in_si(number, arithmetic) for name, number in numbers.items()}
    value = evaluate(accepted.tree, {**values, "pi": arithmetic.turns(1)}, functions, arithmetic)
    if not isinstance(value, Angle):
        return Amount(value)
    if value.parts:
        raise Inexact("an angle that is no rational part of a turn")
    return Amount(value.half_turns, 1)


def _in_si(number: Number, arithmetic: Any) -> Any:
    """A number with its unit in SI; angles are angles, which an exact field holds as parts of a turn only."""
    amount, unit = number
    written = written_unit(unit) if unit != "1" else _PURE
    if written is None:
        raise ExpressionError(f'the unit "{unit}" is not known')
    size = (arithmetic.number(rational_amount(amount).size) if isinstance(amount, Fraction)
            else evaluate(read(amount), {"pi": arithmetic.turns(1)}, elementary(arithmetic), arithmetic))
    size = size * arithmetic.number(rational_amount(written.factor).size)
    if (written.length, written.time, written.angle) == (0, 0, 1) and not isinstance(size, Angle):
        return _angle(size, written.pi, arithmetic)
    if written.pi and arithmetic.exact:
        raise Inexact("a rate in turns")
    return size * arithmetic.turns(1) ** written.pi if written.pi else size


def _angle(size: Any, pi: int, arithmetic: Any) -> Any:
    if pi == 1:
        return arithmetic.turns(size)
    if arithmetic.exact:
        raise Inexact("an angle in radians that is no part of a turn")
    return size
