"""Numbers in the formulas of positions: as they are put in place of symbols, and at the end of an
equation.
"""

from __future__ import annotations

from typing import Any

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.text import expand_radicals
from kinegrade.numbers.units import read_unit
from kinegrade.problem.quantity import LONGEST_CLOSED_FORM, Quantity, express_in_unit
from kinegrade.worked.formulas.atoms import ZERO, Exact, Measured, Number
from kinegrade.worked.formulas.equation import Link, approximate, equate
from kinegrade.worked.formulas.exact import make_exact
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import DIGITS, count_digits, state_exactly

_LONGEST_SUBSTITUTED = (
    12  # characters of plain text: longer exact numbers, and parts of roots, become decimals
)
_LONGEST_EXACT = (
    30  # characters of plain text: a longer exact number is left out on the way to an answer
)
_SETTLED = 6  # digits: a decimal of 20 digits that ends so early is the number itself
_PURE = read_unit("1")


def state_degrees(angle: Quantity) -> Measured:
    """An angle in degrees as a decimal, to about two decimals."""
    if angle.is_plain:
        return Measured(Number(angle.decimal(12)), "deg")
    return Measured(Number(angle.decimal(_count_digits(angle))), "deg")


def _count_digits(quantity: Quantity) -> int:
    """The significant digits to which a quantity is rounded; degrees have two decimals."""
    return DIGITS + 1 if quantity.measure.degrees and abs(quantity.value) >= 100 else DIGITS


def state_substituted(value: Any) -> Formula:
    """A number as it is substituted into a formula: exact where that is short, else rounded."""
    quantity = express_in_unit("", value, _PURE)
    if isinstance(value, Angle):
        return Number(quantity.decimal(DIGITS))
    if quantity.is_plain:
        return Number(quantity.decimal(12))
    short = quantity.exact is not None and len(quantity.exact) <= _LONGEST_SUBSTITUTED
    if short and not _is_part_of_root(value):
        return Exact(make_exact(value))
    return _find_settled(quantity) or Number(quantity.decimal(DIGITS))


def _is_part_of_root(number: Any) -> bool:
    """Whether an exact number has roots and fractions."""
    terms = expand_radicals(number)
    rooted = any(free != 1 or nested for _, free, _, nested in terms)
    return rooted and any(factor.q != 1 for factor, *_ in terms)


def _find_settled(quantity: Quantity) -> Number | None:
    """The decimal of an enclosure that, within its precision, is a number of few digits; None for
    any other.
    """
    text = quantity.decimal(20)
    return Number(text) if count_digits(text) <= _SETTLED else None


def state_result(quantity: Quantity, longest: int = _LONGEST_EXACT) -> tuple[Link, ...]:
    """The value at the end of an equation: exact where it is short enough, then rounded where the
    exact form is not a decimal.
    """
    if quantity.is_zero:
        return equate(ZERO)
    if quantity.is_plain:
        return equate(Measured(Number(quantity.decimal(12)), quantity.unit))
    if not quantity.is_exact and (settled := _find_settled(quantity)):
        return equate(Measured(settled, quantity.unit))
    decimal = Measured(Number(quantity.decimal(_count_digits(quantity))), quantity.unit)
    if not _is_short(quantity, longest):
        return approximate(decimal)
    return (*equate(_measure_exactly(quantity)), *approximate(decimal))


def _is_short(quantity: Quantity, longest: int) -> bool:
    """Whether the exact number of a quantity is stated; an arctangent in degrees is not."""
    arctangent = isinstance(quantity.number, Angle) and quantity.measure.degrees
    if arctangent or quantity.exact is None:
        return False
    return len(quantity.exact) <= min(longest, LONGEST_CLOSED_FORM)


def _measure_exactly(quantity: Quantity) -> Formula:
    """The exact number with its unit; an angle in radians stands without one."""
    exact = state_exactly(quantity)
    return exact if isinstance(quantity.number, Angle) else Measured(exact, quantity.unit)
