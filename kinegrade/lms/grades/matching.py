"""Whose row is whose in a downloaded file: by id, login or e-mail as the system compares them,
never by name.

No student is guessed. A value that is only probably the same (zeros or digits lost in a
spreadsheet, full-width forms, upper and lower case) is suggested in a complaint, and the instructor
decides.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass

from kinegrade.files.cell_text import trim
from kinegrade.files.tables import Complaint
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import (
    Listing,
    Message,
    Quoted,
    list_all,
    list_choices,
    list_statements,
)
from kinegrade.lms.grades.cells import CellTable, Record
from kinegrade.lms.grades.grades import StudentGrade
from kinegrade.lms.grades.key_column import KeyColumn
from kinegrade.lms.grades.lost_zeros import find_lost_zeros
from kinegrade.lms.grades.probable_rows import ProbableRows, folded

_MOST_HINTS = 3


@dataclass(frozen=True)
class Matching:
    """The student of each row that has one, by the row's line, and what the instructor has to
    check.
    """

    students: Mapping[int, StudentGrade]
    complaints: tuple[Complaint, ...]


def match(
    table: CellTable,
    rows: Sequence[Record],
    columns: Sequence[KeyColumn],
    students: Sequence[StudentGrade],
    graded: Iterable[str],
    *,
    test_person: re.Pattern[str] | None = None,
) -> Matching:
    """Matches students with the rows of a file; a missing row is reported for `graded` students
    only.

    A row that no student matches is skipped where it is a `test_person`'s.
    """
    claims = _collect_claims(rows, columns, students)
    claimants = _collect_claimants(claims, students)
    unclear = {line for line, several in claimants.items() if len(several) > 1}
    sure = {
        line: first
        for line, (first, *_) in claimants.items()
        if line not in unclear and len(claims[first.student]) == 1
    }
    unclaimed = [row for row in rows if row.line not in claimants]
    free = [row for row in unclaimed if not _is_test_person(row, test_person)]
    missing = [each for each in students if not claims[each.student]]
    complaints = [
        *(
            _complain_of_ambiguous(table, columns, each, claims[each.student])
            for each in students
            if len(claims[each.student]) > 1
        ),
        *(_complain_of_contested(table, line, claimants[line]) for line in sorted(unclear)),
        *_complain_of_unmatched(table, columns, missing, set(graded), free),
    ]
    return Matching(sure, tuple(complaints))


def _find_strange_ids(
    rows: Sequence[Record], columns: Sequence[KeyColumn], students: Sequence[StudentGrade]
) -> set[int]:
    """The lines of rows with an id that nobody has, not even but for zeros: they are nobody's,
    whatever else they say. A column that does not hold ids of the class above all says nothing.
    """
    lines: set[int] = set()
    for column in (each for each in columns if each.key.field == "id"):
        known = {folded(column.wanted(each)) for each in students}
        held = {row.line: text for row in rows if (text := folded(column.value(row)))}
        strange = {line for line, text in held.items() if text not in known}
        lines |= strange if 2 * len(strange) < len(held) else set()
    return lines


def _collect_claimants(
    claims: Mapping[str, tuple[int, ...]], students: Sequence[StudentGrade]
) -> Mapping[int, list[StudentGrade]]:
    """The students who match each row, by its line."""
    claimants: dict[int, list[StudentGrade]] = defaultdict(list)
    for grade in students:
        for line in claims[grade.student]:
            claimants[line].append(grade)
    return claimants


def _is_test_person(row: Record, shape: re.Pattern[str] | None) -> bool:
    return bool(shape and shape.match(", ".join(trim(cell.text) for cell in row.cells)))


def _collect_claims(
    rows: Sequence[Record], columns: Sequence[KeyColumn], students: Sequence[StudentGrade]
) -> Mapping[str, tuple[int, ...]]:
    """The lines of the rows that match each student, by any of the keys."""
    strange = _find_strange_ids(rows, columns, students)
    lines: list[dict[str, list[int]]] = []
    for column in columns:
        found: dict[str, list[int]] = defaultdict(list)
        for row in rows:
            if row.line not in strange:
                found[column.value(row)].append(row.line)
        lines.append(found)
    claims = {}
    for grade in students:
        matched = {
            line
            for column, found in zip(columns, lines, strict=True)
            if column.wanted(grade)
            for line in found.get(column.wanted(grade), ())
        }
        claims[grade.student] = tuple(sorted(matched))
    return claims


def _complain_of_ambiguous(
    table: CellTable, columns: Sequence[KeyColumn], grade: StudentGrade, lines: Sequence[int]
) -> Complaint:
    problem = Message(
        "grades.ambiguous",
        student=Quoted(grade.student),
        lines=list_all(lines),
        keys=_write_names(table, columns),
    )
    done = Message("grades.lines-unchanged")
    return Complaint(table.file, lines[0], "", grade.student, problem, done)


def _complain_of_contested(
    table: CellTable, line: int, students: Sequence[StudentGrade]
) -> Complaint:
    who = list_all(Quoted(each.student) for each in students)
    return Complaint(
        table.file,
        line,
        "",
        "",
        Message("grades.contested", students=who),
        Message("grades.line-unchanged"),
    )


def _complain_of_unmatched(
    table: CellTable,
    columns: Sequence[KeyColumn],
    missing: Sequence[StudentGrade],
    graded: Set[str],
    free: Sequence[Record],
) -> Iterator[Complaint]:
    """The `graded` students without a row, and the rows without a student; once where both come
    from zeros that were lost.
    """
    lost = find_lost_zeros(table, columns, missing, free)
    rows = [row for row in free if row.line not in lost.students]
    wanted = graded - set(lost.students.values())
    alike = [ProbableRows(table, column, rows) for column in columns]
    for each in missing:
        if each.student in wanted:
            yield _complain_of_missing(table, columns, each, alike)
    yield from lost.complaints
    yield from _list_strangers(table, columns, rows)


def _complain_of_missing(
    table: CellTable,
    columns: Sequence[KeyColumn],
    grade: StudentGrade,
    alike: Sequence[ProbableRows],
) -> Complaint:
    problem = Message(
        "grades.no-row", student=Quoted(grade.student), keys=_write_names(table, columns)
    )
    hints = [hint for each in alike for hint in each.hints(grade)][:_MOST_HINTS]
    done = Message("grades.not-exported")
    if hints:
        done = Message("grades.not-exported-but", hints=list_statements(hints))
    return Complaint(table.file, None, "", grade.student, problem, done)


def _list_strangers(
    table: CellTable, columns: Sequence[KeyColumn], free: Sequence[Record]
) -> Iterator[Complaint]:
    for row in free:
        shown = ", ".join(
            f'{table.titles[place]} "{show_in_one_line(trim(row.cells[place].text)[:60])}"'
            for place in sorted({column.place for column in columns})
        )
        yield Complaint(
            table.file,
            row.line,
            "",
            shown,
            Message("grades.stranger", shown=shown),
            Message("grades.line-unchanged"),
        )


def _write_names(table: CellTable, columns: Sequence[KeyColumn]) -> Listing:
    """The titles of the key columns."""
    return list_choices(
        table.titles[place] for place in sorted({column.place for column in columns})
    )
