"""Lines of key.jsonl as `generate` writes them, decoded by their types: a class of 100,000 has a million keys.

`PaperDecoder` is used by `exam_folder`. What is not of the usual shape, and every fault, is left to `key_line`, so that
a line means the same whichever reads it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isclose, isfinite

import msgspec

from kinegrade.grading.json_fields import NUMBER, RATIONAL, FieldError, not_negative, parsed
from kinegrade.grading.key import Ask, Key, Paper, Rule, StatedKey
from kinegrade.grading.key_line import AGREEMENT, exact_paper, rule_of

_DECIMALS = re.compile(rf"(?:{NUMBER}\n)*+")
_MOST_TERMS = 1000  # papers whose tolerances are kept, in case they differ on each
_Terms = tuple[Rule, Fraction | None]


class _Entry(msgspec.Struct, gc=False):
    """The key of one ask; mistakes, which stand there as texts of a few digits, are taken to double precision."""

    unit: str
    points: msgspec.Raw
    value: float
    decimal: str
    tolerance: msgspec.Raw
    exact: str | None = None
    period: msgspec.Raw = msgspec.Raw(b"null")
    mistakes: dict[str, float] = {}


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
        self._terms: dict[tuple[tuple[str, bytes, bytes, bytes], ...], Sequence[_Terms]] = {}

    def paper(self, line: str, names: Mapping[str, str]) -> Paper:
        """The paper on a line; `names` gives the student's. Raises FieldError."""
        keys: Sequence[Key | StatedKey]
        try:
            student, keys = self._usual(line)
        except _UNUSUAL:
            student, keys = exact_paper(self._asks, line)
        return Paper(student, names.get(student, ""), keys)

    def _usual(self, line: str) -> tuple[str, list[StatedKey]]:
        found = self._decode(line)
        if [(each.question, name) for each in found.questions for name in each.asks] != self._columns:
            raise _UnusualError
        entries = [entry for each in found.questions for entry in each.asks.values()]
        if not _DECIMALS.fullmatch("".join([f"{entry.decimal}\n" for entry in entries])):
            raise _UnusualError
        if not isfinite(sum([sum(entry.mistakes.values()) for entry in entries])):
            raise _UnusualError
        terms = self._terms_of(tuple([
            (entry.unit, bytes(entry.points), bytes(entry.tolerance), bytes(entry.period)) for entry in entries]))
        return found.student, [
            StatedKey(*_value(entry), stated, entry.mistakes, period)
            for entry, (stated, period) in zip(entries, terms, strict=True)
        ]

    def _terms_of(self, stated: tuple[tuple[str, bytes, bytes, bytes], ...]) -> Sequence[_Terms]:
        """Rule and period of each ask; they are the same on most papers."""
        if stated not in self._terms:
            if len(self._terms) > _MOST_TERMS:
                self._terms.clear()
            for ask, (unit, points, _, _) in zip(self._asks, stated, strict=True):
                if unit != ask.unit or _number(points) != ask.points:
                    raise _UnusualError
            self._terms[stated] = [(rule_of(parsed(tolerance.decode())), None if period == b"null" else _number(period))
                                   for _, _, tolerance, period in stated]
        return self._terms[stated]


def _number(raw: bytes) -> Fraction:
    return not_negative({"": parsed(raw.decode())}, "")


def _value(entry: _Entry) -> tuple[str, float]:
    """The exact value where it is a plain number, else the decimal; as text, and rightly rounded to a double."""
    decimal, exact = float(entry.decimal), entry.exact
    text, value = entry.decimal, decimal
    if exact is not None and "(" not in exact and RATIONAL.fullmatch(exact):
        numerator, _, denominator = exact.partition("/")
        text, value = exact, int(numerator) / int(denominator or 1)
    if not (isclose(value, decimal, rel_tol=AGREEMENT) and isclose(value, entry.value, rel_tol=AGREEMENT)):
        raise _UnusualError
    return text, value
