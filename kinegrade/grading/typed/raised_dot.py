"""A dot between digits, 20·8 or 8.10^-3: times for some, a decimal point for others."""

from __future__ import annotations

import re

from kinegrade.grading.typed.keyboard import RAISED_DOTS, RAISED_NUMBERS, show
from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.language.message import Message, Quoted, Text

# Of the keyboard and in full width
_MARKS, _CARETS, _STARS = ".,\uff0e\uff0c", r"\^\uff3e", r"\*\*|\uff0a\uff0a"
# Only times: beside a decimal mark or another dot, and before a power
_DOUBTFUL = re.compile(
    rf"(?<![\d{_MARKS}'{RAISED_DOTS}])(\d+)[{RAISED_DOTS}](\d+)"
    rf"(?![\d{RAISED_DOTS}{RAISED_NUMBERS}\u207b\u207a]|[{_MARKS}]\d|\s?(?:[{_CARETS}]|{_STARS}))"
)
_BEFORE_TEN = re.compile(r"\s*([0-9]+)[.,]10(\s*(?:\^|\*\*).*)")


def find_raised_dot(text: str) -> Text | None:
    """Why an answer with such a dot cannot be read; None where it has none.

    >>> find_raised_dot("3·10^2"), find_raised_dot("2·√3"), find_raised_dot("0.5·3")
    (None, None, None)
    >>> find_raised_dot("３·１０＾２"), find_raised_dot("2·3．5")
    (None, None)
    """
    found = None if text.isascii() else _DOUBTFUL.search(text)
    if found is None:
        return None
    whole, decimals = found.groups()
    point, times = f"{whole}.{decimals}", f"{whole}*{decimals}"
    return Message("typing.raised-dot", typed=Quoted(found[0]), point=point, times=times)


def require_no_dot_for_times(text: str, start: int, end: int) -> None:
    """Raises Unreadable for a power such as 8.10^-3, which is 8·10^-3 to who writes the dot for
    times.
    """
    if found := _BEFORE_TEN.fullmatch(text, start, end):
        whole, power = found.groups()
        point, times = f"({whole}.10){power}", f"{whole}*10{power}"
        typed = Quoted(show(found[0].strip()))
        raise Unreadable(Message("typing.raised-dot", typed=typed, point=point, times=times))
