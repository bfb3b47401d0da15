"""`kinegrade.export`: marks in the grade file of a learning management system, or in one
spreadsheet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path

from kinegrade.errors import OptionError, Problem
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.endings import Kind
from kinegrade.files.output import write_file
from kinegrade.grading.exams_beside import find_later_keys
from kinegrade.grading.same_key import require_same_key
from kinegrade.language.message import Fault, Message, Part, Quoted, Text, list_plainly
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.fill_in import Filled, fill_in
from kinegrade.lms.grades.from_scratch import new_file
from kinegrade.lms.grades.grades import TOTAL, ClassGrades, read_grades
from kinegrade.lms.grades.systems import GRADE_FILES, SYSTEMS, WORKBOOK
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.open_questions import describe_unmarked
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_opened
from kinegrade.public.options import require_known, require_word
from kinegrade.public.outcome import Outcome

_ORDINARY = ExportOptions()
_NAMED = 5  # students that a message names


def export(
    marks: MarksFolder,
    output: str | PathLike[str],
    *,
    to: str,
    exam: ExamFolder | None = None,
    force: bool = False,
    options: ExportOptions = _ORDINARY,
) -> Outcome:
    """Write the grades of a class as a learning management system takes them, as `kinegrade export`
    does; `to="xlsx"` is one spreadsheet with everything, or somebody's workbook with the grades.

    E-mail addresses and the title come from the exam. Raises KinegradeError.

    >>> print(export(kinegrade.open_marks("MARKS"), "moodle.csv", to="moodle"))
    moodle.csv: grades of 1 student for Moodle; 1 handed in nothing and is left alone
    >>> export(kinegrade.open_marks("MARKS"), "grades.csv", to="modle")
    Traceback (most recent call last):
    kinegrade.errors.OptionError: to: unknown: "modle" - did you mean "moodle"? ...
    """
    expect_opened(marks=marks, exam=exam)
    if exam is not None:
        require_same_key(exam, marks)
    place = Path(output)
    expect_own_place(place)
    _require_possible(to, options)
    if to == WORKBOOK and options.into is None:
        return _export_workbook(marks, place, exam, force=force)
    grades = read_grades(marks, exam)
    _require_sense(options, grades)
    options = replace(options, title=options.title.strip())
    made = _make_file(to, grades, options)
    write_file(place, made.content, made.kind, force=force)
    remarks = *_list_above(grades, options), *_mention_scale(to, grades, options)
    notes = *made.notes, _tell(made, place, grades, options), *remarks
    untold = _list_untold(grades, place) if options.per_question else ()
    return Outcome(place, notes, (*made.complaints, *untold, *_list_wanting(marks, place, exam)))


def _require_possible(to: str, options: ExportOptions) -> None:
    """Raises OptionError for a system that is not known, and for options that it does not have."""
    require_word("to", to, GRADE_FILES)
    require_known(options)
    if options.language is not None and not (to in SYSTEMS and SYSTEMS[to].speaks):
        raise OptionError(Message("terminal.no-headers"))
    if options.overwrite and to != WORKBOOK:
        raise OptionError(Message("terminal.no-overwrite"))
    if options.id_column and (to != WORKBOOK or options.into is None):
        raise OptionError(Message("terminal.no-id-column"))
    points = options.per_question or options.scale or options.maximum is not None
    if options.of_scale and (points or to != WORKBOOK or options.into is None):
        raise OptionError(Message("terminal.no-of-scale"))


def _list_wanting(marks: MarksFolder, place: Path, exam: ExamFolder | None) -> Iterator[Fault]:
    """What the marks themselves lack: points by hand, and the key as it is now, where the exam is
    not named.
    """
    yield from describe_unmarked(str(place), marks.open, marks.lacking)
    if exam is None:
        yield from find_later_keys([marks])


def _export_workbook(
    marks: MarksFolder, place: Path, exam: ExamFolder | None, *, force: bool
) -> Outcome:
    """One spreadsheet with everything, which is no file of another system."""
    from kinegrade.lms.workbook import workbook

    write_file(place, workbook(marks), "xlsx", force=force)
    return Outcome(place, (), tuple(_list_wanting(marks, place, exam)))


def _list_untold(grades: ClassGrades, place: Path) -> Iterator[Fault]:
    """That the points of questions do not show what is subtracted from totals, and which stand."""
    count = sum(bool(each.subtracted) for each in grades.students)
    if count:
        what = Message("terminal.untold", count=count)
        yield Fault(str(place), what, do=Message("terminal.export-totals"))
    kept = [each.student for each in grades.students if each.earlier]
    if kept:
        named = list_plainly([*map(Quoted, kept[:_NAMED]), *(["..."] if kept[_NAMED:] else [])])
        what = Message("terminal.untold-earlier", count=len(kept), students=named)
        yield Fault(str(place), what, do=Message("terminal.export-totals"))


def _list_above(grades: ClassGrades, options: ExportOptions) -> Iterator[Message]:
    """That some totals are above the maximum, by their bonus."""
    exported = () if options.per_question else grades.exported(ungraded=options.ungraded)
    above = sum(each.points[TOTAL] > each.out_of[TOTAL] for each in exported)
    if above:
        yield Message("terminal.above-maximum", count=above)


def _mention_scale(to: str, grades: ClassGrades, options: ExportOptions) -> Iterator[Message]:
    """That an office's workbook got points, where there are grades of a scale as well."""
    total = to == WORKBOOK and not options.per_question and not options.of_scale
    if total and any(each.scale_grade for each in grades.students):
        yield Message("terminal.points-not-grades")


@dataclass(frozen=True, slots=True)
class _Made:
    """The content of a file, how many students have a grade in it, and what is to be said of it."""

    system: Text
    content: bytes
    students: int
    complaints: tuple[Problem, ...]
    notes: tuple[Problem, ...] = ()
    kind: Kind = "grades"


def _make_file(to: str, grades: ClassGrades, options: ExportOptions) -> _Made:
    into = None if options.into is None else Path(options.into)
    if to == WORKBOOK and into is not None:
        from kinegrade.lms.grades.office.filling import fill_workbook

        filled = _say_filled(into.name, fill_workbook(grades, into, options))
        return replace(filled, kind="xlsx")
    dialect = SYSTEMS[to]
    if into is not None:
        return _say_filled(dialect.name, fill_in(dialect, grades, into, options))
    new = new_file(dialect, grades, options)
    complaints = tuple(complaint.fault for complaint in new.complaints)
    return _Made(dialect.name, new.text.encode(), new.students, complaints)


def _say_filled(system: Text, filled: Filled) -> _Made:
    complaints = tuple(complaint.fault for complaint in filled.complaints)
    return _Made(system, filled.content, filled.students, complaints, filled.notes)


def _tell(made: _Made, place: Path, grades: ClassGrades, options: ExportOptions) -> Part:
    """How many students were exported, and how many were not."""
    absent = len(grades.students) - len(grades.exported(ungraded=options.ungraded))
    exported = Message(
        "terminal.exported", file=str(place), count=made.students, system=made.system
    )
    if not absent:
        return exported
    return Message("terminal.left-alone", exported=exported, count=absent)


def _require_sense(options: ExportOptions, grades: ClassGrades) -> None:
    """Raises OptionError for a maximum that is not above zero, and for headers of items that are
    not exported.
    """
    if options.maximum is not None and options.maximum <= 0:
        raise OptionError(Message("terminal.maximum", text=Quoted(str(options.maximum))))
    partly = [
        name
        for name in grades.questions
        if any(name not in each.points for each in grades.students)
    ]
    if options.per_question and partly:
        raise OptionError(Message("terminal.alternatives", questions=list_plainly(partly)))
    if options.of_scale and not any(each.scale_grade for each in grades.students):
        raise OptionError(Message("terminal.no-grades-of-scale"))
    items = grades.questions if options.per_question else ("",)
    for item in options.columns:
        if item not in items:
            known = list_plainly(grades.questions)
            text = Quoted(f"{item}={options.columns[item]}")
            raise OptionError(Message("terminal.question-header", text=text, known=known))
