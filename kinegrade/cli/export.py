"""The command that takes marks out: into the grade files of learning management systems, or into
one spreadsheet.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.option_types import LanguageChoice, LateChoice
from kinegrade.cli.options import FILE, FORCE, OUTPUT, finish, refusing
from kinegrade.cli.terminal import refuse_value
from kinegrade.language.message import Message, Quoted, list_plainly


def _list_files() -> Iterable[str]:
    from kinegrade.lms.grades.systems import GRADE_FILES

    return GRADE_FILES


@command()
@click.argument("marks", type=FILE)
@click.option(
    "--to",
    "system",
    type=LateChoice(_list_files),
    required=True,
)
@OUTPUT
@click.option(
    "--into",
    type=FILE,
    metavar="DOWNLOAD",
)
@click.option(
    "--overwrite",
    is_flag=True,
)
@click.option(
    "--id-column",
    default="",
    metavar="HEADER",
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
    "--of-scale",
    is_flag=True,
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
    exam: Path | None,
    columns: tuple[str, ...],
    maximum: str | None,
    force: bool,
    **options: Any,
) -> None:
    """Write the grades of MARKS as a learning management system takes them."""
    from kinegrade.public.folders import expect_folders

    expect_folders((marks, "MARKS"), (exam, "EXAM"))
    marked = kinegrade.open_marks(marks)
    known = marked.totals.questions if options["per_question"] else ()
    headers = _read_columns(columns, known)
    wishes = kinegrade.ExportOptions(columns=headers, maximum=_read_maximum(maximum), **options)
    folder = None if exam is None else kinegrade.open_exam(exam)
    finish(kinegrade.export(marked, output, to=system, exam=folder, force=force, options=wishes))


def _read_columns(columns: tuple[str, ...], questions: tuple[str, ...]) -> Mapping[str, str]:
    """Headers by question, or that of the total under "" where there are no questions. Raises
    BadParameter.
    """
    if not questions:
        if len(columns) > 1:
            raise refuse_value("--column", Message("terminal.one-column"))
        return {"": columns[0]} if columns else {}
    found: dict[str, str] = {}
    for text in columns:
        question, sign, header = text.partition("=")
        if not sign or question in found:
            known = list_plainly(questions)
            expected = Message("terminal.question-header", text=Quoted(text), known=known)
            raise refuse_value("--column", expected)
        found[question] = header
    return found


def _read_maximum(text: str | None) -> Fraction | None:
    """A number above zero. Raises BadParameter."""
    from kinegrade.lms.grades.item_candidates import number

    value = None if text is None else number(text)
    if text is not None and not value:
        raise refuse_value("--maximum", Message("terminal.maximum", text=Quoted(text)))
    return value
