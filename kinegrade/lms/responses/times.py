"""When something was handed in, as systems write it: read only where it is certain which day and
which hour is meant.

A date of three numbers is certain where the year comes first, or where one of its column with the
same separator can be read in one order alone and no other in the other alone; one with the name of
a month, in any language of the catalogues, always.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import cache

from kinegrade.deadlines.moment import parse_moment, write_moment
from kinegrade.deadlines.numbered_dates import (
    CLOCK,
    HALF,
    ORDERS,
    ZONE,
    make_moment,
    read_in_order,
)
from kinegrade.files.cell_text import trim
from kinegrade.language.message import Message
from kinegrade.language.spellings import match_spellings

_YEAR_FIRST = re.compile(
    r"(?P<year>[0-9]{4})(?:[-/.]|年) ?(?P<month>[0-9]{1,2})(?:[-/.]|月) ?(?P<day>[0-9]{1,2})日?"
    rf"[,， ]*(?:(?:星期|周).)?[,， ]*{CLOCK}{HALF}{ZONE}"
)
_SEPARATORS = "./-"
_MONTHS_A_YEAR = 12
_MONTHS = (
    Message("responses.month-1"),
    Message("responses.month-2"),
    Message("responses.month-3"),
    Message("responses.month-4"),
    Message("responses.month-5"),
    Message("responses.month-6"),
    Message("responses.month-7"),
    Message("responses.month-8"),
    Message("responses.month-9"),
    Message("responses.month-10"),
    Message("responses.month-11"),
    Message("responses.month-12"),
)


def read_time(cell: str) -> str:
    """A time as `kinegrade.deadlines.moment` reads it; where it is not certain, as it stands.

    >>> read_time("Sunday, 27 September 2026, 3:04 PM"), read_time("10/4/2026 10:15:00")
    ('2026-09-27 15:04', '10/4/2026 10:15:00')
    """
    text = " ".join(trim(cell).split())
    moment = parse_moment(text) or _read_written(text)
    return text if moment is None else write_moment(moment)


@dataclass(frozen=True, slots=True)
class DecidedOrder:
    """That the time at a `place` of a column can be read in one order alone, by which all others
    with its separator are read.
    """

    place: int
    time: str
    day_first: bool


def read_times(cells: Iterable[str]) -> tuple[list[str], tuple[DecidedOrder, ...]]:
    """The times of one column, and what decided on their order: where the first or the second
    number of one is no month, it says for all with its separator which number is the day.

    >>> read_times(["20.10.2026 18:10", "1.12.2026 9:05"])[0], read_times(["1.12.2026 9:05"])[0]
    (['2026-10-20 18:10', '2026-12-01 09:05'], ['1.12.2026 9:05'])
    """
    texts = [read_time(cell) for cell in cells]
    decided = tuple(order for mark in _SEPARATORS for order in _decide(texts, mark))
    for order in decided:
        mark = _find_separator(order.time)
        texts = [
            _write_in_order(text, order) if _find_separator(text) == mark else text
            for text in texts
        ]
    return texts, decided


def _decide(texts: Sequence[str], mark: str) -> Iterator[DecidedOrder]:
    """The first time with this separator that can be read in one order alone, unless another can be
    read in the other alone.
    """
    told = [
        DecidedOrder(place, text, day_first)
        for place, text in enumerate(texts)
        for day_first, order in ORDERS.items()
        if _find_separator(text) == mark
        and (found := order.fullmatch(text))
        and int(found["day"]) > _MONTHS_A_YEAR
    ]
    if len({each.day_first for each in told}) == 1:
        yield told[0]


def _find_separator(text: str) -> str:
    """What stands between the numbers of a date, "" where it is none of two of them first."""
    found = ORDERS[True].fullmatch(text)
    return "" if found is None else text[found.end("day")]


def _write_in_order(text: str, decided: DecidedOrder) -> str:
    moment = read_in_order(text, day_first=decided.day_first)
    return text if moment is None else write_moment(moment)


def _read_written(text: str) -> datetime | None:
    found = _YEAR_FIRST.fullmatch(text)
    if found is not None:
        return make_moment(found, int(found["month"]))
    for number, pattern in enumerate(_match_months(), 1):
        found = pattern.fullmatch(text)
        if found is not None:
            return make_moment(found, number)
    return None


@cache
def _match_months() -> Sequence[re.Pattern[str]]:
    """For each month what a date with its name looks like: "27 September 2026, 3:04 PM"."""
    return tuple(
        re.compile(
            rf"(?:\w+, )?(?P<day>[0-9]{{1,2}})\.? {match_spellings(each)}\.? "
            rf"(?P<year>[0-9]{{4}}),? {CLOCK}{HALF}{ZONE}",
            re.IGNORECASE,
        )
        for each in _MONTHS
    )
