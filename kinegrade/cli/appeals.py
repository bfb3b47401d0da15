"""The commands for the time after the marks are known: explain, merge, forget."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, FORCE, finish, refusing
from kinegrade.cli.running.opening import open_both
from kinegrade.cli.terminal import say, terminal_words
from kinegrade.language.message import Message, list_plainly


@command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.argument("student")
@click.argument("question", default="", metavar="[QUESTION[.ASK]]")
@refusing
def explain(exam: Path, marks: Path, student: str, question: str) -> None:
    """Say why the answers of a STUDENT, or one of them, got the points they have in MARKS."""
    from kinegrade.exam.exam_wording import read_nearest_wording
    from kinegrade.reports.explanation.explanation import explain_marks
    from kinegrade.reports.explanation.text import ExplanationWriter

    words = terminal_words()
    folder, marked = open_both(exam, marks)
    explanation = explain_marks(folder, marked, student, question)
    wording = read_nearest_wording(folder, words.language)
    click.echo(ExplanationWriter(explanation, wording, words).write(folder))


@command()
@click.argument("folders", type=FILE, nargs=-1, required=True, metavar="MARKS...")
@click.option("-o", "--output", type=FILE, required=True, metavar="ALL")
@click.option("--prefer", type=click.Choice(["first", "last", "better"]))
@FORCE
@refusing
def merge(
    folders: tuple[Path, ...],
    *,
    output: Path,
    prefer: Literal["first", "last", "better"] | None,
    force: bool,
) -> None:
    """Put the MARKS of a make-up exam together with those of the exam."""
    from kinegrade.public.folders import expect_folders
    from kinegrade.public.merging import merge_marks

    expect_folders(*((each, "MARKS") for each in folders))
    marked = [kinegrade.open_marks(each) for each in folders]
    finish(merge_marks(marked, output, prefer, force=force))


@command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE, nargs=-1, metavar="[MARKS]...")
@click.option("--yes", is_flag=True)
@refusing
def forget(exam: Path, marks: tuple[Path, ...], *, yes: bool) -> None:
    """Remove all people from EXAM and MARKS for ever, and keep what statistics need."""
    from kinegrade.exam.archiving.forgetting import (
        Forgetting,
        require_all_marks,
        require_people,
    )
    from kinegrade.grading.exams_beside import list_marks_beside
    from kinegrade.grading.same_key import require_same_exam
    from kinegrade.public.folders import expect_folders

    expect_folders((exam, "EXAM"), *((each, "MARKS") for each in marks))
    opened = tuple(kinegrade.open_marks(each) for each in marks)
    folder = kinegrade.open_exam(exam)
    require_people(folder)
    for marked in opened:
        require_same_exam(folder, marked)
    named = {each.path.resolve() for each in opened}
    left = [each.path for each in list_marks_beside(folder) if each.path.resolve() not in named]
    if yes:
        require_all_marks(folder, left)
    forgetting = Forgetting(folder, opened)
    if yes:
        say(Message("archive.forgotten", exam=str(exam), count=forgetting.forget()))
        return
    removed = list_plainly(forgetting.list_removed())
    say(Message("archive.would-remove", exam=str(exam), files=removed))
    say(Message("archive.would-blank", exam=str(exam)))
    for each in marks:
        say(Message("archive.would-blank-marks", marks=str(each)))
    for path in left:
        say(Message("archive.marks-left", marks=str(path)))
    say(Message("archive.add-yes"))
