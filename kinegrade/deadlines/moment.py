"""A moment at which something is due or was handed in: a date with the time of day, and its
difference from UTC where that is stated.

A moment without one is in the time of the place of the course; two moments can be compared only
where both have it, or neither.
"""

from __future__ import annotations

import re
from datetime import UTC, datetime

from kinegrade.errors import FieldError
from kinegrade.files.fields.digits import Digits
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message

_WRITTEN = re.compile(
    r"([0-9]{4}-[0-9]{2}-[0-9]{2})[T ]+([0-9]{2}:[0-9]{2}(?::[0-9]{2})?)(?:\.[0-9]{1,6})?"
    r"(?: ?(Z|UTC|[+-][0-9]{2}:[0-9]{2}))?"
)


def read_moment(value: object) -> datetime:
    """A moment: a text, or a date and time of TOML. Raises FieldError.

    >>> read_moment("2026-12-01 18:00")
    datetime.datetime(2026, 12, 1, 18, 0)
    """
    if isinstance(value, datetime):
        return value
    text = value if isinstance(value, str) and not isinstance(value, Digits) else ""
    moment = parse_moment(text.strip())
    if moment is None:
        raise FieldError(found(value), Message("deadline.a-moment"))
    return moment


def parse_moment(text: str) -> datetime | None:
    """A moment as year, month, day and time of day are written internationally, with or without a
    difference from UTC; None for anything else.

    >>> parse_moment("2021-07-12 20:01:01 UTC")
    datetime.datetime(2021, 7, 12, 20, 1, 1, tzinfo=datetime.timezone.utc)
    """
    written = _WRITTEN.fullmatch(text)
    if written is None:
        return None
    zone = "+00:00" if written[3] in ("Z", "UTC") else written[3] or ""
    try:
        return datetime.fromisoformat(f"{written[1]}T{written[2]}{zone}")
    except ValueError:
        return None


def write_moment(moment: datetime) -> str:
    """A moment as it is printed; `read_moment` reads it again.

    >>> write_moment(read_moment("2026-12-01T18:00:00+01:00"))
    '2026-12-01 18:00 +01:00'
    """
    seconds = "seconds" if moment.second else "minutes"
    text = moment.replace(microsecond=0, tzinfo=None).isoformat(" ", seconds)
    if moment.tzinfo is None:
        return text
    return f"{text} {moment.isoformat(timespec='seconds')[-6:]}"


def is_past(moment: datetime, now: datetime) -> bool:
    """Whether a moment is over at a moment `now` that has its difference from UTC; a moment without
    one is taken in the time of this machine.
    """
    return moment.astimezone(UTC) < now.astimezone(UTC)
