"""The ids of a roster as they were before a spreadsheet changed them; where that is not certain,
they are refused.

Zeros and case are kept. What only keeps spreadsheets from dropping zeros (="007", a # or ' before
all ids) is taken away, and so is the fraction of ids in a column that became one of numbers (12.0).
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kinegrade.errors import Problem
from kinegrade.exam.roster.student_ids import find_zero_twins
from kinegrade.exam.roster.students import make_student_key
from kinegrade.files.cell_text import drop_invisible, shorten, trim
from kinegrade.files.tables import Complaint, Table
from kinegrade.language.message import Fault, Message, Quoted, list_all

_FORMULA_SIGNS = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")  # full-width ones too
_TEXT_FORMULA = re.compile(r'=\s*"([^"]*)"')
_GUARDS = ("#", "'")
_FRACTION = re.compile(r"([0-9]+)[.,]0+")
_SHORTENED = re.compile(r"[0-9](?:[.,][0-9]+)?E\+[0-9]+", re.IGNORECASE)
_DATE = re.compile(r"[0-9]{4}([-/.])[0-9]{1,2}\1[0-9]{1,2}|[0-9]{1,2}([-/.])[0-9]{1,2}\2[0-9]{4}")
_LOST = ("files.cell-digits", "files.cell-date")  # remarks on cells that no longer hold the id
_KEPT_DIGITS = 15  # of a number, in a spreadsheet
_LEAST_ZEROS = 3  # behind those, in all ids together, come in one class of a thousand by chance
_MOST_ALIKE = 4  # in five ids, at least, that are equally long digits make shorter ones strange
_MOST_WITH_DIGITS = 9  # in ten ids, at least, that have digits make those without strange


@dataclass(frozen=True, slots=True)
class Identity:
    """The id on a line, and whose it is."""

    line: int
    student: str
    name: str


def mend_ids(ids: Sequence[str]) -> tuple[Sequence[str], Sequence[Message]]:
    """The ids, and what was taken away from them.

    >>> mend_ids(["12.0", "7.0"])[0], mend_ids(['="007"', "12"])[0], mend_ids(["#007", "#12"])[0]
    (['12', '7'], ['007', '12'], ['007', '12'])
    >>> mend_ids(["00\\u200b12"])[0]
    ['0012']
    """
    remarks: list[Message] = []
    seen = [*map(drop_invisible, ids)]
    unseen = [each for each, rest in zip(ids, seen, strict=True) if each != rest]
    if unseen:
        cell = Quoted(unseen[0])
        remarks.append(Message("roster.unseen-taken-away", count=len(unseen), cell=cell))
    mended = [found[1] if (found := _TEXT_FORMULA.fullmatch(each)) else each for each in seen]
    for guard in _GUARDS:
        if mended and all(each.startswith(guard) for each in mended if each):
            mended = [each.removeprefix(guard) for each in mended]
            remarks.append(Message("roster.guard-taken-away", sign=guard))
    fractions = [_FRACTION.fullmatch(each) for each in mended]
    count = sum(found is not None for found in fractions)
    if count:
        first = next(each for each, found in zip(mended, fractions, strict=True) if found)
        pairs = zip(mended, fractions, strict=True)
        mended = [found[1] if found else each for each, found in pairs]
        remarks.append(Message("roster.fraction-taken-away", count=count, cell=Quoted(first)))
    return mended, remarks


def find_id_faults(
    table: Table, people: Sequence[Identity], title: str, *, odd_ids: bool
) -> Iterator[Problem]:
    """What is wrong with the ids of a roster, each below the column `title`."""
    lost = {each.line for each in table.complaints if each.column == title and _is_lost(each)}
    yield from _find_empty(table, people)
    yield from _find_repeated(table, people)
    if not odd_ids:
        yield from _find_formulas(table, people)
        yield from _find_dates(table, people)
        yield from _find_twins(table, people)
        yield from _find_rounded(table, people)
    for each in people:
        if each.line in lost or _SHORTENED.fullmatch(each.student):
            what = Message("roster.lost-digits", student=Quoted(shorten(each.student)))
            yield Fault(f"{table.file}:{each.line}", what)


def _is_lost(complaint: Complaint) -> bool:
    """Whether a spreadsheet has put something else into the cell."""
    return isinstance(complaint.problem, Message) and complaint.problem.key in _LOST


def find_short_ids(table: Table, people: Sequence[Identity]) -> Iterator[Complaint]:
    """A complaint where a few ids have fewer digits than nearly all others, which a spreadsheet may
    have made of them.
    """
    digits = [each for each in people if each.student.isascii() and each.student.isdigit()]
    lengths = Counter(len(each.student) for each in digits)
    usual, alike = max(lengths.items(), key=lambda item: item[1], default=(0, 0))
    short = [each for each in digits if len(each.student) < usual]
    if short and alike * 5 >= _MOST_ALIKE * len(people):
        problem = Message(
            "roster.short-ids",
            count=len(short),
            student=Quoted(short[0].student),
            line=short[0].line,
            digits=usual,
        )
        yield Complaint(table.file, None, "", "", problem, Message("roster.short-ids-done"))


def find_ids_without_digits(table: Table, people: Sequence[Identity]) -> Iterator[Complaint]:
    """A complaint for each id that has no digit where nearly all others have: perhaps it heads a
    line of totals.
    """
    without = [each for each in people if not any(map(str.isdigit, each.student))]
    if 10 * (len(people) - len(without)) < _MOST_WITH_DIGITS * len(people):
        return
    for each in without:
        problem = Message("roster.no-digit", student=Quoted(each.student), line=each.line)
        yield Complaint(table.file, None, "", "", problem, Message("roster.no-digit-done"))


def _find_empty(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    for each in people:
        if not trim(each.student):
            name = Quoted(shorten(each.name))
            yield Fault(f"{table.file}:{each.line}", Message("roster.no-id", name=name))


def _find_repeated(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    lines: dict[str, list[int]] = defaultdict(list)
    for each in people:
        lines[make_student_key(each.student)].append(each.line)
    for student, places in lines.items():
        if student and len(places) > 1:
            shown = Quoted(shorten(student))
            what = Message("roster.repeated-id", student=shown, lines=list_all(places))
            yield Fault(table.file, what)


def _find_twins(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    lines = {make_student_key(each.student): each.line for each in people}
    for twins in find_zero_twins(lines):
        students = list_all(map(Quoted, twins))
        places = list_all([lines[each] for each in twins])
        what = Message("roster.zero-twins", students=students, lines=places)
        yield Fault(table.file, what, do=Message("roster.one-person"))


def _find_rounded(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    """Long ids that all end as if a spreadsheet had kept fifteen digits of each."""
    ends = {each: each.student[_KEPT_DIGITS:] for each in people if each.student.isdigit()}
    zeros = "".join(ends.values())
    if len(zeros) < _LEAST_ZEROS or zeros.strip("0"):
        return
    for each in filter(ends.get, ends):
        what = Message("roster.rounded-id", student=Quoted(each.student))
        yield Fault(f"{table.file}:{each.line}", what)


def _find_formulas(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    for each in people:
        if each.student.startswith(_FORMULA_SIGNS):
            what = Message(
                "roster.formula-id",
                student=Quoted(shorten(each.student)),
                name=shorten(each.name),
                sign=each.student[0],
            )
            yield Fault(f"{table.file}:{each.line}", what)


def _find_dates(table: Table, people: Sequence[Identity]) -> Iterator[Fault]:
    for each in people:
        if _DATE.fullmatch(each.student):
            what = Message("roster.date-id", student=Quoted(each.student), name=shorten(each.name))
            yield Fault(f"{table.file}:{each.line}", what)
