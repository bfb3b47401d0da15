"""Points, tolerances and room of a bank, limited to what an exam can keep and print.

tolerance = "honest"
tolerance = { relative = "1 %", honest = true }
"""

from __future__ import annotations

import re
from fractions import Fraction
from math import inf

from msgspec import Struct

from kinegrade.errors import FieldError
from kinegrade.exam.bank.keys import TOLERANCE
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import amount, flag, found, text, whole
from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.stated_marking import HONEST, HONESTLY, read_tolerance

MAX_POINTS = 1000
_MOST_ROOM = 200.0  # millimetres: what a page holds beside a short question
_LENGTH = re.compile(r"([0-9]{1,4}(?:\.[0-9]{1,3})?) ?(mm|cm|in)")
_MILLIMETRES = {"mm": 1.0, "cm": 10.0, "in": 25.4}
_MOST_DIGITS = 15  # as many as survive as a JSON number
_FIGURES = whole(2, 6)  # no more than the key prints


class BankTolerance(Struct, frozen=True):
    """A tolerance as a bank states it; one that is `honest` is widened by the numbers of a paper,
    where honest rounding may leave it.
    """

    tolerance: Tolerance = ONE_PER_CENT
    honest: bool = False


def read_points(value: object) -> Fraction:
    """The points of an ask, exactly."""
    number = amount(value)
    if not 0 < number <= MAX_POINTS:
        raise FieldError(found(value), Message("bank.points-from-to", most=MAX_POINTS))
    return number


def read_room(value: object) -> float:
    """The room for working in millimetres. Raises FieldError."""
    length = _LENGTH.fullmatch(text(value))
    room = float(length[1]) * _MILLIMETRES[length[2]] if length else inf
    if room > _MOST_ROOM:
        most = f"{_MOST_ROOM / 10:g}"
        raise FieldError(found(value), Message("bank.room-for-working", most=most))
    return room


def read_bank_tolerance(table: Table, default: BankTolerance) -> BankTolerance:
    """The tolerance that a table states; the default where it states none, and after a fault."""
    if table.value("tolerance") == HONEST:
        return BankTolerance(honest=True)
    stated = read_tolerance(table, _FIGURES, TOLERANCE)
    if "tolerance" not in table or not table.is_sound("tolerance"):
        return default
    honest = table.table("tolerance").with_default(HONEST, flag, False)
    tolerance = Tolerance(
        stated.relative or Fraction(0), stated.absolute or Fraction(0), stated.figures
    )
    if honest and (not tolerance.relative or tolerance.figures):
        what = Message("bank.honest-without-share")
        table.fault("tolerance", what, Message("fields.a-table-like", like=HONESTLY))
    else:
        _require_kept(table, tolerance)
    return BankTolerance(tolerance, honest)


def _require_kept(table: Table, tolerance: Tolerance) -> None:
    """A fault where a tolerance allows all or nothing, or cannot be kept."""
    relative, absolute = tolerance.relative, tolerance.absolute
    if relative >= 1:
        what, expected = Message("bank.tolerance-of-all"), Message("bank.tolerance-below-all")
        table.fault("tolerance", what, expected)
    if relative + absolute == 0 and tolerance.figures is None:
        what, expected = Message("bank.tolerance-of-nothing"), Message("bank.tolerance-above-zero")
        table.fault("tolerance", what, expected)
    if not (_is_kept(relative) and _is_kept(absolute)):
        what = Message("bank.tolerance-too-fine")
        expected = Message("bank.tolerance-digits", most=_MOST_DIGITS)
        table.fault("tolerance", what, expected)


def _is_kept(number: Fraction) -> bool:
    """Whether a number passes through JSON and onto paper unchanged."""
    return Fraction(f"{float(number):.{_MOST_DIGITS}g}") == number
