"""The command that takes marks out: into the grade files of learning management systems, or into
one spreadsheet.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.help import command
from kinegrade.cli.language_choice import LanguageChoice
from kinegrade.cli.late_choice import LateChoice
from kinegrade.cli.options import FILE, FORCE, finish_with_complaints, refusing
from kinegrade.cli.terminal import refuse_usage, refuse_value, say
from kinegrade.language.message import Message, Quoted, list_plainly

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from kinegrade.errors import Problem
    from kinegrade.language import Language
    from kinegrade.lms.grades.dialect import Dialect, ExportOptions, Field
    from kinegrade.lms.grades.grades import ClassGrades
    from kinegrade.marks_folder.folder import MarksFolder

_WORKBOOK = "xlsx"  # no system's file: everything in one spreadsheet


def _list_systems() -> Iterable[str]:
    from kinegrade.lms.grades.systems import SYSTEMS

    return (*SYSTEMS, _WORKBOOK)


@command()
@click.argument("marks", type=FILE)
@click.option(
    "--to",
    "system",
    type=LateChoice(_list_systems),
    required=True,
)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FILE",
)
@click.option(
    "--into",
    type=FILE,
    metavar="DOWNLOAD",
)
@click.option(
    "--column",
    "columns",
    multiple=True,
    metavar="[QUESTION=]HEADER",
)
@click.option(
    "--title",
    default="",
)
@click.option(
    "--per-question",
    is_flag=True,
)
@click.option(
    "--feedback/--no-feedback",
    default=None,
)
@click.option(
    "--ungraded",
    is_flag=True,
)
@click.option(
    "--by",
    type=click.Choice(["id", "login", "email"]),
    multiple=True,
)
@click.option(
    "--exam",
    type=FILE,
    metavar="EXAM",
)
@click.option(
    "--scale",
    is_flag=True,
)
@click.option(
    "--maximum",
    metavar="NUMBER",
)
@click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
)
@FORCE
@refusing
def export(
    *,
    marks: Path,
    system: str,
    output: Path,
    into: Path | None,
    columns: tuple[str, ...],
    title: str,
    per_question: bool,
    feedback: bool | None,
    ungraded: bool,
    by: tuple[Field, ...],
    exam: Path | None,
    scale: bool,
    maximum: str | None,
    language: Language | None,
    force: bool,
) -> None:
    """Write the grades of MARKS as a learning management system takes them."""
    from kinegrade.lms.grades.systems import SYSTEMS
    from kinegrade.marks_folder.folder import open_marks

    dialect = None if system == _WORKBOOK else SYSTEMS[system]
    if language is not None and not (dialect and dialect.speaks):
        raise refuse_usage(Message("terminal.no-headers"))
    expect_folders((marks, "MARKS"), (exam, "EXAM"))
    folder = open_marks(marks)
    if dialect is None:
        if into is not None:
            raise refuse_usage(Message("terminal.no-into"))
        _write_workbook(folder, output, force=force)
        return
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.lms.grades.dialect import ExportOptions
    from kinegrade.lms.grades.grades import read_grades

    grades = read_grades(folder, None if exam is None else open_exam(exam))
    named = _read_columns(columns, grades, per_question=per_question)
    most = _read_maximum(maximum)
    _write(
        dialect,
        grades,
        into,
        output,
        ExportOptions(
            by, named, title.strip(), per_question, feedback, ungraded, scale, most, language
        ),
        force=force,
    )


def _write_workbook(marks: MarksFolder, output: Path, *, force: bool) -> None:
    from kinegrade.files.output import write_file
    from kinegrade.lms.workbook import workbook

    write_file(output, workbook(marks), force=force)


def _write(
    dialect: Dialect,
    grades: ClassGrades,
    into: Path | None,
    output: Path,
    options: ExportOptions,
    *,
    force: bool,
) -> None:
    from kinegrade.files.output import write_file
    from kinegrade.lms.grades.fill_in import fill_in
    from kinegrade.lms.grades.from_scratch import new_file

    if into is None:
        fresh = new_file(dialect, grades, options)
        content, students, complaints = fresh.text.encode(), fresh.students, fresh.complaints
        notes: tuple[Problem, ...] = ()
    else:
        filled = fill_in(dialect, grades, into, options)
        content, students, complaints = filled.content, filled.students, filled.complaints
        notes = filled.notes
    write_file(output, content, force=force)
    for note in notes:
        say(note)
    absent = len(grades.students) - len(grades.exported(ungraded=options.ungraded))
    exported = Message("terminal.exported", file=str(output), count=students, system=dialect.name)
    say(Message("terminal.left-alone", exported=exported, count=absent) if absent else exported)
    finish_with_complaints([complaint.fault for complaint in complaints])


def _read_columns(
    columns: tuple[str, ...], grades: ClassGrades, *, per_question: bool
) -> Mapping[str, str]:
    """Headers by question, or that of the total under "". Raises BadParameter."""
    if not per_question:
        if len(columns) > 1:
            raise refuse_value("--column", Message("terminal.one-column"))
        return {"": columns[0]} if columns else {}
    found: dict[str, str] = {}
    for text in columns:
        question, sign, header = text.partition("=")
        if not sign or question not in grades.questions or question in found:
            known = list_plainly(grades.questions)
            raise refuse_value(
                "--column", Message("terminal.question-header", text=Quoted(text), known=known)
            )
        found[question] = header
    return found


def _read_maximum(text: str | None) -> Fraction | None:
    """A number above zero. Raises BadParameter."""
    from kinegrade.lms.grades.item_columns import number

    value = None if text is None else number(text)
    if text is not None and not value:
        raise refuse_value("--maximum", Message("terminal.maximum", text=Quoted(text)))
    return value
