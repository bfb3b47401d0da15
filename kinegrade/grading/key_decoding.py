"""Lines of key.jsonl as `generate` writes them, decoded by their types: a class of 100,000 has a million keys.

`PaperDecoder` is used by `exam_folder`. What is not of the usual shape, and every fault, is left to `key_line`, so that
a line means the same whichever reads it. Only mistakes are looked at later, by `stated_keys`: a fault in them is found
where an answer is held against them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isclose, nan

import msgspec

from kinegrade.grading.json_fields import NUMBER, RATIONAL, FieldError, not_negative, parsed
from kinegrade.grading.key import Ask, Keys, Paper
from kinegrade.grading.key_line import exact_paper, rule_of
from kinegrade.grading.stated_keys import StatedKeys, Terms

_DECIMALS = re.compile(rf"{NUMBER}(?:\n{NUMBER})*+")
_MOST_TERMS = 1000  # papers whose tolerances are kept, in case they differ on each
_PARTS = 4  # of the terms of an ask: unit, points, tolerance, period


class _Entry(msgspec.Struct, gc=False):
    """The key of one ask; what is mostly the same, or not wanted, stays as it is written."""

    unit: msgspec.Raw
    points: msgspec.Raw
    value: float
    decimal: str
    tolerance: msgspec.Raw
    exact: str | None = None
    period: msgspec.Raw = msgspec.Raw(b"null")
    mistakes: msgspec.Raw = msgspec.Raw(b"{}")


class _Question(msgspec.Struct, gc=False):
    question: str
    asks: dict[str, _Entry]


class _Line(msgspec.Struct, gc=False):
    student: str
    questions: list[_Question]


class _UnusualError(Exception):
    """A line that has to be read with more patience."""


_UNUSUAL = (
    _UnusualError, FieldError, msgspec.MsgspecError, AttributeError, ArithmeticError, RecursionError, ValueError,
)  # fmt: skip


class PaperDecoder:
    """Reads the lines of one key.jsonl."""

    def __init__(self, asks: Sequence[Ask]) -> None:
        self._asks = asks
        self._columns = [(ask.question, ask.ask) for ask in asks]
        self._decode = msgspec.json.Decoder(_Line, strict=False).decode
        self._terms: dict[bytes, Terms] = {}

    def paper(self, line: bytes, place: str, names: Mapping[str, str]) -> Paper:
        """The paper on a line; `place` is the line's in messages, `names` give the student's.

        Raises FieldError, and UnicodeDecodeError where it is not UTF-8.
        """
        keys: Keys
        text = "" if line.isascii() else line.decode("utf-8")
        try:
            student, keys = self._usual(line, place)
        except _UNUSUAL:
            student, keys = exact_paper(self._asks, text or line.decode("utf-8"))
        return Paper(student, names.get(student, ""), keys)

    def _usual(self, line: bytes, place: str) -> tuple[str, StatedKeys]:
        found = self._decode(line)
        if [(each.question, name) for each in found.questions for name in each.asks] != self._columns:
            raise _UnusualError
        entries = [entry for each in found.questions for entry in each.asks.values()]
        decimals = [entry.decimal for entry in entries]
        if not _DECIMALS.fullmatch("\n".join(decimals)):
            raise _UnusualError
        terms = self._terms_of(b"\0".join([
            part for entry in entries for part in (entry.unit, entry.points, entry.tolerance, entry.period)]))
        values, centres = _values(entries, decimals)
        if any(terms.periods):
            centres = [nan if period else centre for centre, period in zip(centres, terms.periods, strict=True)]
        where = f'{place}: student "{found.student}"'
        return found.student, StatedKeys(where, values, centres, terms, [entry.mistakes for entry in entries])

    def _terms_of(self, stated: bytes) -> Terms:
        """Rule and period of each ask; they are the same on most papers."""
        if stated not in self._terms:
            if len(self._terms) > _MOST_TERMS:
                self._terms.clear()
            parts = [parsed(part.decode()) for part in stated.split(b"\0")]
            units, points, tolerances, periods = (parts[place::_PARTS] for place in range(_PARTS))
            for ask, unit, worth in zip(self._asks, units, points, strict=True):
                if unit != ask.unit or _number(worth) != ask.points:
                    raise _UnusualError
            self._terms[stated] = Terms(self._asks, tuple(map(rule_of, tolerances)),
                                        tuple(None if period is None else _number(period) for period in periods))
        return self._terms[stated]


def _number(item: object) -> Fraction:
    return not_negative({"": item}, "")


def _values(entries: Sequence[_Entry], decimals: list[str]) -> tuple[list[str], list[float]]:
    """The exact values where they are plain numbers, else the decimals: as texts, and rightly rounded to doubles."""
    rounded = list(map(float, decimals))
    values, centres = decimals, rounded
    plain = [number for number, entry in enumerate(entries) if entry.exact is not None and "(" not in entry.exact]
    if plain:
        values, centres = decimals.copy(), rounded.copy()
    for number in plain:
        exact = entries[number].exact or ""
        if RATIONAL.fullmatch(exact):
            numerator, _, denominator = exact.partition("/")
            values[number], centres[number] = exact, int(numerator) / int(denominator or 1)
    close = all(map(isclose, centres, rounded)) and all(map(isclose, centres, [entry.value for entry in entries]))
    if not close:  # isclose compares to 1e-9 of itself, as key_line does; to be told so makes it four times slower
        raise _UnusualError
    return values, centres
