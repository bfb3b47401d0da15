"""Several rows of one student, in the order in which they were handed in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from functools import partial

from kinegrade.deadlines.moment import parse_moment
from kinegrade.deadlines.numbered_dates import read_in_order
from kinegrade.files.cell_text import is_answered, trim
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.entry import Entry
from kinegrade.language.message import Message, Quoted


def order_attempts(several: Sequence[Entry]) -> tuple[Entry, ...]:
    """A student's entries by their times, those of one time as they stand; all as they stand where
    the times of some are not known.
    """
    moments = _read_moments(several)
    if moments is None:
        return tuple(several)
    order = sorted(range(len(several)), key=lambda number: moments[number])
    return tuple(several[number] for number in order)


def leave_out_blank(several: Sequence[Entry]) -> tuple[Entry, ...]:
    """A student's entries without rows that were never filled in, as long as any was: a list of the
    class below the answers is no attempt. One with a time was handed in.
    """
    filled = [each for each in several if each.submitted or any(map(is_answered, each.responses))]
    return tuple(filled or several[:1])


def find_unordered(entries: Mapping[str, tuple[Entry, ...]]) -> Iterator[Complaint]:
    """A complaint for each student of whose entries the times do not say which was first, where any
    has a time.
    """
    for student, several in entries.items():
        timed = len(several) > 1 and any(entry.submitted for entry in several)
        if timed and not _are_ordered(several):
            problem = Message("marking.attempts-unordered", student=Quoted(student))
            done = Message("marking.rows-order")
            first = several[0]
            yield Complaint(first.file, first.line, "", student, problem, done)


def _are_ordered(several: Sequence[Entry]) -> bool:
    """Whether times say which entry was first; two of one time may have the same answers."""
    moments = _read_moments(several)
    if moments is None:
        return False
    at: dict[datetime, list[str]] = {}
    for entry, moment in zip(several, moments, strict=True):
        answers = list(map(trim, entry.responses))
        if at.setdefault(moment, answers) != answers:
            return False
    return True


def _read_moments(several: Sequence[Entry]) -> list[datetime] | None:
    """The times of entries, None where they cannot all be compared. Where it is not certain which
    number of a date is the day, they are read with it first, if they have the same order with the
    month first.
    """
    read = partial(_read_in_order, [entry.submitted for entry in several])
    moments, otherwise = read(day_first=True), read(day_first=False)
    if moments is None or otherwise is None or _rank(moments) != _rank(otherwise):
        return None
    return moments


def _read_in_order(times: Sequence[str], *, day_first: bool) -> list[datetime] | None:
    moments = [parse_moment(each) or read_in_order(each, day_first=day_first) for each in times]
    known = [moment for moment in moments if moment is not None]
    zoned = {moment.tzinfo is None for moment in known}
    return None if len(known) < len(times) or len(zoned) > 1 else known


def _rank(moments: Sequence[datetime]) -> list[int]:
    """The place of each among them, that of those of one time the same."""
    order = sorted({*moments})
    return [*map(order.index, moments)]
