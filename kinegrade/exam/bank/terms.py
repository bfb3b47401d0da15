"""Points and tolerances of a bank, limited to what an exam can keep and print."""

from __future__ import annotations

from fractions import Fraction

from kinegrade.errors import FieldError
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import amount, found, whole
from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.stated_marking import read_tolerance

MAX_POINTS = 1000
_MOST_DIGITS = 15  # as many as survive as a JSON number
_FIGURES = whole(2, 6)  # no more than the key prints


def read_points(value: object) -> Fraction:
    """The points of an ask, exactly."""
    number = amount(value)
    if not 0 < number <= MAX_POINTS:
        raise FieldError(found(value), Message("bank.points-from-to", most=MAX_POINTS))
    return number


def read_bank_tolerance(table: Table, default: Tolerance) -> Tolerance:
    """The tolerance that a table states; the default where it states none, and after a fault."""
    stated = read_tolerance(table, _FIGURES)
    if "tolerance" not in table or not table.is_sound("tolerance"):
        return default
    relative, absolute = stated.relative or Fraction(0), stated.absolute or Fraction(0)
    if relative >= 1:
        what, expected = Message("bank.tolerance-of-all"), Message("bank.tolerance-below-all")
        table.fault("tolerance", what, expected)
    if relative + absolute == 0 and stated.figures is None:
        what, expected = Message("bank.tolerance-of-nothing"), Message("bank.tolerance-above-zero")
        table.fault("tolerance", what, expected)
    if not (_is_kept(relative) and _is_kept(absolute)):
        what = Message("bank.tolerance-too-fine")
        expected = Message("bank.tolerance-digits", most=_MOST_DIGITS)
        table.fault("tolerance", what, expected)
    return Tolerance(relative, absolute, stated.figures)


def _is_kept(number: Fraction) -> bool:
    """Whether a number passes through JSON and onto paper unchanged."""
    return Fraction(f"{float(number):.{_MOST_DIGITS}g}") == number
