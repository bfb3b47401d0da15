"""The keys of one paper as they stand on its line of key.jsonl, decoded no further than needed.

`key_decoding` makes them, and `columns.gathering` reads them: one list for all asks is faster than
a key for each. Mistakes, about ten for every answer, are decoded only where an answer is
wrong.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from math import isfinite
from pathlib import Path
from typing import NamedTuple

import msgspec

from kinegrade.errors import ExamError, FieldError, Problem
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.faults import describe_damage, explain_broken, name_line
from kinegrade.exam.folder.key.exact_keys import read_mistakes as read_exact_mistakes
from kinegrade.exam.folder.keys import StatedKey
from kinegrade.exam.folder.numbers import RATIONAL
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.numbers.tolerance import Tolerance

_all_decoded = msgspec.json.Decoder(list[dict[str, float]], strict=False).decode
_decoded = msgspec.json.Decoder(dict[str, float], strict=False).decode
_exactly_decoded = msgspec.json.Decoder(dict[str, str]).decode


class Place(NamedTuple):
    """Where the line of a paper stands, for messages; 0 where its number is not known."""

    file: Path
    line: int = 0

    def locate(self, fault: Fault) -> Fault:
        """A fault of that line, with its number."""
        return Fault(name_line(self.line), fault) if self.line else fault


class Entry(msgspec.Struct, frozen=True, gc=False):
    """The key of one ask; what is usually the same on all papers, or not needed, is not decoded."""

    unit: str
    points: float
    value: float
    decimal: str
    tolerance: msgspec.Raw
    exact: str | None = None
    period: msgspec.Raw = msgspec.Raw(b"null")
    mistakes: msgspec.Raw = msgspec.Raw(b"{}")

    @property
    def plain(self) -> str:
        """The exact value where it is a plain number or fraction, else empty."""
        return self.exact if self.exact is not None and RATIONAL.fullmatch(self.exact) else ""


@dataclass(frozen=True, slots=True)
class Terms:
    """The rule and the period of each ask; papers on which they are equal share one object."""

    asks: Sequence[Ask]
    rules: tuple[Tolerance, ...]
    periods: tuple[Fraction | None, ...]


class UsualKeys:
    """What the keys of a paper that holds every ask say by its terms; one with alternatives is of
    no usual shape.
    """

    __slots__ = ()

    @property
    @abstractmethod
    def terms(self) -> Terms:
        """The rule and the period of each ask."""

    def list_periods(self) -> Sequence[Fraction | None]:
        """The full turn of each ask, where any number of turns is right too."""
        return self.terms.periods

    def list_rules(self) -> tuple[Tolerance, ...]:
        """The rule of each ask."""
        return self.terms.rules

    def find_lacking(self) -> frozenset[int]:
        """The asks that the paper does not hold: none."""
        return frozenset()


class StatedKeys(UsualKeys, msgspec.Struct, frozen=True, gc=False):
    """The keys in the order of the asks; `place` and `student` are whose line of which file that
    is, for messages.

    `centres` are the right answers rightly rounded to doubles, or NaN where a number of turns is
    right too.
    """

    place: Place
    student: str
    entries: Sequence[Entry]
    centres: Sequence[float]
    terms: Terms

    def __getitem__(self, ask: int) -> StatedKey:
        """The key of an ask. Raises ExamError if its mistakes are no numbers."""
        return StatedKey(
            self.state(ask),
            self.terms.rules[ask],
            self.mistakes(ask),
            self.terms.periods[ask],
        )

    def __len__(self) -> int:
        return len(self.entries)

    def __iter__(self) -> Iterator[StatedKey]:
        return map(self.__getitem__, range(len(self)))

    def state(self, ask: int, /) -> str:
        """The right answer to an ask, as a decimal or a fraction."""
        return self.entries[ask].plain or self.entries[ask].decimal

    def list_centres(self) -> Sequence[float]:
        """The right answers rightly rounded, NaN where a number of turns is right too."""
        return self.centres

    def list_values(self) -> Sequence[float]:
        """The right answers in double precision, those of cyclic angles too."""
        return [entry.value for entry in self.entries]

    def mistakes(self, ask: int) -> Mapping[str, float | Fraction]:
        """What mistakes lead to: doubles for the usual texts of a few digits, else exactly. Raises
        ExamError.
        """
        written = self.entries[ask].mistakes
        try:
            usual = _decoded(written)
            if isfinite(sum(usual.values())):
                return usual
        except (msgspec.MsgspecError, ValueError):
            pass
        try:
            return read_exact_mistakes(_exactly_decoded(written))
        except FieldError as fault:
            raise self._explain(ask, fault.faults[0]) from fault
        except ValueError as fault:
            raise self._explain(ask, Fault("mistakes", describe_damage(fault))) from fault

    def _explain(self, ask: int, fault: Problem) -> ExamError:
        whose = Message("exam.student", student=Quoted(self.student))
        found = Fault(whose, Fault(self.terms.asks[ask].column, fault))
        return explain_broken(self.place.file, [self.place.locate(found)])


def read_stated_mistakes(
    asks: Sequence[tuple[StatedKeys, int]],
) -> Sequence[Mapping[str, float | Fraction]]:
    """The mistakes of these asks, decoded at once. Raises ExamError as `StatedKeys.mistakes`
    does.
    """
    try:
        found = _all_decoded(
            b"[%b]" % b",".join([keys.entries[ask].mistakes for keys, ask in asks])
        )
        if isfinite(sum(chain.from_iterable([each.values() for each in found]))):
            return found
    except (msgspec.MsgspecError, ValueError):
        pass
    return [keys.mistakes(ask) for keys, ask in asks]
