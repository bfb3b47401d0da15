"""Units as they are printed: exponents raised, a degree sign, a dot for a product."""

from __future__ import annotations

import re
from collections.abc import Callable

DASH = "–"  # stands for the unit of a pure number in a table
_DEGREES = re.compile(r"\bdeg\b")
_EXPONENT = re.compile(r"\^\{?([-\u2212]?[0-9]+)\}?")
_SUPERSCRIPTS = str.maketrans("-\u22120123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def raise_digits(exponent: str) -> str:
    """A whole number in raised digits.

    >>> raise_digits("-2")
    '⁻²'
    """
    return exponent.translate(_SUPERSCRIPTS)


def raise_exponents(
    text: str,
    write_plain: Callable[[str], str] = str,
    write_raised: Callable[[str], str] = raise_digits,
) -> str:
    """The text of a unit with its exponents raised and dots for products; `write_plain` escapes
    what stands between the exponents.

    >>> raise_exponents("N*m"), raise_exponents("s^-1")
    ('N·m', 's⁻¹')
    """
    parts = _EXPONENT.split(text.replace("*", "·"))
    return "".join(
        write_raised(part) if index % 2 else write_plain(part) for index, part in enumerate(parts)
    )


def append_unit(number: str, unit: str) -> str:
    r"""A number in LaTeX math with its unit behind it; a pure number has none.

    >>> append_unit("0.25", "m/s"), append_unit("0.5", "deg"), append_unit("3", "1")
    ('0.25\\,\\unit{m/s}', '0.5^\\circ', '3')
    """
    match unit:
        case "1":
            return number
        case "deg":
            return rf"{number}^\circ"
        case _:
            return rf"{number}\,\unit{{{unit}}}"


def write_unit(
    unit: str, pure: str = DASH, write_symbols: Callable[[str], str] = raise_exponents
) -> str:
    """A unit, in plain text unless `write_symbols` writes it otherwise; `pure` is what a pure
    number shows.

    >>> write_unit("rad/s^2"), write_unit("deg"), write_unit("1"), write_unit("1", pure="")
    ('rad/s²', '°', '–', '')
    >>> write_unit("deg/s"), write_unit("r/min")
    ('°/s', 'r/min')
    """
    match unit:
        case "1":
            return pure
        case "deg":
            return "°"
        case _:
            return write_symbols(_DEGREES.sub("°", unit))
