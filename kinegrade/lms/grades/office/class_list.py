"""A class list in somebody else's workbook: the ids of the class in one column of a sheet, and
above them the headers of the columns to be filled.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from kinegrade.errors import TableError, suggest
from kinegrade.exam.roster.known_columns import list_column_names
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.workbooks.parts import WorkbookSheet
from kinegrade.files.workbooks.sheet_xml import SheetCell, write_position
from kinegrade.language.message import Fault, Message, Quoted, list_plainly


@dataclass(frozen=True)
class ClassList:
    """The ids of a class in one column of a sheet."""

    file: str
    sheet: WorkbookSheet
    ids: StudentIds
    column: int

    @property
    def where(self) -> str:
        """The file and the sheet, for messages."""
        return f"{self.file}: {self.sheet.name}"

    @cached_property
    def rows(self) -> Mapping[str, list[int]]:
        """The rows of each student who has any."""
        found: dict[str, list[int]] = defaultdict(list)
        for row, cell in self._list_cells():
            student = find_student(self.ids, cell.text)
            if student is not None:
                found[student].append(row)
        return found

    @cached_property
    def restored(self) -> Mapping[str, str]:
        """The cells that are not ids as they are in the exam, with the students whom they mean."""
        cells = [cell.text for _, cell in self._list_cells() if self.ids.exact(cell.text) is None]
        exact = {found for _, cell in self._list_cells() if (found := self.ids.exact(cell.text))}
        return self.ids.restored(cells, exact)

    @property
    def first_row(self) -> int:
        """The first row with a student."""
        return min(row for rows in self.rows.values() for row in rows)

    def strangers(self) -> Iterator[tuple[int, str]]:
        """The rows below the first student's that have something else in the column of ids."""
        known = {row for rows in self.rows.values() for row in rows}
        for row, cell in self._list_cells():
            if row > self.first_row and row not in known and trim(cell.text):
                yield row, cell.text

    def find_header(self, wanted: str = "") -> tuple[int, int]:
        """Row and column of the header that says what is wanted, the lowest where several do.
        Raises TableError.
        """
        headers = self._list_headers()
        found = [place for place, text in headers if _is_same(text, wanted)]
        alike = [place for place in found if place[0] == found[-1][0]]
        if not found:
            what = Message("grades.no-header", header=Quoted(wanted))
            do = suggest(wanted, dict.fromkeys(trim(text) for _, text in headers))
            raise TableError(Fault(self.where, what, do=do))
        wide = [each for each in self.sheet.xml.merged if each.holds(found[-1])]
        if len(alike) > 1 or any(each.first[1] != each.last[1] for each in wide):
            cells = list_plainly(map(write_position, alike))
            what = Message("grades.header-of-several", header=Quoted(wanted), cells=cells)
            raise TableError(Fault(self.where, what, do=Message("grades.name-one-column")))
        return found[-1]

    def name_column(self, column: int) -> str:
        """What stands lowest above the students, or lowest as ids are called; the letter of the
        column where nothing does.
        """
        above = [trim(text) for (_, place), text in self._list_headers() if place == column]
        # An id that is not of the class may stand first
        called = [text for text in above if make_header_key(text) in list_column_names("student")]
        return (called or above or [name_letter(column)])[-1]

    def _list_cells(self) -> Iterator[tuple[int, SheetCell]]:
        """The cells of the column, from above."""
        for (row, column), cell in sorted(self.sheet.xml.cells.items()):
            if column == self.column:
                yield row, cell

    def _list_headers(self) -> list[tuple[tuple[int, int], str]]:
        """The texts above the first student, from above."""
        return [
            (place, cell.text)
            for place, cell in sorted(self.sheet.xml.cells.items())
            if place[0] < self.first_row and trim(cell.text)
        ]


def name_letter(column: int) -> str:
    """A column as spreadsheets call it."""
    return write_position((0, column)).rstrip("0")


def find_student(ids: StudentIds, text: str) -> str | None:
    """The student whom a cell means, but for zeros and capitals; None where two could be meant."""
    near = () if ids.exact(text) else ids.near(text)
    return near[0] if len(near) == 1 else ids.exact(text)


def _is_same(text: str, wanted: str) -> bool:
    return make_header_key(text) == make_header_key(wanted)
