"""`kinegrade export --to xlsx --into`: grades filled into the workbook of an examination office.

Rows are found by the students' ids, columns by their headers. Only the cells of grades change:
other cells, formulas, styles and all other parts of the workbook keep their bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.exam.roster.student_ids import describe_restoration
from kinegrade.files.cell_text import trim
from kinegrade.files.tables import Complaint
from kinegrade.files.workbooks.parts import WorkbookParts, read_workbook_parts
from kinegrade.files.workbooks.sheet_xml import Position, SheetCell, write_position
from kinegrade.language.message import Fault, Message, Quoted, list_all, list_plainly
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.fill_in import Filled
from kinegrade.lms.grades.grades import ClassGrades
from kinegrade.lms.grades.item_candidates import number
from kinegrade.lms.grades.item_columns import items_of
from kinegrade.lms.grades.maximum import maximum_faults, scaled, target_maximum
from kinegrade.lms.grades.office.class_list import ClassList
from kinegrade.lms.grades.office.id_column import find_class_list
from kinegrade.numbers.amounts import write_amount

_MOST_NAMED = 20


def fill_workbook(grades: ClassGrades, into: Path, options: ExportOptions) -> Filled:
    """The workbook with the grades. Raises TableError with all faults at once: cells that hold
    something else are filled only where `options` say so, and formulas never.
    """
    book = read_workbook_parts(into)
    students = [each.student for each in grades.students]
    found = find_class_list(book, students, options.id_column)
    _require_columns(found, grades, options)
    columns = {
        item: found.find_header(options.columns.get(item, ""))[1]
        for item in items_of(grades, options)
    }
    values = dict(_list_values(found, columns, grades, options))
    faults = [*_list_maximum_faults(found, grades, options), *_find_faults(found, values, options)]
    if faults:
        raise TableError(*faults[:_MOST_NAMED])
    cells = found.sheet.xml.cells
    new = {place: text for place, text in values.items() if not _holds(cells.get(place), text)}
    xml = found.sheet.xml.with_values(new)
    return Filled(
        book.with_part(found.sheet.part, xml),
        len({row for row, _ in values}),
        tuple(_list_complaints(found, grades, options)),
        tuple(_list_notes(book, found, columns)),
    )


def _require_columns(found: ClassList, grades: ClassGrades, options: ExportOptions) -> None:
    """Raises TableError where a question has no column, such as a bonus marked by hand."""
    wanted = [item for item in items_of(grades, options) if item not in options.columns]
    if any(wanted):
        unnamed = Message("grades.columns-unnamed", questions=list_plainly(wanted))
        raise TableError(Fault(found.where, unnamed, do=Message("grades.name-columns")))


def _list_values(
    found: ClassList, columns: Mapping[str, int], grades: ClassGrades, options: ExportOptions
) -> Iterator[tuple[Position, str]]:
    """The points of those who have one row, or their grades of the scale, by the cell that they go
    into.
    """
    target = target_maximum(None, options)
    for grade in grades.exported(ungraded=options.ungraded):
        rows = found.rows.get(grade.student, ())
        for item, column in columns.items():
            if len(rows) != 1 or item not in grade.points:
                continue
            points = write_amount(scaled(grade, item, target))
            if text := _say(grade.scale_grade) if options.of_scale else points:
                yield (rows[0], column), text


def _list_maximum_faults(
    found: ClassList, grades: ClassGrades, options: ExportOptions
) -> Iterator[Problem]:
    """Why points cannot be written as they are, where points are written."""
    students = grades.exported(ungraded=options.ungraded)
    for item in () if options.of_scale else items_of(grades, options):
        yield from maximum_faults(item or found.where, item, students, None, options)


def _say(grade: str) -> str:
    """A grade of the scale: 1,3 as a number, as the office counts with it, and others as a text; ""
    for the absent where the scale has no word for them.
    """
    value = number(grade)
    return grade if value is None else write_amount(value)


def _holds(cell: SheetCell | None, text: str) -> bool:
    """Whether a cell holds that number or text already."""
    if cell is None:
        return False
    held = trim(cell.text)
    return held == text or number(held) == number(text) is not None


def _may_hold(cell: SheetCell, text: str) -> bool:
    """Whether nothing is lost where a cell gets that number."""
    return not trim(cell.text) or _holds(cell, text)


def _find_faults(
    found: ClassList, values: Mapping[Position, str], options: ExportOptions
) -> Iterator[Problem]:
    """Why cells cannot be filled, one after the other."""
    for place, text in values.items():
        where = f"{found.where}: {write_position(place)}"
        cell = found.sheet.xml.cells.get(place)
        if cell is not None and cell.is_computed:
            yield Fault(where, Message("grades.cell-computed"), do=Message("grades.other-column"))
        elif any(each.holds(place) and each.first != place for each in found.sheet.xml.merged):
            yield Fault(where, Message("grades.cell-merged"), do=Message("grades.other-column"))
        elif not options.overwrite and cell is not None and not _may_hold(cell, text):
            what = Message("grades.cell-filled", text=Quoted(trim(cell.text)), grade=text)
            yield Fault(where, what, do=Message("grades.add-overwrite"))


def _list_complaints(
    found: ClassList, grades: ClassGrades, options: ExportOptions
) -> Iterator[Complaint]:
    """Who is missing on either side, and who stands there twice."""
    keys = found.name_column(found.column)
    for grade in grades.exported(ungraded=options.ungraded):
        rows = found.rows.get(grade.student, ())
        student = Quoted(grade.student)
        if not rows:
            problem = Message("grades.no-row", student=student, keys=keys)
            done = Message("grades.not-exported")
            yield Complaint(found.where, None, "", grade.student, problem, done)
        elif len(rows) > 1:
            problem = Message("grades.ambiguous", student=student, lines=list_all(rows), keys=keys)
            done = Message("grades.lines-unchanged")
            yield Complaint(found.where, rows[0], "", grade.student, problem, done)
    for row, text in found.strangers():
        problem = Message("grades.stranger", shown=f'{keys} "{trim(text)}"')
        done = Message("grades.line-unchanged")
        yield Complaint(found.where, row, "", text, problem, done)


def _list_notes(
    book: WorkbookParts, found: ClassList, columns: Mapping[str, int]
) -> Iterator[Problem]:
    """What went where, ids that were repaired, and that formulas show what they showed."""
    headers = [Quoted(each) for each in map(found.name_column, columns.values())]
    into = Message("grades.into", points=list_all(headers))
    keyed = list_all([Quoted(found.name_column(found.column))])
    yield Fault(found.where, Message("grades.found-by", keys=keyed, into=into))
    if found.restored:
        problem, done = describe_restoration(found.restored)
        yield Fault(found.where, problem, do=done)
    if book.has_formulas:
        yield Fault(book.file, Message("grades.formulas-wait"))
