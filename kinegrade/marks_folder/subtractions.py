"""subtracted.csv: what being late and trying again cost, written, read again, and in words."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import timedelta
from fractions import Fraction
from pathlib import Path

from kinegrade.deadlines.duration import write_duration
from kinegrade.deadlines.moment import parse_moment, write_moment
from kinegrade.errors import TableError
from kinegrade.files.csv_writing import neutralise, restore
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Listing, Message, list_statements
from kinegrade.marks_folder.cells import Record, explain_cell, read_amount, read_records_if_any
from kinegrade.marks_folder.layout import SUBTRACTED
from kinegrade.marks_folder.rows import Submission, Subtracted
from kinegrade.numbers.amounts import write_amount

_FULL = 100


def describe_subtracted(subtracted: Subtracted) -> Listing:
    """Why points were subtracted."""
    said: list[Message] = []
    submission = subtracted.submission
    if submission.late_by:
        time, share = write_duration(submission.late_by), _write_share(subtracted.late_share)
        said.append(Message("marks.handed-in-late", time=time, share=share))
    if submission.before:
        share = _write_share(subtracted.tries_share)
        said.append(Message("marks.tried-before", count=submission.before, share=share))
    return list_statements(said)


def write_subtracted(subtracted: Subtracted, words: Catalogue) -> tuple[str, ...]:
    """A line of the file."""
    submission = subtracted.submission
    moments = submission.submitted, submission.due
    return (
        subtracted.student,
        neutralise(subtracted.name),
        *("" if each is None else write_moment(each) for each in moments),
        write_duration(submission.late_by),
        _write_share(subtracted.late_share),
        str(submission.before),
        _write_share(subtracted.tries_share),
        write_amount(subtracted.points),
        neutralise(words.write(describe_subtracted(subtracted))),
    )


def read_subtracted(folder: Path) -> Mapping[str, Subtracted]:
    """What was subtracted, by student; nothing where there is no such file. Raises TableError."""
    path = folder / SUBTRACTED.name
    records = read_records_if_any(folder, SUBTRACTED)
    return {cells[0]: _read_line(cells, path, line) for line, cells in records}


def _read_line(cells: Record, path: Path, line: int) -> Subtracted:
    student, name, submitted, due, late_by, late, before, tries, points, _ = cells
    hours, _, minutes = late_by.partition(":")
    if not (hours.isdecimal() and minutes.isdecimal() and before.isdecimal()):
        expected = Message("marks.hours-and-minutes")
        raise TableError(explain_cell(path, line, "late_by", late_by, expected))
    lateness = timedelta(hours=int(hours), minutes=int(minutes))
    submission = Submission(parse_moment(submitted), parse_moment(due), lateness, int(before))
    return Subtracted(
        student,
        restore(name),
        submission,
        read_amount(points, path, line, "points"),
        read_amount(late, path, line, "late_percent") / _FULL,
        read_amount(tries, path, line, "tries_percent") / _FULL,
    )


def _write_share(share: Fraction) -> str:
    return write_amount(_FULL * share)
