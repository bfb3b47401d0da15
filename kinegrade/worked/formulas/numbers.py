"""Numbers as a worked solution states them: the exact value where it is short, and four significant
digits.
"""

from __future__ import annotations

from math import atan2, degrees, hypot
from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Inexact
from kinegrade.numbers.balls import Undecided
from kinegrade.numbers.units import read_unit
from kinegrade.problem.quantity import Quantity, express_in_unit

DIGITS = 4
NEGLIGIBLE = 1e-12  # in SI: less than this is what rounding leaves of zero
_LONGEST = 26  # characters of an exact value that is still easy to read within an equation


def write_number(number: Any, unit: str) -> str:
    """A number in SI as LaTeX math: exact, decimal, unit; the exact value only where it is short
    and adds something.

    >>> from kinegrade.numbers.field import Field
    >>> field = Field()
    >>> write_number(field.sqrt(field.number(3)) / 2, "m/s")
    '\\\\frac{\\\\sqrt{3}}{2} \\\\approx 0.866\\\\,\\\\unit{m/s}'
    """
    if isinstance(number, float):
        return write_with_unit(f"{number:.{DIGITS}g}", unit)
    return write_quantity(express_in_unit("", number, read_unit(unit)))


def write_quantity(quantity: Quantity) -> str:
    """A quantity in its unit, as `write_number`."""
    decimal = write_with_unit(quantity.decimal(DIGITS), quantity.unit)
    if quantity.at_infinity:
        return r"\infty"
    if quantity.is_plain:
        return write_with_unit(quantity.closed_form or quantity.decimal(DIGITS), quantity.unit)
    if quantity.exact is None or quantity.latex is None or len(quantity.exact) > _LONGEST:
        return decimal
    exact = (
        quantity.latex.removeprefix(r"\frac{180}{\pi}\,")
        if quantity.unit == "deg"
        else quantity.latex
    )
    return rf"{exact} \approx {decimal}"


def write_with_unit(number: str, unit: str) -> str:
    """A number and its unit in LaTeX math."""
    if unit == "deg":
        return rf"{number}^\circ"
    return number if unit == "1" else rf"{number}\,\unit{{{unit}}}"


def write_short(number: Any) -> str:
    """A number in SI to four significant digits, without unit."""
    return (
        f"{number:.{DIGITS}g}"
        if isinstance(number, float)
        else express_in_unit("", number, read_unit("1")).decimal(DIGITS)
    )


def write_bracketed(text: str) -> str:
    """A number after an operator: in brackets where it is negative."""
    return f"({text})" if text.startswith("-") else text


def write_absolute_value(symbol: str) -> str:
    """The absolute value of an algebraic quantity, in LaTeX math."""
    return rf"\left|{symbol}\right|"


def length(vector: Vector, arithmetic: Any) -> Any:
    """The length of a vector: exact where the field holds it, else a double."""
    try:
        return arithmetic.fork().magnitude(vector.x, vector.y)
    except (Inexact, Undecided, ValueError):
        return size(vector)


def double(number: Any) -> float:
    """A number as a double; zero where only rounding has left anything."""
    value = float(number)
    return 0.0 if abs(value) < NEGLIGIBLE else value


def size(vector: Vector) -> float:
    """The length of a vector as a double."""
    return hypot(float(vector.x), float(vector.y))


def bearing(vector: Vector) -> float:
    """The direction of a vector in degrees from +x, counter-clockwise, from 0 to below 360."""
    return tidy(degrees(atan2(float(vector.y), float(vector.x)))) % 360


def tidy(angle: float) -> float:
    """An angle in degrees without the rounding errors of a double."""
    whole = round(angle, 6)
    return whole if abs(angle - whole) < 1e-7 else angle


def write_angle(angle: float) -> str:
    """An angle given in degrees as LaTeX math: whole degrees without decimals, others with two.

    >>> write_angle(30.0), write_angle(36.8699)
    ('30^\\\\circ', '36.87^\\\\circ')
    """
    return f"{round(angle, 2):g}^\\circ"
