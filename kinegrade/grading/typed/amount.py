"""What a typed formula is worth: exactly where a small field holds it, otherwise to 38 digits.

`typed_value` reads the formula; `answers` calls `work_out`, then `convert` for its unit.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_rational
from kinegrade.grading.typed.number_text import LARGEST_EXPONENT, Unreadable
from kinegrade.grading.typed.value import Formula
from kinegrade.language.message import Message, list_plainly
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.decimals import round_to_decimal
from kinegrade.numbers.field import Field
from kinegrade.numbers.pi_multiple import split_pi
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.rounded_text import find_bounds
from kinegrade.numbers.surd import Surd

PRECISION = 256
_SHOWN_DIGITS = 12
_MOST_EXACT_ROOTS = 3  # with more of them, the tower of fields costs more than a ball
# The error of an irrational value, relative to its size; the key has 40 digits
_KNOWN = Fraction(1, 10**38)
_SMALLEST, _LARGEST = Fraction(1, 10**LARGEST_EXPONENT), Fraction(10**LARGEST_EXPONENT)
_SMALLEST_SHOWN, _LARGEST_SHOWN = f"1e-{LARGEST_EXPONENT}", f"1e{LARGEST_EXPONENT}"


@dataclass(frozen=True, slots=True)
class Amount:
    """size * pi**pi: a rational number or a surd, or a ball where no small field holds it."""

    size: Any
    pi: int = 0


def work_out(formula: Formula) -> Amount:
    """The formula's value, exact where a small field holds it. Raises Unreadable for division by
    zero and the like.
    """
    try:
        if formula.roots <= _MOST_EXACT_ROOTS and (amount := _make_exact(formula)) is not None:
            return amount
        arithmetic = Balls(PRECISION)
        with arithmetic.context():
            known = {"pi": arithmetic.turns(1)}
            return Amount(
                evaluate(
                    formula.tree,
                    known,
                    {"sqrt": make_elementary_functions(arithmetic)["sqrt"]},
                    arithmetic,
                )
            )
    except ExpressionError as error:
        raise Unreadable(_describe_no_value(error)) from error
    except ArithmeticError as error:
        raise Unreadable(Message("typing.no-value-at-all")) from error


def _describe_no_value(error: ExpressionError) -> Message:
    match error.__cause__:
        case ZeroDivisionError():
            return Message("typing.division-by-zero")
        case ValueError():
            return Message("typing.root-of-negative")
        case _:
            return Message("typing.no-value", reason=list_plainly(error.faults))


def _make_exact(formula: Formula) -> Amount | None:
    """A rational number, a surd, or a rational multiple of pi; None for anything else."""
    field = Field()
    try:
        value = evaluate(formula.tree, {"pi": field.turns(1)}, {"sqrt": field.sqrt}, field)
    except Inexact:
        return None
    except ExpressionError as error:
        if not formula.pi or isinstance(error.__cause__, ZeroDivisionError):
            raise
        return None  # an angle added to a number, as in 1 + pi: a ball holds both
    if isinstance(value, Angle):
        return Amount(value.half_turns, 1)
    return Amount(*split_pi(value))


def convert(amount: Amount, factor: Fraction, pi: int) -> tuple[Fraction, Fraction]:
    """(value, error) of amount * factor * pi**pi: exact with error zero where it is rational,
    otherwise to 38 digits.

    Raises Unreadable where the value is too large, too small or not finite.
    """
    power = amount.pi + pi
    arithmetic = Balls(PRECISION)
    with arithmetic.context():
        size = amount.size * factor.numerator / factor.denominator
        if _is_rational(size) and (power == 0 or size == 0):
            return _require_bounded(Fraction(int(size.p), int(size.q))), Fraction(0)
        ball = arithmetic.number(size) if _is_rational(size) or isinstance(size, Surd) else size
        return _enclose(ball * arithmetic.turns(1) ** power)


def _is_rational(size: Any) -> bool:
    """Whether the size of an amount is a rational number, not a surd or a ball."""
    return hasattr(size, "p") and hasattr(size, "q")


def _enclose(ball: Any) -> tuple[Fraction, Fraction]:
    if not ball.is_finite() or not abs(ball) < 10**LARGEST_EXPONENT:
        raise Unreadable(Message("typing.not-finite", largest=_LARGEST_SHOWN))
    if 0 not in ball and not abs(ball) * 10**LARGEST_EXPONENT > 1:
        raise Unreadable(Message("typing.below", smallest=_SMALLEST_SHOWN))
    if 0 in ball:
        return Fraction(0), _KNOWN  # a difference that vanishes to more digits than any key has
    low, high = (Fraction(int(side.p), int(side.q)) for side in find_bounds(ball, PRECISION))
    middle = (low + high) / 2
    return middle, max(abs(middle) * _KNOWN, high - low)


def _require_bounded(value: Fraction) -> Fraction:
    if value and not _SMALLEST <= abs(value) <= _LARGEST:
        raise Unreadable(Message("typing.beyond", largest=_LARGEST_SHOWN, smallest=_SMALLEST_SHOWN))
    return value


def make_rational_amount(value: Fraction) -> Amount:
    """A fraction as an amount."""
    return Amount(read_rational("1") * value.numerator / value.denominator)


def decimal_text(value: Fraction) -> str:
    """A fraction in digits: all of them where there are few, otherwise the first twelve.

    >>> decimal_text(Fraction(3, 4)), decimal_text(Fraction(2, 3))
    ('0.75', '0.666666666667')
    """
    short = round_to_decimal(value, _SHOWN_DIGITS)
    return f"{short:f}" if -7 < short.adjusted() < 21 else str(short).lower()
