"""The command that puts an exam into a learning management system as a quiz: quiz."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.help import command
from kinegrade.cli.language_choice import LanguageChoice
from kinegrade.cli.late_choice import LateChoice
from kinegrade.cli.options import (
    FILE,
    FORCE,
    JOBS,
    METHOD,
    finish_with_complaints,
    refusing,
    show_progress,
)
from kinegrade.cli.terminal import say
from kinegrade.language.message import Message

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kinegrade.language import Language
    from kinegrade.lms.quiz.moodle.questions import Form
    from kinegrade.problem.template.template import Method


def _list_formats() -> Iterable[str]:
    from kinegrade.lms.quiz.formats import FORMATS

    return FORMATS


@command()
@click.argument("exam", type=FILE)
@click.option(
    "--to",
    "system",
    type=LateChoice(_list_formats),
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
    "--variants",
    type=click.IntRange(1),
    metavar="K",
)
@click.option(
    "--as",
    "form",
    type=click.Choice(["cloze", "numerical"]),
    default="cloze",
    show_default=True,
)
@click.option(
    "--split",
    "megabytes",
    type=click.FloatRange(0, min_open=True),
    metavar="MB",
)
@click.option(
    "--mistakes/--no-mistakes",
    default=True,
    show_default=True,
)
@click.option(
    "--mistake-credit",
    "credit",
    type=click.FloatRange(0, 100),
    metavar="PERCENT",
)
@click.option(
    "--solutions/--no-solutions",
    default=False,
    show_default=True,
)
@METHOD
@click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
)
@JOBS
@FORCE
@refusing
def quiz(
    *,
    exam: Path,
    system: str,
    output: Path,
    variants: int | None,
    form: Form,
    megabytes: float | None,
    mistakes: bool,
    credit: float | None,
    solutions: bool,
    method: Method | None,
    language: Language | None,
    jobs: int,
    force: bool,
) -> None:
    """Write the papers of EXAM as a quiz that a learning management system imports."""
    from fractions import Fraction

    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.quiz.paper import QuizWishes
    from kinegrade.exam.quiz.quiz import read_quiz
    from kinegrade.exam.quiz.variants import variants_stored
    from kinegrade.lms.quiz.formats import FileWishes, choose_writer
    from kinegrade.processes.executor import open_executor

    expect_folders((exam, "EXAM"))
    limit = None if megabytes is None else Fraction(str(megabytes))
    writer = choose_writer(system, FileWishes(form, limit))
    wishes = QuizWishes(
        mistakes, None if credit is None else Fraction(str(credit)) / 100, solutions, method
    )
    folder = open_exam(exam)
    with open_executor(jobs, "quiz") as workers:
        put = read_quiz(
            folder,
            language,
            variants=variants,
            wishes=wishes,
            workers=workers,
            progress=show_progress,
        )
        with variants_stored(folder, variants or 0):
            remarks = writer(put, output, force=force)
    say(Message("terminal.quiz-written", file=str(output)))
    say(Message("terminal.marked-there"))
    finish_with_complaints(tuple(remarks))
