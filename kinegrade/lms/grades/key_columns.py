"""Which columns of a downloaded file identify the student.

Fixed headers of a system are trusted. Where headers may be in any language, as in Moodle's
gradebook, the columns are those that hold the class's ids or e-mail addresses, and a known header
only confirms. `key_columns` is called by `fill_in`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.files.cell_text import trim
from kinegrade.language.message import Fault, Message, Text, list_plainly
from kinegrade.lms.grades.cells import CellTable, Record
from kinegrade.lms.grades.dialect import Dialect, Download, ExportOptions, Key
from kinegrade.lms.grades.grades import StudentGrade
from kinegrade.lms.grades.item_groups import is_item_header
from kinegrade.lms.grades.key_column import KeyColumn
from kinegrade.lms.grades.probable_rows import folded

_ENOUGH = 5  # ids of the class in a column without repetitions are no coincidence
_MOST_REPEATED = 10  # one cell in ten may be a repetition
_SHORTEST_ID_AMONG_GRADES = 5  # "12" below "Quiz (Real)" is a grade, even where it is an id too


def key_columns(
    dialect: Dialect,
    download: Download,
    table: CellTable,
    rows: Sequence[Record],
    *,
    students: Sequence[StudentGrade],
    options: ExportOptions,
) -> Sequence[KeyColumn]:
    """The columns by which rows are matched. Raises TableError where there is none."""
    keys = [key for key in download.keys if not options.by or key.field in options.by]
    found: Sequence[KeyColumn] = ()
    if download.item_words is not None:
        found = _find_by_content(table, rows, keys, download.keys, students)
    if found := found or _find_by_header(table, keys):
        return found
    if download.item_words is not None:
        hint = exam_hint(table, students)
        missing = Message("grades.no-key-content", system=dialect.name, hint=hint)
        raise TableError(Fault(table.file, missing))
    known = [title for key in keys for title in key.headers]
    titles = list_plainly(known) if known else Message("grammar.no-names")
    missing = Message("grades.no-key-column", system=dialect.name, titles=titles)
    raise TableError(Fault(table.file, missing))


def exam_hint(table: CellTable, students: Sequence[StudentGrade]) -> Text:
    """What else may help where a file has addresses, and no student's is known."""
    if any(each.email for each in students):
        return ""
    for place in range(len(table.titles)):
        cells = [text for row in table.rows if (text := trim(row.cells[place].text))]
        if cells and 2 * sum("@" in cell for cell in cells) > len(cells):
            return Message("grades.or-exam")
    return ""


def _find_by_header(table: CellTable, keys: Iterable[Key]) -> list[KeyColumn]:
    columns = []
    for key in keys:
        places = (
            {key.position}
            if key.position is not None
            else {place for place, title in enumerate(table.titles) if title in key.headers}
        )
        columns += [KeyColumn(key, place) for place in sorted(places)]
    return columns


def _find_by_content(
    table: CellTable,
    rows: Sequence[Record],
    keys: Sequence[Key],
    known: Sequence[Key],
    students: Sequence[StudentGrade],
) -> list[KeyColumn]:
    """The columns that hold enough of the class's ids or addresses, each with the key that finds
    the most students.
    """
    wanted = [_Wanted.of(key, students) for key in keys]
    found = []
    for place, title in enumerate(table.titles):
        named = next((key.field for key in known if title in key.headers), None)
        cells = [text for row in rows if (text := trim(row.cells[place].text))]
        shortest = _SHORTEST_ID_AMONG_GRADES if is_item_header(title) else 1
        possible = [each for each in wanted if not _is_the_other(each.key, named)]
        held = [each.held(cells, shortest) for each in possible]
        best = max(held, key=lambda each: each.students, default=None)
        if best is not None and best.convinces(named):
            found.append(KeyColumn(best.key, place))
    return found


def _is_the_other(key: Key, named: str | None) -> bool:
    """Ids and logins look alike; where a header is known to be one of them, it is not the other."""
    return {key.field, named} == {"id", "login"}


@dataclass(frozen=True, slots=True)
class _Wanted:
    """The class's values of a key: as the system compares them, as a spreadsheet may leave them."""

    key: Key
    exact: frozenset[str]
    folded: frozenset[str]

    @classmethod
    def of(cls, key: Key, students: Sequence[StudentGrade]) -> _Wanted:
        """The keys of a class."""
        column = KeyColumn(key, 0)
        exact = frozenset(text for each in students if (text := column.wanted(each)))
        return cls(key, exact, frozenset(map(folded, exact)))

    def held(self, cells: Sequence[str], shortest: int) -> _Held:
        """How many of them a column with these cells holds; shorter cells do not count."""
        different = {text for text in cells if len(text) >= shortest}
        column = KeyColumn(self.key, 0)
        exact = self.exact.intersection(map(column.compared, different))
        alike = self.folded.intersection(map(folded, different))
        students = max(len(exact), len(alike))
        return _Held(self.key, students, len(self.exact), len(cells), len(set(cells)))


@dataclass(frozen=True, slots=True)
class _Held:
    """How many students of the class a column identifies by a key, and what else it holds."""

    key: Key
    students: int
    wanted: int
    filled: int
    different: int

    def convinces(self, named: str | None) -> bool:
        """Whether the column holds the keys: few repeat, and they are most of the file, most of the
        class, or many.
        """
        if not self.students or self.key.field == named:
            return bool(self.students)
        repeated = self.filled - self.different
        most = 2 * self.students >= min(self.filled, self.wanted)
        return _MOST_REPEATED * repeated <= self.filled and (most or self.students >= _ENOUGH)
