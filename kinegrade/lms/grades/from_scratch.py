"""A grade file written from scratch, for systems whose import needs nothing that only they know.

`new_file` is called by `export`, and through `moodle.export` by `grade`. A student who handed in
nothing is left out, because an empty or zero grade would replace the one in the system.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from html import escape
from operator import attrgetter
from typing import assert_never

from kinegrade.errors import Problem, TableError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.files.csv_writing import neutralise, write_csv_text, write_quoted_csv_text
from kinegrade.files.tables import Complaint
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import read_language
from kinegrade.language.message import Message, Quoted, list_plainly
from kinegrade.lms.grades.cells import BYTE_ORDER_MARK
from kinegrade.lms.grades.dialect import FIELDS, Column, Dialect, ExportOptions, Field, NewFile
from kinegrade.lms.grades.grades import TOTAL, ClassGrades, FeedbackTexts, StudentGrade, known_as
from kinegrade.lms.grades.item_candidates import number
from kinegrade.lms.grades.item_columns import item_title, items_of
from kinegrade.lms.grades.maximum import maximum_faults, scaled, target_maximum
from kinegrade.numbers.amounts import write_amount


@dataclass(frozen=True, slots=True)
class Fresh:
    """The text, as UTF-8, how many students are in it, and what the instructor has to check."""

    text: str
    students: int
    complaints: tuple[Complaint, ...]


@dataclass(frozen=True)
class _Plan:
    """The columns of the file: each with its final header and, for a grade, its item."""

    dialect: Dialect
    layout: NewFile
    columns: tuple[tuple[Column, str, str], ...]
    targets: Mapping[str, Fraction | None]
    key: Field
    feedback: FeedbackTexts


def new_file(dialect: Dialect, grades: ClassGrades, options: ExportOptions) -> Fresh:
    """The file of a class for a system. Raises TableError with all faults at once."""
    layout = _choose_layout(dialect, options)
    students = grades.exported(ungraded=options.ungraded)
    plan = _plan(dialect, layout, grades, students, options)
    _refuse_unknown_addresses(plan.key, students)
    known = [each for each in students if known_as(each, plan.key)]
    header = [header for _, header, _ in plan.columns]
    cells = [map(_choose_writer(plan, column, item), known) for column, _, item in plan.columns]
    rows = zip(*cells, strict=True)  # each is written as soon as it is made
    text = (
        write_quoted_csv_text(header, rows) if layout.quotes_all else write_csv_text(header, rows)
    )
    mark = BYTE_ORDER_MARK if layout.mark else ""
    return Fresh(mark + text, len(known), tuple(_find_keyless(plan.key, students)))


def _refuse_unknown_addresses(key: Field, students: Sequence[StudentGrade]) -> None:
    if key == "email" and students and not any(each.email for each in students):
        raise TableError(Message("grades.no-addresses"))


def _choose_layout(dialect: Dialect, options: ExportOptions) -> NewFile:
    layout = dialect.new_file
    if layout is None:
        raise TableError(Message("grades.only-into", system=dialect.name))
    if len(options.by) > 1:
        raise TableError(Message("grades.one-key", keys=list_plainly(options.by)))
    key = options.by[0] if options.by else layout.key
    if not any(column.holds(key) for column in layout.columns):
        known = list_plainly(
            field for field in FIELDS if any(column.holds(field) for column in layout.columns)
        )
        raise TableError(Message("grades.other-key", system=dialect.name, key=key, known=known))
    if options.feedback and (
        options.per_question or not any(each.role == "feedback" for each in layout.columns)
    ):
        if options.per_question:
            raise TableError(Message("grades.no-feedback-by-question", system=dialect.name))
        raise TableError(Message("grades.no-feedback-here", system=dialect.name))
    return layout


def _plan(
    dialect: Dialect,
    layout: NewFile,
    grades: ClassGrades,
    students: Sequence[StudentGrade],
    options: ExportOptions,
) -> _Plan:
    key = options.by[0] if options.by else layout.key
    # A spreadsheet would run a title such as =1+1; a header from --column is a key and stays
    language = grades.language if options.language is None else read_language(options.language)
    words = open_catalogue(language)
    title = neutralise(options.title or words.write(layout.title) or grades.title)
    items = items_of(grades, options)
    headers = {item: options.columns.get(item, "") for item in items}
    faults: list[Problem] = list(_find_title_faults(dialect, layout, title, headers))
    stated = {item: _find_stated(dialect, headers[item]) for item in items}
    for item in items:
        where = Message("grades.item", title=Quoted(headers[item] or item_title(title, item)))
        faults += maximum_faults(where, item, students, stated[item], options)
    targets = {item: target_maximum(stated[item], options) for item in items}
    maxima = {item: _find_maximum(students, item, targets[item]) for item in items}
    if faults:
        raise TableError(*dict.fromkeys(faults))
    graded = any(each.scale_grade for each in grades.students)
    kept = [each for each in layout.columns if _is_kept(each, layout, key, options, graded)]
    columns: list[tuple[Column, str, str]] = []
    for column in kept:
        header, several = words.write(column.header), items if column.role == "grade" else ()
        columns += [
            (column, headers.get(item) or _write_grades(header, title, item, maxima), item)
            for item in several
        ]
        columns += [] if several else [(column, _write_header(header, title, set()), TOTAL)]
    feedback = FeedbackTexts(grades.questions, grades.language)
    return _Plan(dialect, layout, tuple(columns), targets, key, feedback)


def _write_grades(header: str, title: str, item: str, maxima: Mapping[str, set[Fraction]]) -> str:
    return _write_header(header, item_title(title, item), maxima.get(item, set()))


def _write_header(header: str, title: str, maxima: set[Fraction]) -> str:
    maximum = write_amount(min(maxima, default=Fraction(0)))
    return header.replace("{maximum}", maximum).replace("{title}", title)


def _find_title_faults(
    dialect: Dialect, layout: NewFile, title: str, headers: Mapping[str, str]
) -> Iterator[Message]:
    if layout.header_needed:
        for item, header in headers.items():
            shapes = [download.item for download in dialect.downloads]
            if not any(shape.fullmatch(header) for shape in shapes):
                way = f"--column {item}=HEADER" if item else "--column HEADER"
                if header:
                    yield Message(
                        "grades.no-grade-header",
                        system=dialect.name,
                        header=Quoted(header),
                        way=way,
                    )
                elif item:
                    yield Message(
                        "grades.question-column-unnamed",
                        system=dialect.name,
                        question=item,
                        way=way,
                    )
                else:
                    yield Message("grades.total-column-unnamed", system=dialect.name, way=way)
        return
    if all(headers.values()):
        return
    if not title:
        yield Message("grades.no-title", system=dialect.name)
    for shape, reason in layout.unfit:
        if shape.search(title):
            yield Message("grades.unfit-title", title=Quoted(title), reason=reason)


def _find_stated(dialect: Dialect, header: str) -> Fraction | None:
    """The maximum that a header states."""
    for download in dialect.downloads:
        found = download.item.fullmatch(header)
        if found and found.groupdict().get("maximum"):
            return number(found["maximum"])
    return None


def _find_maximum(
    students: Sequence[StudentGrade], item: str, target: Fraction | None
) -> set[Fraction]:
    return {target} if target is not None else {each.out_of[item] for each in students}


def _is_kept(
    column: Column, layout: NewFile, key: Field, options: ExportOptions, graded: bool
) -> bool:
    match column.role:
        case "id" | "login" | "email":
            return column.holds(key) or layout.keeps_keys
        case "feedback" | "feedback format":
            return options.feedback is not False and not options.per_question
        case "letter":
            return graded and not options.per_question
        case "name" | "name and id" | "grade" | "fixed":
            return True
        case _:
            assert_never(column.role)


def _choose_writer(plan: _Plan, column: Column, item: str) -> Callable[[StudentGrade], str]:
    """What writes a grade's cell of a column."""
    match column.role:
        case "id" | "login" | "email":
            if not column.holds(plan.key):
                return lambda _: ""
            return lambda grade: column.text + known_as(grade, plan.key)
        case "name":
            return attrgetter("name")
        case "name and id":
            return lambda grade: f"{grade.name} [{grade.student}]"
        case "grade":
            target, places = plan.targets[item], plan.dialect.places
            return lambda grade: write_amount(scaled(grade, item, target), places)
        case "letter":
            return lambda grade: neutralise(grade.scale_grade)
        case "feedback":
            if column.html:
                return lambda grade: escape(plan.feedback.write(grade), quote=False)
            return plan.feedback.write
        case "feedback format" | "fixed":
            return lambda _: column.text
        case _:
            assert_never(column.role)


def _find_keyless(key: Field, students: Sequence[StudentGrade]) -> Iterator[Complaint]:
    for each in students:
        if not known_as(each, key):
            problem = Message("grades.no-address", student=Quoted(each.student))
            done = Message("grades.give-address")
            yield Complaint(HEAD, None, "", each.student, problem, done)
