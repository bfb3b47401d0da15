"""The right answer of an ask as a feedback sheet shows it: exactly where that is short, as a
decimal, and how far off an answer may be.
"""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction

from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.reading import read_expression
from kinegrade.language.math.units import write_unit
from kinegrade.language.message import Message, Text
from kinegrade.numbers.decimals import round_to_decimal
from kinegrade.numbers.field import Field
from kinegrade.numbers.text import LATEX, write_exact, write_multiple_of_pi
from kinegrade.reports.paper_record import RightAnswer

_LONGEST_EXACT = 32
_SHOWN_DIGITS = 6
_ALLOWED_DIGITS = 2
_CLOSED_FORM = re.compile(r"(?:[-+*/() 0-9]|sqrt)+")
_MULTIPLE_OF_PI = re.compile(r"-?(?:[0-9]+\*)?pi(?:/[0-9]+)?")


def write_decimal(right: RightAnswer) -> str:
    """The decimal with its unit, after "≈" where it is rounded.

    >>> from kinegrade.numbers.tolerance import Tolerance
    >>> write_decimal(RightAnswer(Fraction("1.154700538379"), None, "m/s", Tolerance()))
    '≈ 1.1547\u202fm/s'
    """
    value = round_to_decimal(right.value, _SHOWN_DIGITS)
    decimal = _write_plainly(value)
    whole = write_with_unit(decimal.replace("-", "−"), right.unit)
    return whole if Fraction(decimal) == right.value else f"≈ {whole}"


def write_closed_form(right: RightAnswer) -> str:
    r"""The exact value without its unit, in LaTeX math; "" where it is long, or is the decimal.

    >>> from kinegrade.numbers.tolerance import Tolerance
    >>> right = RightAnswer(Fraction("2.857883832488647"), "33*sqrt(3)/20", "m/s", Tolerance())
    >>> print(write_closed_form(right))
    \frac{33 \sqrt{3}}{20}
    """
    exact = right.exact or ""
    decimal = round_to_decimal(right.value, _SHOWN_DIGITS)
    if len(exact) > _LONGEST_EXACT or Fraction(decimal) == right.value:
        return ""
    field = Field()
    if _MULTIPLE_OF_PI.fullmatch(exact):
        share = evaluate(read_expression(exact), {"pi": field.number(1)}, {}, field)
        return write_multiple_of_pi(share, LATEX)
    if not _CLOSED_FORM.fullmatch(exact):
        return ""
    return write_exact(evaluate(read_expression(exact), {}, {"sqrt": field.sqrt}, field), LATEX)


def describe_allowed(right: RightAnswer) -> Text:
    """How far off an answer may be, rounded down to two figures; from where to where it is right,
    rounded inwards, where it may be farther off on one side; "" where nothing is allowed.

    >>> from kinegrade.numbers.tolerance import Tolerance
    >>> rule = Tolerance(absolute=Fraction("0.0259"))
    >>> describe_allowed(RightAnswer(Fraction(2), None, "m/s", rule))
    '±0.025\u202fm/s'
    """
    low, high = right.bounds
    if low == high:
        return ""
    if right.value - low != high - right.value:
        return _describe_bounds(right)
    amount = round_to_decimal(high - right.value, _ALLOWED_DIGITS, "down")
    return write_with_unit(f"±{_write_plainly(amount)}", right.unit)


def _describe_bounds(right: RightAnswer) -> Message:
    """The bounds of significant figures have one digit more than the figures."""
    low, high = right.bounds
    digits = max(_SHOWN_DIGITS, (right.rule.figures or 0) + 1)
    lowest = _write_plainly(round_to_decimal(low, digits, "up")).replace("-", "−")
    highest = _write_plainly(round_to_decimal(high, digits, "down")).replace("-", "−")
    return Message("feedback.from-to", low=lowest, high=write_with_unit(highest, right.unit))


def write_with_unit(number: str, unit: str) -> str:
    """A number and its unit.

    >>> write_with_unit("30", "deg"), write_with_unit("2", "m/s^2"), write_with_unit("2", "1")
    ('30°', '2\u202fm/s²', '2')
    """
    shown = write_unit(unit, pure="")
    return f"{number}{shown}" if shown in ("", "°") else f"{number}\u202f{shown}"


def _write_plainly(number: Decimal) -> str:
    """Without a power of ten where that is short."""
    return f"{number:f}" if -6 < number.adjusted() < 9 else str(number)
