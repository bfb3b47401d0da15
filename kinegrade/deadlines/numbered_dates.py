"""Dates of two numbers and a year, as 4/10/2026: which number is the day is not certain."""

from __future__ import annotations

import re
from datetime import datetime

from kinegrade.deadlines.moment import parse_moment

_HALF_DAY, _DAY = 12, 24
CLOCK = (
    r"(?:(?P<morning>上午)|(?P<afternoon>下午))? ?"
    r"(?P<hour>[0-9]{1,2}):(?P<minute>[0-9]{2})(?::(?P<second>[0-9]{2}))?"
)
HALF = r"(?: ?(?P<half>[AaPp])\.?[Mm]\.?)?(?: Uhr)?"
ZONE = r"(?: ?(?:GMT|UTC)(?P<sign>[+-])(?P<hours>[0-9]{1,2})(?::(?P<minutes>[0-9]{2}))?)?"
_OF_YEAR = rf"(?P<year>[0-9]{{4}}),? {CLOCK}{HALF}{ZONE}"
_NUMBER = r"[0-9]{1,2}"
_DAY_FIRST = re.compile(rf"(?P<day>{_NUMBER})([./-])(?P<month>{_NUMBER})\2{_OF_YEAR}")
_MONTH_FIRST = re.compile(rf"(?P<month>{_NUMBER})([./-])(?P<day>{_NUMBER})\2{_OF_YEAR}")
ORDERS = {True: _DAY_FIRST, False: _MONTH_FIRST}


def read_in_order(text: str, *, day_first: bool) -> datetime | None:
    """A time whose date is of that order, None where there is no such time.

    >>> [str(read_in_order("4/13/2026 10:15", day_first=first)) for first in (False, True)]
    ['2026-04-13 10:15:00', 'None']
    """
    found = ORDERS[day_first].fullmatch(text)
    return None if found is None else make_moment(found, int(found["month"]))


def make_moment(found: re.Match[str], month: int) -> datetime | None:
    """The time that was found in a month, None where there is none."""
    hour, half = int(found["hour"]), found["half"]
    if half or found["morning"] or found["afternoon"]:
        if not 1 <= hour <= _HALF_DAY:
            return None
        is_late = found["afternoon"] is not None or (half or "").lower() == "p"
        hour = hour % _HALF_DAY + (_HALF_DAY if is_late else 0)
    if hour >= _DAY:
        return None
    date = f"{found['year']}-{month:02d}-{int(found['day']):02d}"
    clock = f"{hour:02d}:{found['minute']}:{found['second'] or '00'}"
    zone = ""
    if found["sign"]:
        zone = f" {found['sign']}{int(found['hours']):02d}:{found['minutes'] or '00'}"
    return parse_moment(f"{date} {clock}{zone}")
