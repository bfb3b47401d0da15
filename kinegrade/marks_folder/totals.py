"""grades.csv, read together with kept.csv."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass, field
from fractions import Fraction
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import restore
from kinegrade.files.rows.row import Row, choose_cells
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault
from kinegrade.marks_folder.cells import explain_amount, find_amount, read_whole
from kinegrade.marks_folder.layout import GRADES, SCALE_GRADE, SUBTRACTED_POINTS
from kinegrade.marks_folder.rows import ClassTotals, KeptTotal, StudentTotal


def read_totals(folder: Path, kept: Mapping[str, KeptTotal], some: Set[str]) -> ClassTotals:
    """Every student's line of grades.csv; those who may hold only `some` of the questions have
    empty cells at the others. Raises TableError naming all cells that hold no amount.
    """
    table = read_whole(folder, GRADES)
    questions = tuple(name for name in table.header if name not in GRADES.columns)
    places = {name: place for place, name in enumerate(table.header)}
    who = itemgetter(places.pop("student"), places.pop("name"))
    held = choose_cells([*places.values()])
    reader = _Reader(folder / GRADES.name, table, questions, kept, some, who, held)
    students = tuple(map(reader.total, table.rows))
    if reader.faults:
        raise TableError(*reader.faults)
    return ClassTotals(questions, students)


class _Amounts(NamedTuple):
    """What a row holds beside whose it is; most rows share it with others."""

    points: Mapping[str, Fraction]
    total: Fraction
    out_of: Fraction
    percent: Fraction | None
    status: str | None
    grade: str
    subtracted: Fraction


@dataclass
class _Reader:
    """Reads rows by the columns of their table: of the cells of a row `who` picks id and name,
    `held` the others. `faults` are those found so far, `known` what rows without any hold, by their
    cells and whether they have all questions; `shared` are points by the cells of the questions.
    """

    path: Path
    table: Table
    questions: tuple[str, ...]
    kept: Mapping[str, KeptTotal]
    some: Set[str]
    who: Callable[[tuple[str, ...]], tuple[str, str]]
    held: Callable[[tuple[str, ...]], tuple[str, ...]]
    faults: list[Fault] = field(default_factory=list)
    known: dict[tuple[bool, tuple[str, ...]], _Amounts] = field(default_factory=dict)
    shared: dict[tuple[str, ...], Mapping[str, Fraction]] = field(default_factory=dict)

    def total(self, row: Row) -> StudentTotal:
        """A row, typed."""
        student, name = self.who(row.cells)
        key = student not in self.some, self.held(row.cells)
        held = self.known.get(key) or self._read(row, key)
        return StudentTotal(
            row.line,
            student,
            restore(name),
            held.points,
            held.total,
            held.out_of,
            held.percent,
            held.status,
            self.kept.get(student),
            held.grade,
            held.subtracted,
        )

    def _read(self, row: Row, key: tuple[bool, tuple[str, ...]]) -> _Amounts:
        """What a row holds; it is known from then on if nothing is wrong with it."""
        cells = dict(zip(self.table.header, row.cells, strict=False))
        whole, before = key[0], len(self.faults)
        held = [name for name in self.questions if whole or cells[name]]
        # What is subtracted is blank where of several folders put together this one says nothing
        amounts = {
            name: self._amount(row, name, cells[name])
            for name in (*held, "total", "out_of", "percent", SUBTRACTED_POINTS)
            if cells.get(name) or (name in cells and name != SUBTRACTED_POINTS)
        }
        found = _Amounts(
            self._share(tuple(map(cells.__getitem__, self.questions)), held, amounts),
            amounts["total"],
            amounts["out_of"],
            amounts.get("percent"),
            cells.get("status"),
            restore(cells.get(SCALE_GRADE, "")),
            amounts.get(SUBTRACTED_POINTS, Fraction(0)),
        )
        if len(self.faults) == before:
            self.known[key] = found
        return found

    def _share(
        self, cells: tuple[str, ...], held: Sequence[str], amounts: Mapping[str, Fraction]
    ) -> Mapping[str, Fraction]:
        """The points of the questions held; the same object wherever the cells are the same."""
        key = (*cells, *held) if len(held) < len(cells) else cells
        if key not in self.shared:
            self.shared[key] = {name: amounts[name] for name in held}
        return self.shared[key]

    def _amount(self, row: Row, column: str, cell: str) -> Fraction:
        found = find_amount(cell)
        if found is None:
            self.faults.append(explain_amount(self.path, row.line, column, cell))
        return found or Fraction(0)
