"""A raised dot between digits, 20·8: times for some, a decimal point for others."""

from __future__ import annotations

import re

from kinegrade.grading.typed.keyboard import RAISED_DOTS, RAISED_NUMBERS
from kinegrade.language.message import Message, Quoted, Text

# Of the keyboard and in full width
_MARKS, _CARETS, _STARS = ".,\uff0e\uff0c", r"\^\uff3e", r"\*\*|\uff0a\uff0a"
# Only times: beside a decimal mark or another dot, and before a power
_DOUBTFUL = re.compile(
    rf"(?<![\d{_MARKS}'{RAISED_DOTS}])(\d+)[{RAISED_DOTS}](\d+)"
    rf"(?![\d{RAISED_DOTS}{RAISED_NUMBERS}\u207b\u207a]|[{_MARKS}]\d|\s?(?:[{_CARETS}]|{_STARS}))"
)


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
