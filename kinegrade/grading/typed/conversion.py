"""What a number in one unit is in another.

`find_conversion` is called by `answers` for the text after a number. It compares dimensions before
any numbers are compared, and converts exactly: a factor and a power of pi, because a turn is 2 pi
radians.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache

from kinegrade.grading.typed.keyboard import BLANKS, show
from kinegrade.grading.typed.number_text import TypingFault, Unreadable
from kinegrade.grading.typed.unit_spelling import WrittenUnit, is_per_minute, read_unit
from kinegrade.language.message import Message, Part, Quoted
from kinegrade.language.spellings import match_spellings

_CYCLES = Message("typing.turns-per-second")
_TIMES = re.compile(r"^\*\s*(?=[^\W\d]|°)")
_PURE = ("", "1")  # as a unit: none
# Another number behind the first one of an answer; 1/s is a unit
_NEXT_NUMBER = re.compile(r"[\s.,;'\u3001~=\u2248]*(?:[+-]\s*)?\(?\s*[0-9]")
_OTHER_NUMBER = re.compile(
    r"(?:^|\s)(?:[^\W\d_]+\.?\s+|[\u4e00-\u9fff]+\s*|[|&]\s*)[+-]?[0-9]"
)  # behind a word: 3 or 4
_SHARE_OF_TIME = re.compile(r"\s*1\s*/\s*[^\W\d]|\s*\(\s*1\s*/")


class WrongUnit(TypingFault):
    """A well-written unit that measures something other than what is asked."""


@dataclass(frozen=True, slots=True)
class Conversion:
    """A typed number times factor * pi**pi is the number in the ask's unit."""

    factor: Fraction = Fraction(1)
    pi: int = 0


_SAME = Conversion()


@lru_cache(maxsize=4096)
def find_conversion(typed: str, unit: str) -> Conversion:
    """How a number typed with the unit `typed` becomes one in `unit`; no unit means the ask's.

    Radians may be left out (1/s for rad/s), never added; turns may where they are asked for (1/min
    and Hz). Raises WrongUnit for another dimension, Hz else included, and Unreadable for an unknown
    unit.

    >>> find_conversion("r/min", "rad/s"), find_conversion("cm/s²", "m/s^2").factor
    (Conversion(factor=Fraction(1, 30), pi=1), Fraction(1, 100))
    """
    written = _drop_brackets(typed)
    if written in ("", unit) or (unit in _PURE and written == "1"):
        return _SAME
    wanted = read_unit(unit) if unit not in _PURE else WrittenUnit(Fraction(1), 0, 0, 0, 0)
    if wanted is not None and wanted.counts_turns:
        written = _add_turns(written)
    else:
        _refuse_turns_per_time(written, unit, wanted)
    found = read_unit(written)
    if found is None or wanted is None:
        raise Unreadable(_describe_unknown(Quoted(show(typed.strip())), unit))
    lengths_and_times = (found.length, found.time) == (wanted.length, wanted.time)
    radians_left_out = found.angle == 0 and wanted.angle == 1 and wanted.time < 0 and wanted.pi == 0
    if not lengths_and_times or not (found.angle == wanted.angle or radians_left_out):
        raise WrongUnit(_describe_other_kind(Quoted(show(written)), found.kind, wanted.kind, unit))
    return Conversion(found.factor / wanted.factor, found.pi - wanted.pi)


def _describe_unknown(typed: Quoted, unit: str) -> Message:
    if unit in _PURE:
        return Message("typing.no-unit-wanted", typed=typed)
    return Message("typing.unknown-unit", typed=typed, unit=Quoted(unit))


def _describe_other_kind(typed: Quoted, found: Part, wanted: Part, unit: str) -> Message:
    if unit in _PURE:
        return Message("typing.not-pure", typed=typed, found=found, wanted=wanted)
    return Message("typing.other-kind", typed=typed, found=found, wanted=wanted, unit=Quoted(unit))


def _add_turns(written: str) -> str:
    """A count per time with what is counted: turns."""
    if is_per_minute(written):
        return "r/min"
    found = _compile_turn_counts().fullmatch(written)
    return "r/s" if found and not found[1] else written


def _refuse_turns_per_time(written: str, unit: str, wanted: WrittenUnit | None) -> None:
    typed = Quoted(show(written))
    if _compile_turn_counts().fullmatch(written):
        raise WrongUnit(_describe_turns(typed, unit, wanted))
    if wanted is not None and wanted.angle and is_per_minute(written):
        raise Unreadable(Message("typing.per-minute", typed=typed))


@cache
def _compile_turn_counts() -> re.Pattern[str]:
    return re.compile(rf"([kM])?Hz|{match_spellings(_CYCLES)}", re.IGNORECASE)


def _describe_turns(typed: Quoted, unit: str, wanted: WrittenUnit | None) -> Message:
    if wanted is None:
        return Message("typing.turns-for-unit", typed=typed, unit=Quoted(unit))
    if unit in _PURE:
        return Message("typing.turns-for-number", typed=typed, wanted=wanted.kind)
    return Message("typing.turns-for-kind", typed=typed, wanted=wanted.kind, unit=Quoted(unit))


def _drop_brackets(typed: str) -> str:
    written = _TIMES.sub("", typed.strip())
    if written[:1] + written[-1:] in ("()", "[]", "\uff08\uff09", "【】", "{}"):
        return written[1:-1].strip()
    return written


def find_only_conversion(rest: str, unit: str, typed: str) -> Conversion:
    """The conversion that the text behind the number of an answer calls for. Raises Unreadable,
    with the answer as it was typed where that has another number, or WrongUnit.
    """
    several = Message("typing.more-than-one", typed=Quoted(show(typed.strip(BLANKS))))
    if _NEXT_NUMBER.match(rest) and not _SHARE_OF_TIME.match(rest):
        raise Unreadable(several)
    try:
        return find_conversion(rest, unit)
    except Unreadable as unknown:
        if _OTHER_NUMBER.search(rest):
            raise Unreadable(several) from unknown
        raise
