"""From a download to a table of the shape of EXAM/answers.csv, which grading reads as it reads any other.

Every cell is what was typed; every row that is not taken over is told with all that stands in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.lms.responses.detection import DIALECTS, detected
from kinegrade.lms.responses.exam_asks import read_exam_asks
from kinegrade.lms.responses.other_paper import difference, right_answers
from kinegrade.lms.responses.people import Columns, Found, People
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows, whole
from kinegrade.spreadsheet import is_workbook, read_workbook
from kinegrade.tables import Complaint, Row, Table, read_table

SOURCES = tuple(DIALECTS)


@dataclass(frozen=True, slots=True)
class Responses:
    """The answer sheet made of a download, the name of its source, and in words what was assumed, a line each."""

    table: Table
    source: str
    assumed: tuple[str, ...]


def answer_table(
    path: Path,
    exam_folder: Path,
    source: str | None = None,
    attempts: Attempts = "finished",
    encoding: str | None = None,
) -> Table:
    """The answer sheet of `read_responses`, with the same errors."""
    return read_responses(path, exam_folder, source, attempts, encoding).table


def read_responses(
    path: Path,
    exam_folder: Path,
    source: str | None = None,
    attempts: Attempts = "finished",
    encoding: str | None = None,
) -> Responses:
    """Reads a CSV file or workbook that was downloaded from `source`, one of SOURCES; detected where None.

    Of a student's several attempts each is a row, in the order of time; `attempts` says whether unfinished ones are
    taken over too. `encoding` is what a CSV file is read in if it is not UTF-8. Raises TableError, ExamError.
    """
    asks = read_exam_asks(exam_folder)
    table = read_workbook(path) if is_workbook(path) else read_table(path, encoding)
    name = detected(table) if source is None else _known(source, path)
    typed = DIALECTS[name].read(table, asks, attempts)
    people = People(asks.students)
    columns = people.columns([each.row for each in typed.rows], typed.people, typed.named)
    if not columns.indices and typed.rows:
        raise TableError(
            f"{table.file}: no column tells whose answers these are - expected the ids or the e-mail "
            "addresses of the exam's students - download the file with them"
        )
    found = _own_papers(
        typed, [people.find(each.row, table.header, columns) for each in typed.rows], exam_folder
    )
    complaints = [
        *_about_answers(table, typed, columns),
        *typed.complaints,
        *_unknown(table, found),
    ]
    sheet = Table(
        table.file,
        ("student", *typed.columns),
        tuple(_rows(found)),
        table.encoding,
        table.separator,
        tuple(complaints),
    )
    return Responses(sheet, name, tuple(_assumed(table, name, source, typed, columns)))


def _known(source: str, path: Path) -> str:
    if source not in DIALECTS:
        raise TableError(
            f'{path.name}: "{source}" is no system known here - expected one of {", ".join(DIALECTS)} '
            "- name one of them, or none"
        )
    return source


def _about_answers(table: Table, typed: TypedRows, columns: Columns) -> Iterator[Complaint]:
    """The table's complaints without those about cells that are not read, such as times of completion."""
    read = {table.header[place] for place in {*typed.sources, *columns.indices}}
    return (each for each in table.complaints if not each.column or each.column in read)


def _own_papers(
    typed: TypedRows, found: Sequence[Found], folder: Path
) -> list[tuple[TypedRow, Found]]:
    """Each row with its student, or with none where other questions were put than those of the student's paper."""
    keys = right_answers(folder) if any(each.right for each in typed.rows) else {}
    checked = []
    for each, who in zip(typed.rows, found, strict=True):
        other = difference(typed.columns, each.right, keys.get(who.student or "", {}))
        problem = f'student "{who.student}" was put another paper: {other}'
        checked.append((each, Found(None, "", problem) if other else who))
    return checked


def _rows(found: Sequence[tuple[TypedRow, Found]]) -> Iterator[Row]:
    """The rows of the students that were found, in the order of time."""
    timed = all(each.moment for each, _ in found)
    for each, who in sorted(found, key=lambda pair: pair[0].moment) if timed else found:
        if who.student is not None:
            yield Row(each.row.line, (who.student, *each.responses))


def _unknown(table: Table, found: Sequence[tuple[TypedRow, Found]]) -> Iterator[Complaint]:
    for each, who in found:
        if who.student is None:
            yield Complaint(
                table.file,
                each.row.line,
                who.column,
                whole(each.row),
                who.problem,
                f"not graded{who.hint}",
            )


def _assumed(
    table: Table, name: str, source: str | None, typed: TypedRows, columns: Columns
) -> Iterator[str]:
    if source is None and name != "sheet":
        yield f"{table.file}: taken for {DIALECTS[name].title}"
    if table.encoding not in ("UTF-8", "XLSX"):
        yield f"{table.file}: read as {table.encoding}"
    if name != "sheet":
        yield f"{table.file}: students are told by {' and '.join(_titles(table, columns))}"
    if typed.assumed:
        yield f"{table.file}: {typed.assumed}"


def _titles(table: Table, columns: Columns) -> list[str]:
    return [f'"{" ".join(table.header[place].split())}"' for place in columns.indices] or [
        "nothing"
    ]
