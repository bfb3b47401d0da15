"""Lines of key.jsonl as `generate` writes them, decoded by their types: a class of 100,000 has a
million keys.

`PaperDecoder` is used by `key_stream`, with many lines at once. Lines of any other shape, and every
fault, are left to `exact_keys`, so that a line means the same whichever of the two reads it. Only
mistakes are decoded later, by `stated_keys`: a fault in them is found when an answer is compared
with them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import chain, groupby, islice
from math import isclose, nan
from operator import attrgetter
from types import GenericAlias
from typing import Annotated, Any, Literal

import msgspec
from msgspec.structs import astuple

from kinegrade.errors import FieldError
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.key.exact_keys import (
    ListedKeys,
    read_exact_keys,
    read_key_line,
    read_rule,
)
from kinegrade.exam.folder.key.lines import StatedTolerance
from kinegrade.exam.folder.key.stated_keys import Entry, Place, StatedKeys, Terms
from kinegrade.exam.folder.numbers import MOST_DIGITS, require_not_negative
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.csv_writing import encode

_REMOTE = re.compile("[eE][+-]?[0-9]{3}")  # powers of ten that no number may have
_MOST_TERMS = 1000  # papers whose tolerances are kept, in case they differ on each
_TERMS = attrgetter("tolerance", "period")


class _UnusualError(Exception):
    """A line that has to be left to `exact_keys`."""


_UNUSUAL = (
    _UnusualError,
    FieldError,
    AttributeError,
    ArithmeticError,
    RecursionError,
    ValueError,
)
_decoded_tolerance = msgspec.json.Decoder(StatedTolerance).decode
_decoded_period = msgspec.json.Decoder(Decimal | None).decode


class PaperDecoder:
    """Reads the lines of one file of keys, of an exam with that head."""

    def __init__(self, head: ExamHead) -> None:
        asks = head.asks
        self._asks, self._candidates, self._choices = asks, head.candidates, head.choices
        self._decode = msgspec.json.Decoder(_define_line_type(asks), strict=False).decode
        self._terms: dict[bytes, Terms] = {}

    def usual(self, lines: Sequence[bytes], places: Sequence[Place]) -> list[Paper] | None:
        """The papers on these lines, or None if one is not of the usual shape; `places` are the
        lines' in messages. Papers with alternatives are of different shapes.
        """
        if self._choices:
            return None
        try:
            return self._papers(lines, places)
        except _UNUSUAL:
            return None

    def paper(self, line: bytes, place: Place) -> Paper:
        """The paper on a line of any shape. Raises FieldError, and UnicodeDecodeError where it is
        not UTF-8.
        """
        for paper in self.usual([line], [place]) or ():
            return paper
        record = read_key_line(line)
        keys = ListedKeys(read_exact_keys(self._asks, record, self._choices))
        return Paper(record.student, self._name(record.student), keys)

    def _name(self, student: str) -> str:
        candidate = self._candidates.get(student)
        return candidate.name if candidate else ""

    def _papers(self, lines: Sequence[bytes], places: Sequence[Place]) -> list[Paper]:
        found = [self._decode(line) for line in lines if line.isascii() or line.decode("utf-8")]
        papers = [
            [*chain.from_iterable([astuple(each.asks) for each in line.questions])]
            for line in found
        ]
        entries = [*chain.from_iterable(papers)]
        centres = iter(_round_centres(entries))
        return [
            Paper(
                line.student,
                self._name(line.student),
                self._keys(place, line.student, keys, [*islice(centres, len(keys))]),
            )
            for line, place, keys in zip(found, places, papers, strict=True)
        ]

    def _keys(
        self, place: Place, student: str, entries: list[Entry], centres: list[float]
    ) -> StatedKeys:
        terms = self._terms_of(b"\0".join(chain.from_iterable(map(_TERMS, entries))))
        if any(terms.periods):
            centres = [
                nan if period else centre
                for centre, period in zip(centres, terms.periods, strict=True)
            ]
        return StatedKeys(place, student, entries, centres, terms)

    def _terms_of(self, stated: bytes) -> Terms:
        """Rule and period of each ask; they are the same on most papers."""
        if stated not in self._terms:
            if len(self._terms) > _MOST_TERMS:
                self._terms.clear()
            parts = stated.split(b"\0")
            rules = tuple(read_rule(_decoded_tolerance(part)) for part in parts[::2])
            self._terms[stated] = Terms(self._asks, rules, tuple(map(_find_period, parts[1::2])))
        return self._terms[stated]


def _find_period(stated: bytes) -> Fraction | None:
    period = _decoded_period(stated)
    return None if period is None else require_not_negative("period", period)


def _define_line_type(asks: Sequence[Ask]) -> Any:
    """The type of a line with these asks: its questions are a tuple, their asks in the order of the
    paper.
    """
    questions = []
    for question, group in groupby(asks, attrgetter("question")):
        asked = {f"ask_{number}": ask for number, ask in enumerate(group)}
        keys = msgspec.defstruct(
            "Keys",
            [(field, _define_entry_type(ask)) for field, ask in asked.items()],
            gc=False,
            rename={field: ask.ask for field, ask in asked.items()},
            forbid_unknown_fields=True,
        )
        questions.append(
            msgspec.defstruct(
                "Question", [("question", Literal[question]), ("asks", keys)], gc=False
            )
        )
    listed = GenericAlias(tuple, tuple(questions))
    return msgspec.defstruct("Line", [("student", str), ("questions", listed)], gc=False)


def _define_entry_type(ask: Ask) -> type[msgspec.Struct]:
    """The type of the key of an ask, which has the unit and the points that exam.json states."""
    unit, points = (
        encode(ask.unit).decode(),
        float(ask.points),
    )  # no line that is UTF-8 has a lone surrogate
    only = msgspec.Meta(ge=points, le=points)
    return msgspec.defstruct(
        "Entry",
        [("unit", Literal[unit]), ("points", Annotated[float, only])],
        bases=(Entry,),
        frozen=True,
        gc=False,
    )


def _round_centres(entries: Sequence[Entry]) -> list[float]:
    """The right answers rightly rounded to doubles: of the exact value where it is a plain number,
    else the decimal.
    """
    decimals = [entry.decimal for entry in entries]
    digits = "\n".join(decimals)
    if max(map(len, decimals)) > MOST_DIGITS or (
        ("e" in digits or "E" in digits) and _REMOTE.search(digits)
    ):
        raise _UnusualError
    rounded = msgspec.convert(decimals, list[float], strict=False)
    centres = rounded.copy()
    for number, entry in enumerate(entries):
        if entry.exact is not None and "(" not in entry.exact and (plain := entry.plain):
            numerator, _, denominator = plain.partition("/")
            centres[number] = int(numerator) / int(denominator or 1)
    stated = [entry.value for entry in entries]
    if not (_are_close(centres, rounded) and _are_close(centres, stated)):
        raise _UnusualError
    return centres


def _are_close(numbers: Sequence[float], others: Sequence[float]) -> bool:
    """Whether all agree to 1e-9, as exact_keys asks for and isclose takes it where nothing is
    stated, which would be four times slower.
    """
    return numbers == others or all(map(isclose, numbers, others))
