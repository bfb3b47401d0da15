"""A sense in words or as an arrow, and what it means for the sign of an ask: clockwise, ↻, to the
left.

`split_sense` takes the words off a folded answer; `find_direction` gives their sign under the ask's
convention.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Literal

from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.language.spellings import match_spellings
from kinegrade.sign_conventions import UNSIGNED, Convention

Sense = Literal["ccw", "cw", "right", "left", "up", "down"]

_OPPOSITE: dict[Sense, Sense] = {
    "ccw": "cw", "cw": "ccw", "right": "left", "left": "right", "up": "down", "down": "up",
}  # fmt: skip
SENSE_WORDS: dict[Sense, Message] = {
    "ccw": Message("typing.sense-ccw"),
    "cw": Message("typing.sense-cw"),
    "right": Message("typing.sense-right"),
    "left": Message("typing.sense-left"),
    "up": Message("typing.sense-up"),
    "down": Message("typing.sense-down"),
}
_ARROWS: dict[Sense, str] = {
    "ccw": "↺⟲", "cw": "↻⟳", "right": "→", "left": "←", "up": "↑", "down": "↓",
}  # fmt: skip
_POSITIVE: Mapping[Convention, Sense | None] = {
    "magnitude": None, "unsigned": None, "signed": None, "ccw": "ccw", "cw": "cw",
    "+x": "right", "-x": "left", "+y": "up", "-y": "down",
}  # fmt: skip

_NO_DIGITS = str.maketrans("", "", "0123456789")


@dataclass(frozen=True)
class _Patterns:
    """What finds a sense behind an answer or before it; where `anywhere` finds nothing, neither
    does.
    """

    anywhere: re.Pattern[str]
    alone: re.Pattern[str]
    behind: re.Pattern[str]
    before: re.Pattern[str]


@cache
def _compile_patterns() -> _Patterns:
    words = "|".join(f"(?P<{sense}>{_match_sense(sense)})" for sense in SENSE_WORDS)
    behind = rf"(?<![\s,;(\[])[\s,;(\[]*(?<![A-Za-z])(?:{words})\.?[\s)\]]*$"
    before = rf"^[\s(\[]*(?:{words})(?![A-Za-z])[\s)\],:.=]*"
    alone = rf"(?<![A-Za-z_])(?:{words})(?![A-Za-z])"
    return _Patterns(*(re.compile(each, re.IGNORECASE) for each in (words, alone, behind, before)))


def _match_sense(sense: Sense) -> str:
    """An expression for the spellings of a sense: a hyphen may be a blank or left out, and so may
    the points of c.c.w.
    """
    words = match_spellings(SENSE_WORDS[sense]).replace(r"\-", "[- ]?").replace(r"\.", r"\.?")
    return f"{words}|[{_ARROWS[sense]}]"


def names_sense(label: str) -> bool:
    """Whether a text before an equals sign or a colon is, or holds, a word for a sense.

    >>> names_sense("clockwise:"), names_sense("v_up ="), names_sense("upsilon =")
    (True, False, False)
    """
    return _compile_patterns().alone.search(label) is not None


@lru_cache(maxsize=4096)
def _may_name_sense(text: str) -> bool:
    """Whether a text without its digits may hold a word for a sense, in which there are none: of
    the answers of a class few differ in anything but digits.
    """
    return _compile_patterns().anywhere.search(text) is not None


def split_sense(text: str) -> tuple[str, Sense | None]:
    """A folded answer without its word for the sense, and that sense; None where there is no such
    word.

    >>> split_sense("12 rad/s (clockwise)")
    ('12 rad/s', 'cw')
    """
    if not _may_name_sense(text.translate(_NO_DIGITS)):
        return text, None
    patterns = _compile_patterns()
    for pattern in (patterns.behind, patterns.before):
        found = pattern.search(text)
        if found:
            sense = next(name for name in SENSE_WORDS if found[name] is not None)
            return text[: found.start()] + text[found.end() :], sense
    return text, None


def find_direction(
    sense: Sense, sign: str, convention: Convention | None, words: str = ""
) -> tuple[int, Text]:
    """(1 or -1, remark): the factor that words give to a number typed with `sign` ("", "+" or
    "-").

    `convention` is the ask's, None where its author states another one; `words` is how its paper
    prints it. Where the ask has no sign, the sense changes nothing and is remarked on. Raises
    Unreadable if a sense contradicts or repeats a sign, or does not determine this ask's sign.
    """
    positive = None if convention is None else _POSITIVE[convention]
    name = Message(f"typing.direction-{sense}")
    if sign == "-" or (sign == "+" and sense != positive):
        raise Unreadable(Message("typing.sign-and-sense", sign=Quoted(sign), sense=name))
    if convention in UNSIGNED:
        return 1, Message("typing.senses-not-asked", sense=name)
    if positive is None or sense not in (positive, _OPPOSITE[positive]):
        raise Unreadable(_describe_no_sign(name, words))
    return (1 if sense == positive else -1), ""


def _describe_no_sign(sense: Message, convention: str) -> Message:
    if not convention:
        return Message("typing.senses-of-no-sign", sense=sense)
    return Message("typing.senses-of-other-sign", sense=sense, convention=convention)
