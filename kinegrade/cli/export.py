"""The command that takes marks out: into the grade files of learning management systems, or into
one spreadsheet.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Literal, assert_never, get_args

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.options import FILE, FORCE, finish_with_complaints, refusing
from kinegrade.counting import count_in_words

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kinegrade.language import Language
    from kinegrade.lms.dialect import Dialect, ExportOptions, Field
    from kinegrade.lms.grades import ClassGrades
    from kinegrade.marks_folder.folder import MarksFolder

GradeSystem = Literal["moodle", "canvas", "blackboard", "brightspace", "sakai", "edx", "generic"]
SYSTEMS = (*get_args(GradeSystem), "xlsx")


@click.command()
@click.argument("marks", type=FILE)
@click.option(
    "--to",
    "system",
    type=click.Choice(SYSTEMS),
    required=True,
    help="The learning management system; generic is a plain sheet, xlsx a workbook to read.",
)
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE", help="The file to write.")
@click.option(
    "--into", type=FILE, metavar="DOWNLOAD", help="The system's own file, to be filled in."
)
@click.option(
    "--column",
    "columns",
    multiple=True,
    metavar="[QUESTION=]HEADER",
    help="The column to fill, by its header; once for each question with --per-question.",
)
@click.option("--title", default="", help="The item's title in the system.")
@click.option(
    "--per-question", is_flag=True, help="A column for each question in place of the total."
)
@click.option(
    "--feedback/--no-feedback",
    default=None,
    help="Points by question as a comment.  [default: where the system has a place for it]",
)
@click.option(
    "--ungraded",
    is_flag=True,
    help="Also grade those who handed in nothing; they are left alone otherwise.",
)
@click.option(
    "--by",
    type=click.Choice(["id", "login", "email"]),
    multiple=True,
    help="What the roster's ids are in the system, or email to go by addresses (with --exam).  "
    "[default: any that fits]",
)
@click.option(
    "--exam",
    type=FILE,
    metavar="EXAM",
    help="The exam folder, for its title and the e-mail addresses.",
)
@click.option("--scale", is_flag=True, help="Scale to the maximum that the file states.")
@click.option(
    "--maximum",
    metavar="NUMBER",
    help="What the item counts in the system; grades are scaled to it.",
)
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "zh"]),
    help="Language of the generic sheet's headers.  [default: that of the papers with --exam, else "
    "en]",
)
@FORCE
@refusing
def export(
    *,
    marks: Path,
    system: GradeSystem | Literal["xlsx"],
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
    """Write the grades of MARKS as a learning management system takes them.

    \b
    Example: kinegrade export MARKS --to moodle -o moodle.csv
    Filled:  kinegrade export MARKS --to canvas --into download.csv -o canvas.csv
    """
    from kinegrade.marks_folder.folder import open_marks

    if language is not None and system != "generic":
        raise click.UsageError(
            "--lang: only the generic sheet has headers that can be translated - leave it out"
        )
    expect_folders((marks, "MARKS"), (exam, "EXAM"))
    folder = open_marks(marks)
    if system == "xlsx":
        if into is not None:
            raise click.UsageError(
                "--into: a spreadsheet is written anew - leave it out, or choose a system"
            )
        _write_workbook(folder, output, force=force)
        return
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.lms.dialect import ExportOptions
    from kinegrade.lms.grades import read_grades

    grades = read_grades(folder, None if exam is None else open_exam(exam))
    named = _read_columns(columns, grades, per_question=per_question)
    most = _read_maximum(maximum)
    _write(
        _choose_dialect(system, language or grades.language),
        grades,
        into,
        output,
        ExportOptions(by, named, title.strip(), per_question, feedback, ungraded, scale, most),
        force=force,
    )


def _write_workbook(marks: MarksFolder, output: Path, *, force: bool) -> None:
    from kinegrade.files import write_file
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
    from kinegrade.files import write_file
    from kinegrade.lms.fill_in import fill_in
    from kinegrade.lms.from_scratch import new_file

    if into is None:
        fresh = new_file(dialect, grades, options)
        content, students, complaints = fresh.text.encode(), fresh.students, fresh.complaints
        notes: tuple[str, ...] = ()
    else:
        filled = fill_in(dialect, grades, into, options)
        content, students, complaints = filled.content, filled.students, filled.complaints
        notes = filled.notes
    write_file(output, content, force=force)
    for note in notes:
        click.echo(note, err=True)
    absent = len(grades.students) - len(grades.exported(ungraded=options.ungraded))
    left = (
        f"; {absent} handed in nothing and {'is' if absent == 1 else 'are'} left alone"
        if absent
        else ""
    )
    click.echo(
        f"{output}: grades of {count_in_words(students, 'student')} for {dialect.name}{left}",
        err=True,
    )
    finish_with_complaints(tuple(map(str, complaints)))


def _choose_dialect(system: GradeSystem, language: Language) -> Dialect:
    match system:
        case "moodle":
            from kinegrade.lms.moodle import MOODLE as dialect
        case "canvas":
            from kinegrade.lms.canvas import CANVAS as dialect
        case "blackboard":
            from kinegrade.lms.blackboard import BLACKBOARD as dialect
        case "brightspace":
            from kinegrade.lms.brightspace import BRIGHTSPACE as dialect
        case "sakai":
            from kinegrade.lms.sakai import SAKAI as dialect
        case "edx":
            from kinegrade.lms.edx import EDX as dialect
        case "generic":
            from kinegrade.lms.generic import generic

            dialect = generic(language)
        case _:
            assert_never(system)
    return dialect


def _read_columns(
    columns: tuple[str, ...], grades: ClassGrades, *, per_question: bool
) -> Mapping[str, str]:
    """Headers by question, or that of the total under "". Raises BadParameter."""
    if not per_question:
        if len(columns) > 1:
            raise click.BadParameter(
                "expected one for the total; several need --per-question", param_hint="--column"
            )
        return {"": columns[0]} if columns else {}
    found: dict[str, str] = {}
    for text in columns:
        question, sign, header = text.partition("=")
        if not sign or question not in grades.questions or question in found:
            known = ", ".join(grades.questions)
            raise click.BadParameter(
                f'"{text}": expected QUESTION=HEADER, once for each of {known}',
                param_hint="--column",
            )
        found[question] = header
    return found


def _read_maximum(text: str | None) -> Fraction | None:
    """A number above zero. Raises BadParameter."""
    from kinegrade.lms.item_columns import number

    value = None if text is None else number(text)
    if text is not None and not value:
        raise click.BadParameter(
            f'"{text}": expected a number above zero, like 10 or 12.5', param_hint="--maximum"
        )
    return value
