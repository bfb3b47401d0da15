"""One answer sheet from one file or several: versions' quizzes, or parts of the exam typed by
different assistants.

`class_sheet` is called by `grade`. Cells of one student in different files are merged. Where two
files give different answers for one cell, the first file counts and a complaint names both.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce

from kinegrade.exam.folder.keys import Ask, Sitting
from kinegrade.files.answer_file import AnswerFile, LeftOut
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.tables import Complaint, Table
from kinegrade.grading.sheets.attempts import find_unordered, leave_out_blank, order_attempts
from kinegrade.grading.sheets.entry import Entry, OtherTime, Place
from kinegrade.grading.sheets.grid_entries import GridEntries
from kinegrade.grading.sheets.part import read_part
from kinegrade.grading.sheets.sheet import Part, Sheet
from kinegrade.grading.typed.same_answer import are_same
from kinegrade.language.message import Message, Quoted

_Entries = Mapping[str, tuple[Entry, ...]]


def read_sheet(table: Table, exam: Sitting) -> Sheet:
    """The sheet of a single file; raises TableError as `class_sheet` does."""
    return class_sheet([AnswerFile(table)], exam)


def class_sheet(files: Sequence[AnswerFile], exam: Sitting) -> Sheet:
    """Finds every student's responses in these files, which together are one class.

    Raises TableError if a file has no student column, no answer column, or is the sheet of another
    exam.
    """
    parts = [read_part(answers, exam) for answers in files]
    names = ", ".join(part.file for part in parts)
    columns = tuple(
        next((part.columns[number] for part in parts if part.columns[number]), "")
        for number in range(len(exam.asks))
    )
    entries, conflicts = _join(parts, exam.asks)
    left_out = [each for answers in files for each in answers.left_out]
    unordered = () if isinstance(entries, GridEntries) else find_unordered(entries)
    complaints = [
        *(complaint for part in parts for complaint in part.complaints),
        *_find_missing_columns(names, columns, exam),
        *conflicts,
        *unordered,
        *_find_left_out(left_out, entries),
        *_find_missing_students(names, exam, entries, {each.student for each in left_out}),
    ]
    return Sheet(
        tuple(name or ask.column for name, ask in zip(columns, exam.asks, strict=True)),
        _arrange(entries, exam, names),
        tuple(complaints),
    )


def _arrange(entries: _Entries, exam: Sitting, names: str) -> _Entries:
    """Those of all examinees, empty ones of those who have none."""
    if isinstance(entries, GridEntries):
        return entries.of(exam.students)
    nothing = (Entry(None, ("",) * len(exam.asks), file=names),)
    found = ((student, entries.get(student, nothing)) for student in exam.students)
    return {
        student: order_attempts(leave_out_blank(several)) if len(several) > 1 else several
        for student, several in found
    }


def _join(parts: Sequence[Part], asks: Sequence[Ask]) -> tuple[_Entries, list[Complaint]]:
    if len(parts) == 1:
        return parts[0].entries, []
    found: dict[str, list[tuple[Entry, ...]]] = defaultdict(list)
    for part in parts:
        for student, entries in part.entries.items():
            found[student].append(entries)
    together: dict[str, tuple[Entry, ...]] = {}
    conflicts: list[Complaint] = []
    for student, several in found.items():
        if any(len(entries) > 1 for entries in several):  # several attempts: the policy chooses
            together[student] = _list_attempts(several)
            continue
        first, *others = (entries[0] for entries in several)
        for other in others:
            conflicts += _find_conflicts(student, first, other, parts, asks)
            first = _unite(first, other)
        together[student] = (first,)
    return together, conflicts


def _list_attempts(several: Sequence[tuple[Entry, ...]]) -> tuple[Entry, ...]:
    """A student's attempts from all files, in order.

    Where one file has the attempts for some answers and the other files hold other answers, each
    attempt gets those too.
    """
    repeated_in = [entries for entries in several if len(entries) > 1]
    if len(repeated_in) > 1 or not _answers_differ(several):
        return tuple(entry for entries in several for entry in entries)
    (attempts,) = repeated_in
    others = [entries[0] for entries in several if len(entries) == 1]
    return tuple(reduce(_unite, others, attempt) for attempt in attempts)


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


def _find_missing_columns(names: str, columns: Sequence[str], exam: Sitting) -> Iterator[Complaint]:
    for ask, name in zip(exam.asks, columns, strict=True):
        if not name:
            problem, done = Message("marking.no-column"), Message("marking.column-blank")
            yield Complaint(names, None, ask.column, "", problem, done)


def _find_left_out(left_out: Sequence[LeftOut], entries: _Entries) -> Iterator[Complaint]:
    """Why rows are not marked; for a student without an attempt only once, and only if no other
    file has one.
    """
    absent: set[str] = set()
    for each in left_out:
        if each.attempted:
            yield each.complaint
        elif each.student not in entries and each.student not in absent:
            absent.add(each.student)
            yield each.complaint


def _find_missing_students(
    names: str, exam: Sitting, entries: _Entries, said: set[str]
) -> Iterator[Complaint]:
    there = {*entries}
    for student in exam.students:
        if student not in there and student not in said:
            problem = Message("marking.no-row", student=Quoted(student))
            yield Complaint(names, None, "", student, problem, Message("marking.all-blank"))
