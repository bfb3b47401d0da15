"""Which column of somebody else's workbook says whose row it is.

Found by what its cells hold. Where several columns hold ids of the class, as where partners stand
beside students, the one that is called as ids are called; there is no guessing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from kinegrade.errors import TableError, suggest
from kinegrade.exam.roster.known_columns import list_column_names
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.workbooks.parts import WorkbookParts
from kinegrade.language.message import Fault, Message, Quoted, list_all
from kinegrade.lms.grades.office.class_list import ClassList, find_student, name_letter

_COMPETES = 2  # a column with a half of the ids of the best may be meant, too


def find_class_list(book: WorkbookParts, students: Sequence[str], wanted: str = "") -> ClassList:
    """The sheet with the most ids of these students in a column, and that column: the one that is
    `wanted`, by its header or its letter. Raises TableError where there is none, or not one alone.
    """
    ids = StudentIds(students, {})
    counts = Counter(
        (number, column)
        for number, sheet in enumerate(book.sheets)
        for (_, column), cell in sheet.xml.cells.items()
        if find_student(ids, cell.text) is not None
    )
    if not counts:
        what, expected = Message("grades.no-ids"), Message("grades.column-of-ids")
        raise TableError(Fault(book.file, what, expected))
    most = max(counts.values())
    best = min(number for (number, _), count in counts.items() if count == most)
    lists = [
        ClassList(book.file, book.sheets[number], ids, column)
        for (number, column), count in sorted(counts.items())
        if number == best and (wanted or count * _COMPETES >= most)
    ]
    return _choose(lists, wanted)


def _choose(lists: Sequence[ClassList], wanted: str) -> ClassList:
    """The one whose ids count. Raises TableError."""
    meant = [
        each for each in lists if (_is_wanted(each, wanted) if wanted else _is_called_so(each))
    ]
    if wanted and not meant:
        what = Message("grades.no-id-column", header=Quoted(wanted))
        do = suggest(wanted, [each.name_column(each.column) for each in lists])
        raise TableError(Fault(lists[0].where, what, do=do))
    left = meant or lists
    if any(each.rows != left[0].rows for each in left):
        columns = list_all([_show(each) for each in left])
        what = Message("grades.several-id-columns", columns=columns)
        raise TableError(Fault(left[0].where, what, do=Message("grades.name-id-column")))
    return left[0]


def _is_wanted(found: ClassList, wanted: str) -> bool:
    names = found.name_column(found.column), name_letter(found.column)
    return make_header_key(wanted) in map(make_header_key, names)


def _is_called_so(found: ClassList) -> bool:
    """Whether the column is called as columns of ids are."""
    return make_header_key(found.name_column(found.column)) in list_column_names("student")


def _show(found: ClassList) -> Message:
    header = Quoted(found.name_column(found.column))
    return Message("grades.id-column", header=header, letter=name_letter(found.column))
