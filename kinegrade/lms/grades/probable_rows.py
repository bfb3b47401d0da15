"""Rows that are only probably a student's: their key may have been changed by a spreadsheet."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from decimal import Decimal
from unicodedata import normalize

from kinegrade.files.cell_text import trim
from kinegrade.language.message import (
    Message,
    Quoted,
)
from kinegrade.lms.grades.cells import CellTable, Record
from kinegrade.lms.grades.grades import StudentGrade
from kinegrade.lms.grades.key_column import KeyColumn

_CUT_NUMBER = re.compile(r"([0-9])(?:[.,]([0-9]{1,15}))?E\+?([0-9]{1,2})", re.IGNORECASE)
_WRAPPED = re.compile(r'=?"(.*)"|[\'#](.*)')


class ProbableRows:
    """The rows that no student matches, by what their cell of one key column may once have been."""

    def __init__(self, table: CellTable, column: KeyColumn, free: Iterable[Record]) -> None:
        self.column, self.title = column, table.titles[column.place]
        self.folded: dict[str, list[Record]] = defaultdict(list)
        self.cut: dict[int, dict[str, list[Record]]] = defaultdict(lambda: defaultdict(list))
        for row in free:
            cell = trim(row.cells[column.place].text)
            self.folded[folded(cell)].append(row)
            found = _CUT_NUMBER.fullmatch(cell)
            if found:
                self.cut[len(found[2] or "")][
                    f"{found[1]}.{found[2] or ''}E+{int(found[3])}"
                ].append(row)

    def hints(self, grade: StudentGrade) -> Iterator[Message]:
        """Rows that may be the student's, each with what to do about it."""
        wanted = self.column.wanted(grade)
        for row in self.folded.get(folded(wanted), ()) if wanted else ():
            yield Message("grades.probably-the-same", row=self._shown(row))
        if not (wanted.isascii() and wanted.isdigit()):
            return
        for digits, rows in self.cut.items():
            whole, _, rest = f"{Decimal(wanted):.{digits}E}".partition("E+")
            for row in rows.get(f"{whole}{'' if digits else '.'}E+{rest}", ()):
                yield Message("grades.cut-number", row=self._shown(row))

    def _shown(self, row: Record) -> Message:
        cell = Quoted(trim(row.cells[self.column.place].text)[:60])
        return Message("grades.row-has", line=row.line, title=self.title, text=cell)


def folded(text: str) -> str:
    """A value without what spreadsheets and keyboards change: wrappers, leading zeros, full-width
    forms, case.

    >>> folded("０0７"), folded('="007"'), folded("7.0")
    ('7', '7', '7')
    """
    plain = trim(normalize("NFKC", text))
    wrapped = _WRAPPED.fullmatch(plain)
    inner = (wrapped[1] or wrapped[2] or "") if wrapped else plain
    return trim(inner).casefold().removesuffix(".0").lstrip("0")
