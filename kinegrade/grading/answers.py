"""What a student typed into one cell, read digit by digit.

`read` is called for every cell of an answer sheet; `judge` is the next storey up. A single comma is the
decimal comma, as the paper says. Numbers are read as exact fractions; nothing is rounded, nothing evaluated.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from kinegrade.grading.unit_spelling import same_unit
from kinegrade.tables import trimmed

LONGEST_ANSWER = 100
MOST_DIGITS = 40
LARGEST_EXPONENT = 99

_ASCII_FORMS = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)}  # full-width letters, digits and signs
_POINTS = {ord(sign): "." for sign in "。｡"}  # what a Chinese keyboard gives for a full stop
_MINUS_SIGNS = {
    ord(sign): "-" for sign in "\u2212\u2010\u2011\u2012\u2013\u2014\u2015\u2043\u02d7\ufe58\ufe63"
}
_FOLDED: dict[int, int | str] = {**_ASCII_FORMS, **_POINTS, **_MINUS_SIGNS}
_NUMBER = re.compile(r"([+-]?)\s*([0-9]*)(?:([.,])([0-9]*))?(?:[eE]([+-]?[0-9]+))?\s*")
_THOUSANDS_LIKE = re.compile(r"[1-9][0-9]{0,2},[0-9]{3}")
_CALCULATION = re.compile(r"[-+*/^(]+\s*[0-9.,(a-z\u221a-]")
_POWER_OF_TEN = re.compile(r"[x\u00d7*\u00b7\u22c5]\s*10")


@dataclass(frozen=True, slots=True)
class Reading:
    """One cell read: `typed` as it came, `read_as` in plain digits with a point, `value` in the ask's unit.

    `reason` says why a cell is unreadable; `remark` is for a person to look at although the cell was read.
    """

    kind: Literal["number", "blank", "unreadable"]
    typed: str
    value: Fraction | None = None
    read_as: str = ""
    reason: str = ""
    remark: str = ""


def read(typed: str, unit: str) -> Reading:
    """Reads a number in `unit`, which may stand after it; dashes alone count as blank. Never raises.

    >>> read("8,66E-1 m/s", "m/s").value
    Fraction(433, 500)
    >>> read("3/4", "m/s").reason
    '"3/4" is a calculation; a decimal number was expected'
    """
    text = trimmed(typed)
    if len(text) > LONGEST_ANSWER:
        return Reading("unreadable", typed, reason=f"longer than {LONGEST_ANSWER} characters")
    folded = text.translate(_FOLDED)
    if not folded.strip("-"):
        return Reading("blank", typed)
    found = _NUMBER.match(folded)
    if found is None or not (found[2] or found[4]):
        return Reading("unreadable", typed, reason=f'"{_shown(text)}" is not a number')
    reason = _too_long(found) or _unfit_rest(folded[found.end() :], text[found.end() :], text, unit)
    if reason:
        return Reading("unreadable", typed, reason=reason)
    return _number(typed, found)


def _number(typed: str, found: re.Match[str]) -> Reading:
    sign, whole, mark, decimals, exponent = (group or "" for group in found.groups())
    power = f"e{int(exponent)}" if exponent else ""
    read_as = f"{sign.strip('+')}{whole or '0'}{'.' if decimals else ''}{decimals}{power}"
    value = _value(int(f"{sign}{whole}{decimals}"), int(exponent or 0) - len(decimals))
    remark = "" if exponent else _remark(f"{whole}{mark}{decimals}", read_as)
    return Reading("number", typed, value, read_as, remark=remark)


def _value(digits: int, power_of_ten: int) -> Fraction:
    return Fraction(digits * 10**power_of_ten) if power_of_ten >= 0 else Fraction(digits, 10**-power_of_ten)


def _remark(digits: str, read_as: str) -> str:
    return f"read as {read_as}; a comma is the decimal mark" if _THOUSANDS_LIKE.fullmatch(digits) else ""


def _too_long(found: re.Match[str]) -> str:
    _, whole, _, decimals, exponent = (group or "" for group in found.groups())
    if len((whole + decimals).lstrip("0")) > MOST_DIGITS or len(whole + decimals) > LONGEST_ANSWER:
        return f"more than {MOST_DIGITS} digits"
    if abs(int(exponent or 0)) > LARGEST_EXPONENT:
        return f"a power of ten beyond {LARGEST_EXPONENT}"
    return ""


def _unfit_rest(rest: str, rest_as_typed: str, typed: str, unit: str) -> str:
    """Why what follows the number is not the unit asked for, or nothing at all."""
    if not rest or same_unit(rest_as_typed, unit) or same_unit(rest, unit):
        return ""
    text = _shown(typed)
    if rest[0] in "0123456789.,'":
        return f'"{text}" is more than one number, or has a thousands separator; one number was expected'
    if _CALCULATION.match(rest):
        return f'"{text}" is a calculation; a decimal number was expected'
    if _POWER_OF_TEN.match(rest):
        return f'"{text}" is a calculation; a power of ten is written 8.66e-1'
    expected = "no unit" if unit in ("", "1") else f'the unit "{unit}"'
    return f'"{_shown(rest_as_typed)}" stands after the number; {expected} was expected'


def _shown(text: str) -> str:
    """On one line, with everything invisible written out."""
    return "".join(each if each.isprintable() else each.encode("unicode_escape").decode() for each in text)
