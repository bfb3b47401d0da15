"""The answer sheet of an exam to which students are added: what was typed into it stays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.contents import ANSWERS
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.exam.generating.exam_files import write_blank_answers
from kinegrade.exam.generating.hand_work import OWN_COLUMNS
from kinegrade.exam.roster.students import make_student_key
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.csv_writing import neutralise, write_for_people
from kinegrade.files.tables import Table, read_table
from kinegrade.language.message import Fault, Message, Quoted


def write_grown_answers(
    old: Path, head: ExamHead, folder: Path, passed_on: Mapping[Candidate, Candidate]
) -> None:
    """Write the answer sheet of the exam folder `old` into another one, with a blank row for each
    student of `head` who has none; a blank sheet where there is none. The rows of those who are
    `passed_on` are those of others now, with what was typed into them.

    Raises TableError where it cannot be read any more.
    """
    sheet = old / ANSWERS
    if not sheet.exists():
        write_blank_answers(head, folder)
        return
    table = read_table(sheet)
    columns = [make_header_key(name) for name in table.header]
    if OWN_COLUMNS[0] not in columns:
        raise TableError(
            Fault(str(sheet), Message("exam.no-answer-column", column=Quoted(OWN_COLUMNS[0])))
        )
    rows = list(_pass_on(table, columns, passed_on))
    blank = (_blank(columns, each) for each in _lacking(rows, columns, head))
    write_for_people(folder / ANSWERS, table.header, (*rows, *blank))


def _pass_on(
    table: Table, columns: list[str], passed_on: Mapping[Candidate, Candidate]
) -> Iterator[Sequence[str]]:
    """The rows of the sheet, each with the id and the name of whose it is now."""
    place = columns.index(OWN_COLUMNS[0])
    now = {make_student_key(each.student): after for each, after in passed_on.items()}
    for row in table.rows:
        after = now.get(make_student_key(row.cell(place)))
        if after is None:
            yield row.cells
            continue
        own = dict(zip(OWN_COLUMNS, (after.student, neutralise(after.name)), strict=True))
        yield [own.get(column, cell) for column, cell in zip(columns, row.cells, strict=True)]


def _lacking(rows: Sequence[Sequence[str]], columns: list[str], head: ExamHead) -> list[Candidate]:
    """The students who have no row."""
    place = columns.index(OWN_COLUMNS[0])
    listed = {make_student_key(row[place]) for row in rows}
    return [each for each in head.students if make_student_key(each.student) not in listed]


def _blank(columns: list[str], candidate: Candidate) -> list[str]:
    """A row in which nothing is typed yet."""
    own = dict(zip(OWN_COLUMNS, (candidate.student, neutralise(candidate.name)), strict=True))
    return [own.get(column, "") for column in columns]
