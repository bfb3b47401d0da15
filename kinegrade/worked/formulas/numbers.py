"""Numbers as a worked solution states them: the exact value where it is short, and four significant
digits.
"""

from __future__ import annotations

from typing import Any

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.text import write_decimal
from kinegrade.numbers.units import read_unit
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.worked.formulas.atoms import Exact, Measured, Number
from kinegrade.worked.formulas.equation import Link, approximate, equate
from kinegrade.worked.formulas.exact import make_exact, make_exact_angle
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.symbols import INFINITY

DIGITS = 4
_CERTAINLY = 9  # digits of a number that is no longer than it looks
_LONGEST = 26  # characters of an exact value that is still easy to read within an equation


def state_number(number: Any, unit: str) -> tuple[Link, ...]:
    """= the exact value of a number in SI, where it is short and adds something, and its decimal
    with the unit.

    >>> from kinegrade.numbers.field import Field
    >>> [link.relation for link in state_number(Field().sqrt(Field().number(3)) / 2, "m/s")]
    ['=', '\\\\approx']
    """
    if isinstance(number, float):
        return equate(Measured(round_number(number), unit))
    return state_quantity(express_in_unit("", number, read_unit(unit)))


def state_quantity(quantity: Quantity) -> tuple[Link, ...]:
    """The same of a quantity in its unit."""
    if quantity.at_infinity:
        return equate(INFINITY)
    if quantity.is_plain:
        return equate(Measured(Number(quantity.decimal(12)), quantity.unit))
    decimal = (
        state_angle(quantity.value)
        if quantity.unit == "deg"
        else Measured(
            _keep_zeros(quantity.decimal(DIGITS), quantity.decimal(_CERTAINLY)), quantity.unit
        )
    )
    if quantity.exact is None or len(quantity.exact) > _LONGEST:
        return equate(decimal)
    return (*equate(state_exactly(quantity)), *approximate(decimal))


def state_exactly(quantity: Quantity) -> Formula:
    """The exact number of a quantity that has one; an arctangent in radians."""
    if isinstance(quantity.plain, Angle):
        return Exact(make_exact_angle(quantity.plain))
    return Exact(make_exact(quantity.plain))


def round_number(number: Any) -> Number:
    """A number in SI to four significant digits, without unit; what is rounded keeps its zeros.

    >>> round_number(0.00002), round_number(-2 / 3), round_number(7.0004)
    (Number(digits='0.00002'), Number(digits='-0.6667'), Number(digits='7.000'))
    """
    return _keep_zeros(write_decimal(number, DIGITS), write_decimal(number, _CERTAINLY))


def _keep_zeros(short: str, long: str) -> Number:
    """A decimal of four digits without the zeros at its end, or with them where it has more digits
    than it shows.
    """
    zeros = "" if short == long else "0" * (DIGITS - count_digits(short))
    return Number(short + ("." if zeros and "." not in short else "") + zeros)


def state_angle(angle: float) -> Measured:
    """An angle in degrees: whole degrees without decimals, others with two.

    >>> state_angle(36.8699).number
    Number(digits='36.87')
    """
    return Measured(Number(f"{round(angle, 2):g}"), "deg")


def count_digits(decimal: str) -> int:
    """The significant digits of a decimal."""
    return len(decimal.strip("-").replace(".", "").lstrip("0"))
