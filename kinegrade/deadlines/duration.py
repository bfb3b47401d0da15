"""Lengths of time as files state them: `"15 min"`, `"2 days"`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from datetime import timedelta

from kinegrade.errors import FieldError
from kinegrade.files.fields.digits import Digits
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message

_WRITTEN = re.compile(r"([0-9]{1,4}) ?([a-z]+)")
_UNITS: Mapping[str, timedelta] = {
    "min": timedelta(minutes=1),
    "minute": timedelta(minutes=1),
    "h": timedelta(hours=1),
    "hour": timedelta(hours=1),
    "day": timedelta(days=1),
    "week": timedelta(weeks=1),
}
_MINUTE, _HOUR = 60, 60


def read_duration(value: object) -> timedelta:
    """A length of time. Raises FieldError.

    >>> read_duration("15 min"), read_duration("2 days")
    (datetime.timedelta(seconds=900), datetime.timedelta(days=2))
    """
    text = value if isinstance(value, str) and not isinstance(value, Digits) else ""
    written = _WRITTEN.fullmatch(text.strip())
    unit = None if written is None else _UNITS.get(written[2]) or _UNITS.get(written[2][:-1])
    if written is None or unit is None or (written[2] not in _UNITS and written[2][-1] != "s"):
        raise FieldError(found(value), Message("deadline.a-duration"))
    return int(written[1]) * unit


def write_duration(duration: timedelta) -> str:
    """Hours and minutes, begun minutes counted.

    >>> write_duration(timedelta(days=1, minutes=3, seconds=1))
    '24:04'
    """
    minutes = -(-duration // timedelta(minutes=1))
    return f"{minutes // _HOUR}:{minutes % _MINUTE:02d}"
