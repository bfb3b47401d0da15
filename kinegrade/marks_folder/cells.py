"""The cells of a marks folder's files, read as they are written: record by record, as whole tables,
and as amounts. Whatever cannot be read is refused in the same way.
"""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache
from operator import itemgetter
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.tables import Table, parse_table
from kinegrade.language.message import Fault, Message, Quoted, Text, list_plainly
from kinegrade.marks_folder.layout import TableFile
from kinegrade.numbers.written import NumberError, read_number

AS_WRITTEN = Message("marks.as-written")
_GRADE_AGAIN = Message("marks.grade-again")
Record = tuple[str, ...]
_AMOUNT = re.compile(r"[0-9]{1,20}(?:\.[0-9]{1,20})?")
_PLAIN = re.compile(r"-?[0-9]{1,40}(?:\.[0-9]{1,40})?")
_LONGEST_SHOWN = 40


def explain_edited(where: Path | Text, problem: Text) -> Fault:
    """What is wrong with a file that was edited so that it can no longer be read."""
    place = str(where) if isinstance(where, Path) else where
    return Fault(place, problem, AS_WRITTEN, _GRADE_AGAIN)


def explain_cell(path: Path, line: int, column: str, cell: str, expected: Message) -> Fault:
    """What is wrong with one cell."""
    what = Message("marks.cell", column=column, cell=Quoted(cell[:_LONGEST_SHOWN]))
    return Fault(f"{path}:{line}", what, expected, _GRADE_AGAIN)


def explain_amount(path: Path, line: int, column: str, cell: str) -> Fault:
    """What is wrong with a cell that should hold a number of points."""
    return explain_cell(path, line, column, cell, Message("marks.amount"))


def explain_missing(path: Path, columns: Sequence[str]) -> Fault:
    """What is wrong with a file that lacks these columns."""
    return explain_edited(path, Message("marks.no-column", columns=list_plainly(columns)))


def read_records(folder: Path, file: TableFile) -> Iterator[tuple[int, Record]]:
    """The cells of a file in the order of its columns, with the line on which each record ends;
    those of an optional column that is missing are empty.

    Records are read one at a time, so that a million of them take no memory. Raises TableError at
    the line of the fault.
    """
    path = folder / file.name
    try:
        with _readable(path), path.open(encoding="utf-8-sig", newline="") as stream:
            reader = csv.reader(stream, strict=True)
            header = next(reader, [])
            missing = [name for name in file.columns if name not in header]
            required = [name for name in missing if name not in file.optional]
            if required:
                raise TableError(explain_missing(path, required))
            found = [*header, *missing]
            choose = tuple if found == [*file.columns] else _choose(found, file.columns)
            blank, width = [""] * len(missing), len(header)
            for cells in reader:
                if len(cells) != width:
                    wrong = Message("marks.width", count=len(cells), header=width)
                    raise TableError(explain_edited(f"{path}:{reader.line_num}", wrong))
                yield reader.line_num, choose(cells + blank if blank else cells)
    except (UnicodeDecodeError, csv.Error) as fault:
        problem = Message("marks.not-csv", fault=str(fault))
        raise TableError(explain_edited(path, problem)) from fault


def _choose(header: Sequence[str], columns: Sequence[str]) -> Callable[[Sequence[str]], Record]:
    """Gives the cells of these columns; `itemgetter` of a single one gives no tuple."""
    places = list(map(header.index, columns))
    if len(places) > 1:
        return itemgetter(*places)
    (only,) = places
    return lambda cells: (cells[only],)


def read_records_if_any(folder: Path, file: TableFile) -> Iterator[tuple[int, Record]]:
    """The same for a file that not every folder has."""
    if os.path.exists(folder / file.name):  # of a name too long, too
        yield from read_records(folder, file)


def read_whole(folder: Path, file: TableFile) -> Table:
    """A whole file at once, with whatever separator a spreadsheet gave it. Raises TableError."""
    path = folder / file.name
    with _readable(path):
        content = path.read_bytes()
    table = parse_table(content, str(path))
    required = [name for name in file.columns if name not in file.optional]
    missing = [name for name in required if name not in table.header]
    faults = [explain_missing(path, missing)] if missing else []
    for each in table.complaints:
        where = path if each.line is None else f"{path}:{each.line}"
        faults.append(explain_edited(where, each.problem))
    if faults:
        raise TableError(*faults)
    return table


@lru_cache(maxsize=4096)  # there are few distinct amounts
def find_amount(cell: str) -> Fraction | None:
    """A number of points as it is written; None for anything else."""
    return Fraction(cell) if _AMOUNT.fullmatch(cell) else None


def read_amount(cell: str, path: Path, line: int, column: str) -> Fraction:
    """A number of points. Raises TableError."""
    found = find_amount(cell)
    if found is None:
        raise TableError(explain_amount(path, line, column, cell))
    return found


def require_number(cell: str, path: Path, line: int, column: str) -> str:
    """The cell, unchanged, if it is empty or a number of bounded size. Raises TableError."""
    if not cell or _PLAIN.fullmatch(cell):
        return cell
    try:
        read_number(cell)
    except NumberError as fault:
        raise TableError(explain_cell(path, line, column, cell, Message("marks.number"))) from fault
    return cell


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as fault:
        raise TableError(
            Fault(
                str(path),
                Message("marks.not-readable", reason=fault.strerror or ""),
                Message("marks.folder"),
                Message("marks.check-name"),
            )
        ) from fault
