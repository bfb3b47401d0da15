"""A marks folder without its people: points, verdicts and numbers stay, so that statistics still
work; ids, names, and all that anybody typed in words are gone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinegrade.files.csv_writing import write_csv, write_for_people
from kinegrade.marks_folder.cells import read_records_if_any, read_whole
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import (
    ANSWERS,
    COMPLAINTS,
    FORMER_IDS,
    GRADES,
    TABLES,
    TableFile,
)

_NAMED = ("student", "key_of", "exam")
# May hold a name, what somebody typed, a time that another system's log has, too, or a code
_TELLING = ("name", "reason", "marks", "comment", "submitted", "paper")
_READ_AS = "read_as"


def forget_marks(marks: MarksFolder, names: Mapping[str, str], target: Path) -> None:
    """Write the files of a marks folder into `target`, which exists, with these names in place of
    ids, and of what the exam was known by. Complaints, which quote what was typed, are left out; so
    are files for other systems.
    """
    for file in TABLES:
        if file not in (GRADES, FORMER_IDS) and (marks.path / file.name).exists():
            rows = [] if file == COMPLAINTS else _list_rows(marks, file, names)
            write_csv(target / file.name, file.columns, rows)
    table = read_whole(marks.path, GRADES)
    cells = (dict(zip(table.header, row.cells, strict=False)) for row in table.rows)
    rows = sorted(
        [_forget_cell(name, row.get(name, ""), names) for name in table.header] for row in cells
    )
    write_for_people(target / GRADES.name, table.header, rows)


def _list_rows(
    marks: MarksFolder, file: TableFile, names: Mapping[str, str]
) -> Sequence[Sequence[str]]:
    """The rows of a file, those of one student together and in the order of the new names."""
    rows = [cells for _, cells in read_records_if_any(marks.path, file)]
    new = [list(_forget_cells(file, cells, names)) for cells in rows]
    if "student" in file.columns:
        new.sort(key=lambda cells: cells[file.columns.index("student")])
    return new


def _forget_cells(file: TableFile, cells: Sequence[str], names: Mapping[str, str]) -> Iterator[str]:
    """A row; an answer stays where it was read as a number, and is that number then."""
    by_name = dict(zip(file.columns, cells, strict=True))
    for name, cell in by_name.items():
        if file == ANSWERS and name == "response":
            yield by_name[_READ_AS]
        else:
            yield _forget_cell(name, cell, names)


def _forget_cell(column: str, cell: str, names: Mapping[str, str]) -> str:
    if column in _NAMED:
        return names[cell]
    return "" if column in _TELLING else cell
