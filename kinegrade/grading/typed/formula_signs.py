"""The signs of which typed formulas are made, as patterns on a folded text.

`value` reads formulas with them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from kinegrade.language.message import Message
from kinegrade.language.spellings import match_spellings

_VULGAR = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
_ROOT_WORDS = Message("typing.root")
MIXED = re.compile(rf"\s?[{_VULGAR}]")
PI = re.compile(r"[πΠ𝜋]|pi(?![a-z])", re.IGNORECASE)
POWER = re.compile(
    r"\s*(?:\^|\*\*)\s*(?:\(\s*([+-]?[0-9]{1,3})\s*\)|([+-]?[0-9]{1,3})(?![0-9.,/]))"
)
HALF = re.compile(r"\s*(?:\^|\*\*)\s*(?:\(\s*1/2\s*\)|\(\s*0?[.,]5\s*\)|0?[.,]5(?![0-9.,]))")
TEN = re.compile(r"\s*10\s*(?:\^|\*\*)")
OPERATOR = re.compile(r"\s*([-+*/])(?!\*)")


@dataclass(frozen=True)
class Beginnings:
    """What begins a value, a factor without a multiplication sign, and a root."""

    value: re.Pattern[str]
    factor: re.Pattern[str]
    root: re.Pattern[str]


@cache
def compile_beginnings() -> Beginnings:
    """The beginnings, with the words for a root in all languages."""
    root = f"√|sqrt|{match_spellings(_ROOT_WORDS)}"
    factor = rf"[(πΠ𝜋]|{root}|pi(?![a-z])"
    value = rf"[0-9{_VULGAR}]|[.,][0-9]|{factor}"
    patterns = rf"\s*(?:{value})", rf"\s*(?:{factor})", rf"(?:{root})\s*"
    return Beginnings(*(re.compile(pattern, re.IGNORECASE) for pattern in patterns))


def is_continued(text: str, place: int) -> bool:
    """Whether a number continues as a formula: an operator before a value, a power, or a root or pi
    directly after it.
    """
    operator = OPERATOR.match(text, place)
    if operator and compile_beginnings().value.match(text, operator.end()):
        return True
    signs = POWER, HALF, MIXED, compile_beginnings().factor
    return any(sign.match(text, place) for sign in signs)
