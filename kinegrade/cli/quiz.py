"""The command that puts an exam into a learning management system as a quiz: quiz."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.option_types import LanguageChoice, LateChoice
from kinegrade.cli.options import (
    CLUSTER,
    FILE,
    FORCE,
    JOBS,
    METHOD,
    OUTPUT,
    finish,
    refusing,
    show_progress,
)

if TYPE_CHECKING:
    from kinegrade.language import Language


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
@OUTPUT
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
@CLUSTER
@FORCE
@refusing
def quiz(
    *,
    exam: Path,
    system: str,
    output: Path,
    language: Language | None,
    credit: float | None,
    force: bool,
    **options: Any,
) -> None:
    """Write the papers of EXAM as a quiz that a learning management system imports."""
    share = None if credit is None else Fraction(str(credit)) / 100
    wishes = kinegrade.QuizOptions(credit=share, progress=show_progress, **options)
    folder = kinegrade.open_exam(exam)
    finish(
        kinegrade.quiz(folder, output, to=system, language=language, force=force, options=wishes)
    )
