"""A sense in words: clockwise, 逆时针, ↻, to the left; and what it means for the sign of an ask.

`split_sense` takes the words off a folded answer; `find_direction` gives their sign under the ask's
convention.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Literal

from kinegrade.grading.number_text import Unreadable
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.sign_conventions import UNSIGNED, Convention

Sense = Literal["ccw", "cw", "right", "left", "up", "down"]

_OPPOSITE: dict[Sense, Sense] = {
    "ccw": "cw", "cw": "ccw", "right": "left", "left": "right", "up": "down", "down": "up",
}  # fmt: skip
_TURNING = r"(?:方向|转动|旋转|转)?"
_WORDS: dict[Sense, str] = {
    "ccw": rf"(?:counter|anti)[- ]?clockwise|c\.?c\.?w|acw|逆[时時][针針]{_TURNING}|[↺⟲]",
    "cw": rf"clockwise|c\.?w|[顺順][时時][针針]{_TURNING}|[↻⟳]",
    "right": r"(?:to the )?right(?:wards?)?|(?:水平)?向右|→",
    "left": r"(?:to the )?left(?:wards?)?|(?:水平)?向左|←",
    "up": r"up(?:wards?)?|(?:竖直|铅直)?向上|↑",
    "down": r"down(?:wards?)?|(?:竖直|铅直)?向下|↓",
}
_ANY = "|".join(f"(?P<{sense}>{words})" for sense, words in _WORDS.items())
_HINT = re.compile(r"cw|c\.|left|right|up|down|[向时時↺⟲↻⟳→←↑↓]|clock", re.IGNORECASE)
_BEHIND = re.compile(rf"(?<![\s,;(\[])[\s,;(\[]*(?<![A-Za-z])(?:{_ANY})\.?[\s)\]]*$", re.IGNORECASE)
_BEFORE = re.compile(rf"^[\s(\[]*(?:{_ANY})(?![A-Za-z])[\s)\],:.]*", re.IGNORECASE)
_POSITIVE: Mapping[Convention, Sense | None] = {
    "magnitude": None, "unsigned": None, "signed": None, "ccw": "ccw", "cw": "cw",
    "+x": "right", "-x": "left", "+y": "up", "-y": "down",
}  # fmt: skip


def split_sense(text: str) -> tuple[str, Sense | None]:
    """A folded answer without its word for the sense, and that sense; None where there is no such
    word.

    >>> split_sense("12 rad/s (clockwise)")
    ('12 rad/s', 'cw')
    """
    for pattern in (_BEHIND, _BEFORE) if _HINT.search(text) else ():
        found = pattern.search(text)
        if found:
            sense = next(name for name in _WORDS if found[name] is not None)
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
        return 1, Message("typing.sense-not-asked", sense=name)
    if positive is None or sense not in (positive, _OPPOSITE[positive]):
        raise Unreadable(_describe_no_sign(name, words))
    return (1 if sense == positive else -1), ""


def _describe_no_sign(sense: Message, convention: str) -> Message:
    if not convention:
        return Message("typing.sense-of-no-sign", sense=sense)
    return Message("typing.sense-of-other-sign", sense=sense, convention=convention)
