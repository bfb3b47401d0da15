"""The command that puts an exam into a learning management system as a quiz: quiz."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.options import FILE, FORCE, METHOD, finish, progress, refusing

if TYPE_CHECKING:
    from kinegrade.lms.quiz.moodle_xml_questions import Form
    from kinegrade.problem.template import Language, Method

SYSTEMS = ("moodle-xml", "qti12", "qti21", "blackboard")


@click.command()
@click.argument("exam", type=FILE)
@click.option(
    "--to",
    "system",
    type=click.Choice(SYSTEMS),
    required=True,
    help="What takes the quiz: Moodle, Canvas (qti12), others by QTI 2.1, Blackboard's text upload.",
)
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE", help="The file to write.")
@click.option(
    "--variants",
    type=click.IntRange(1),
    metavar="K",
    help="K variants of every question for everybody, to be drawn from, instead of a paper for each student.",
)
@click.option(
    "--as",
    "form",
    type=click.Choice(["cloze", "numerical"]),
    default="cloze",
    show_default=True,
    help="For Moodle: a question for each mechanism, or for each number asked for.",
)
@click.option(
    "--mistakes/--no-mistakes",
    default=True,
    show_default=True,
    help="Whether answers that known mistakes lead to are told what went wrong.",
)
@click.option(
    "--mistake-credit",
    "credit",
    type=click.FloatRange(0, 100),
    metavar="PERCENT",
    help="What such an answer earns of its points.  [default: what the bank says, else 0]",
)
@click.option(
    "--solutions/--no-solutions",
    default=False,
    show_default=True,
    help="Whether the worked solutions are shown after the quiz.",
)
@METHOD
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "zh"]),
    help="Language of the quiz.  [default: that of the papers]",
)
@click.option(
    "--jobs",
    type=click.IntRange(1),
    metavar="N",
    help="How many processes work on a large class.  [default: one for each core]",
)
@FORCE
@refusing
def quiz(
    *,
    exam: Path,
    system: str,
    output: Path,
    variants: int | None,
    form: Form,
    mistakes: bool,
    credit: float | None,
    solutions: bool,
    method: Method | None,
    language: Language | None,
    jobs: int | None,
    force: bool,
) -> None:
    """Write the papers of EXAM as a quiz that a learning management system imports.

    \b
    Example: kinegrade quiz EXAM --to moodle-xml -o quiz.xml
    A pool:  kinegrade quiz EXAM --to moodle-xml --variants 20 -o pool.xml
    """
    from fractions import Fraction
    from functools import partial
    from os import cpu_count

    from kinegrade.exam.quiz import read_quiz
    from kinegrade.exam.quiz_paper import QuizWishes
    from kinegrade.lms.quiz.moodle_xml import write as write_moodle_xml
    from kinegrade.lms.quiz.writers import WRITERS

    expect_folders((exam, "EXAM"))
    wishes = QuizWishes(
        mistakes, None if credit is None else Fraction(str(credit)) / 100, solutions, method
    )
    written = read_quiz(
        exam,
        language,
        variants=variants,
        wishes=wishes,
        jobs=jobs or cpu_count() or 1,
        progress=progress,
    )
    writer = partial(write_moodle_xml, form=form) if system == "moodle-xml" else WRITERS[system]
    remarks = writer(written, output, force=force)
    click.echo(f"{output}: written; it gives the key away, for instructors only", err=True)
    click.echo(
        "marked there, every number stands alone: kinegrade grade on its responses knows follow-through",
        err=True,
    )
    finish(tuple(remarks))
