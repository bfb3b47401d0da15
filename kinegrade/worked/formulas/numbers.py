"""The one rule by which a worked solution prints numbers, from the givens to the last line.

A number that a decimal of few digits says stands after `=`. Any other is rounded, to four
significant digits, angles to two decimals, or all of a solution to more, keeps its zeros and stands
after the approximate sign; its exact form stands before it where that is short. A zero is 0.
"""

from __future__ import annotations

import re
from typing import Any

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.numbers.text import expand_radicals
from kinegrade.numbers.units import Unit, read_unit
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.worked.formulas.atoms import ZERO, Exact, Measured, Number
from kinegrade.worked.formulas.equation import Link, approximate, equate
from kinegrade.worked.formulas.exact import make_exact, make_exact_angle
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import DIGITS, PLACES
from kinegrade.worked.formulas.symbols import INFINITY

_CERTAINLY = 9  # digits of a number that is no longer than it looks
_LONGEST = 20  # characters of an exact form that is read at a glance: 20 - 2*sqrt(3)
_LONGEST_WHOLE = 3  # digits of the whole numbers in it
_LONGEST_SUBSTITUTED = 12  # characters of an exact form in place of a symbol
_DEGREE = read_unit("deg")


def state_number(number: Any, unit: str) -> tuple[Link, ...]:
    """What a number in SI is equal to: its decimal with the unit, before that its exact form.

    >>> from kinegrade.numbers.field import Field
    >>> [link.relation for link in state_number(Field().sqrt(Field().number(3)) / 2, "m/s")]
    ['=', '\\\\approx']
    """
    if isinstance(number, float):
        rounded = measure(number, unit)
        return equate(rounded) if _is_settled(number) else approximate(rounded)
    return state_quantity(express_in_unit("", number, read_unit(unit)))


def state_quantity(quantity: Quantity) -> tuple[Link, ...]:
    """The same of a quantity in its unit."""
    if quantity.at_infinity:
        return equate(INFINITY)
    if quantity.is_zero:
        return equate(ZERO)
    rounded = Measured(_round_quantity(quantity), quantity.unit)
    if quantity.is_plain or _is_certain(quantity):
        return equate(rounded)
    if has_short_form(quantity):
        return (*equate(_measure_exactly(quantity)), *approximate(rounded))
    return approximate(rounded)


def has_short_form(quantity: Quantity) -> bool:
    """Whether the exact number of a quantity is read at a glance; an arctangent is not."""
    if quantity.exact is None or quantity.at_infinity:
        return False
    if isinstance(quantity.number, Angle) and quantity.number.parts:
        return False
    wholes = re.findall(r"\d+", quantity.exact)
    long = any(len(whole) > _LONGEST_WHOLE for whole in wholes)
    return len(quantity.exact) <= _LONGEST and not long


def _measure_exactly(quantity: Quantity) -> Formula:
    """The exact number with its unit."""
    if isinstance(quantity.plain, Angle):
        return Measured(Exact(make_exact_angle(quantity.plain)), quantity.unit)
    return Measured(Exact(make_exact(quantity.plain)), quantity.unit)


def _round_quantity(quantity: Quantity) -> Number:
    """The decimal of a quantity, in full where it has few digits."""
    if quantity.is_plain:
        return Number(quantity.decimal(12))
    if quantity.measure.degrees:
        return _round_degrees(quantity.value)
    return _keep_zeros(quantity.decimal(DIGITS), quantity.decimal(_CERTAINLY))


def _is_certain(quantity: Quantity) -> bool:
    """Whether an enclosure, within its precision, or an arctangent is the decimal to which it is
    rounded.
    """
    worked_out = not quantity.is_exact or quantity.measure.degrees
    return worked_out and quantity.decimal(20) == _round_quantity(quantity).digits


def _is_settled(number: Any) -> bool:
    """Whether a number is the decimal to which it is rounded."""
    return write_decimal(number, DIGITS) == write_decimal(number, _CERTAINLY)


def measure(number: Any, unit: str) -> Formula:
    """A number in SI as it is put into a formula: rounded, with its unit; a zero as 0.

    >>> measure(2, "m").print()[-1], measure(0, "m")
    (Unit(text='m'), Number(digits='0'))
    """
    rounded = round_number(number)
    return ZERO if rounded == ZERO else Measured(rounded, unit)


def round_number(number: Any, digits: int = DIGITS) -> Number:
    """A number in SI to so many significant digits, without unit; what is rounded keeps its zeros.

    >>> round_number(0.00002), round_number(-2 / 3), round_number(7.0004)
    (Number(digits='0.00002'), Number(digits='-0.6667'), Number(digits='7.000'))
    """
    return _keep_zeros(write_decimal(number, digits), write_decimal(number, _CERTAINLY), digits)


def _keep_zeros(short: str, long: str, digits: int = DIGITS) -> Number:
    """A decimal of so many digits without the zeros at its end, or with them where it has more
    digits than it shows.
    """
    zeros = "" if short == long else "0" * (digits - count_digits(short))
    point = "." if zeros and "." not in short else ""
    return Number(short + point + zeros, rounded=short != long, long=long)


def state_angle(angle: float) -> Measured:
    """An angle in degrees: a whole number of them without decimals, any other with two.

    >>> state_angle(36.8699).number, state_angle(36.1004).number, state_angle(22.5).number
    (Number(digits='36.87'), Number(digits='36.10'), Number(digits='22.5'))
    """
    return Measured(_round_degrees(angle), "deg")


def _round_degrees(angle: float) -> Number:
    rounded = round(angle, PLACES)
    exact = abs(rounded - angle) < 10**-_CERTAINLY
    shown = f"{rounded:g}" if exact else f"{rounded:.{PLACES}f}"
    return Number(shown, rounded=not exact, long=f"{angle:.{_CERTAINLY}f}")


def substitute(value: Any, unit: Unit) -> Formula:
    """A value in SI as it is put in place of a symbol: with its unit, a pure number exactly where
    that is short.
    """
    if unit.degrees:
        return Measured(_round_quantity(express_in_unit("", value, _DEGREE)), "deg")
    quantity = express_in_unit("", value, unit)
    if quantity.is_zero:
        return ZERO
    short = quantity.exact is not None and len(quantity.exact) <= _LONGEST_SUBSTITUTED
    exact = short and unit.text == "1" and not isinstance(value, Angle)
    if exact and not quantity.is_plain and not _is_part_of_root(value):
        return Exact(make_exact(value))
    return Measured(_round_quantity(quantity), unit.text)


def _is_part_of_root(number: Any) -> bool:
    """Whether an exact number has roots and fractions."""
    terms = expand_radicals(number)
    rooted = any(term.free != 1 or term.nested for term in terms)
    return rooted and any(term.factor.q != 1 for term in terms)


def count_digits(decimal: str) -> int:
    """The significant digits of a decimal."""
    return len(decimal.strip("-").replace(".", "").lstrip("0"))
