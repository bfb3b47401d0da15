"""The rows of a class from several files: cells of one student in different files are merged.

Where two files give different answers for one cell, the first file counts and a complaint names
both. Several rows of one student in one file are attempts, of which the policy chooses.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from itertools import chain

from kinegrade.exam.folder.asks import Ask
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.attempts import leave_out_blank
from kinegrade.grading.sheets.entry import Entry, OtherTime, Place
from kinegrade.grading.sheets.sheet import Part
from kinegrade.grading.typed.same_answer import are_same
from kinegrade.language.message import Message, Quoted

Entries = Mapping[str, tuple[Entry, ...]]  # by student


def join_parts(parts: Sequence[Part], asks: Sequence[Ask]) -> tuple[Entries, list[Complaint]]:
    """The rows of every student in these files, and a complaint for each answer that does not count
    as an earlier file has another.
    """
    if len(parts) == 1:
        return parts[0].entries, []
    found: dict[str, list[tuple[Entry, ...]]] = defaultdict(list)
    for part in parts:
        for student, entries in part.entries.items():
            found[student].append(entries)
    together: dict[str, tuple[Entry, ...]] = {}
    conflicts: list[Complaint] = []
    for student, several in found.items():
        rows = [leave_out_blank(each) if len(each) > 1 else each for each in several]
        if _are_all_attempts(rows):
            together[student] = tuple(chain.from_iterable(rows))
            continue
        alternatives = [_put_among(rows, attempt) for attempt in _list_attempts(rows)]
        together[student] = tuple(_unite_all(*each) for each in alternatives)
        told: dict[tuple[Place, str], Complaint] = {}
        for cells, _ in reversed(alternatives):  # of the earlier attempts what the last has not
            for each in _find_all_conflicts(student, cells, parts, asks):
                told.setdefault((Place(each.file, each.line), each.column), each)
        conflicts += told.values()
    return together, conflicts


def _are_all_attempts(several: Sequence[tuple[Entry, ...]]) -> bool:
    """Whether the rows of all files are attempts, of which the policy chooses: where a student has
    several in two of the files, or their times tell which of the same answers came last.
    """
    repeated = sum(len(entries) > 1 for entries in several)
    timed = all(entry.submitted for entries in several for entry in entries)
    return repeated > 1 or (repeated == 1 and timed and not _answers_differ(several))


def _list_attempts(several: Sequence[tuple[Entry, ...]]) -> tuple[Entry, ...]:
    """The rows of the one file that has several, else the first one."""
    return next((entries for entries in several if len(entries) > 1), several[0])


def _put_among(
    several: Sequence[tuple[Entry, ...]], attempt: Entry
) -> tuple[Sequence[Entry], Entry]:
    """An attempt among the only rows of the other files, in the order of the files; and again."""
    return [attempt if attempt in entries else entries[0] for entries in several], attempt


def _unite_all(entries: Sequence[Entry], attempt: Entry) -> Entry:
    """The cells of all files, the first ones where several have something, as a row of one."""
    united, when = reduce(_unite, entries), attempt.submitted
    whole = united._replace(line=attempt.line, whole=attempt.whole, file=attempt.file)
    return whole._replace(submitted=when) if when else whole


def _find_all_conflicts(
    student: str, entries: Sequence[Entry], parts: Sequence[Part], asks: Sequence[Ask]
) -> Iterator[Complaint]:
    """The answers that do not count as an earlier file has another."""
    first, *others = entries
    for other in others:
        yield from _find_conflicts(student, first, other, parts, asks)
        first = _unite(first, other)


def _answers_differ(several: Sequence[tuple[Entry, ...]]) -> bool:
    """Whether no answer is given in two of the files."""
    seen: set[int] = set()
    for entries in several:
        here = {
            number
            for entry in entries
            for number, cell in enumerate(entry.responses)
            if is_answered(cell)
        }
        if seen & here:
            return False
        seen |= here
    return True


def _unite(first: Entry, other: Entry) -> Entry:
    """The cells of both entries; where both have something, the first counts."""
    chosen = [
        first if is_answered(mine) or not is_answered(others) else other
        for mine, others in zip(first.responses, other.responses, strict=True)
    ]
    numbers = range(len(chosen))
    put = [entry.put[number] if entry.put else "" for number, entry in enumerate(chosen)]
    return Entry(
        first.line,
        tuple(chosen[number].responses[number] for number in numbers),
        first.whole,
        first.file,
        tuple(put) if any(put) else (),
        tuple(chosen[number].place(number) for number in numbers),
        first.submitted or other.submitted,
        (*first.other_times, *_find_other_time(first, other)),
    )


def _find_other_time(first: Entry, other: Entry) -> Iterator[OtherTime]:
    """The time of the other entry where it is not that of the first."""
    if first.submitted and other.submitted and first.submitted != other.submitted:
        yield OtherTime(Place(other.file, other.line), other.submitted)


def _find_conflicts(
    student: str, first: Entry, other: Entry, parts: Sequence[Part], asks: Sequence[Ask]
) -> Iterator[Complaint]:
    columns = {part.file: part.columns for part in parts}
    for number, (mine, others) in enumerate(zip(first.responses, other.responses, strict=True)):
        if not is_answered(mine) or not is_answered(others):
            continue
        if are_same(mine, others, asks[number].unit):
            continue
        place, there = first.place(number), other.place(number)
        problem = Message(
            "marking.conflict",
            student=Quoted(student),
            here=Quoted(shorten(trim(others))),
            there=Quoted(shorten(trim(mine))),
            place=_show(place),
        )
        done = Message("marking.first-counts", file=place.file)
        column = columns[there.file][number]
        yield Complaint(there.file, there.line, column, shorten(others), problem, done)


def _show(place: Place) -> str:
    return place.file if place.line is None else f"{place.file}:{place.line}"
