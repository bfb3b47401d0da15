"""The commands for the time after the marks are known: explain."""

from __future__ import annotations

from pathlib import Path

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, refusing
from kinegrade.cli.running.opening import open_both
from kinegrade.cli.terminal import terminal_words


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
