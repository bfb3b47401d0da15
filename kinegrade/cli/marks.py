"""The commands about answers and marks: grade, diff, report, feedback."""

from __future__ import annotations

from collections.abc import Iterable
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
    LANGUAGE,
    OPTIONAL_OUTPUT,
    OUTPUT,
    finish,
    finish_with_complaints,
    refusing,
)
from kinegrade.cli.running.opening import open_both
from kinegrade.cli.terminal import say, terminal_words
from kinegrade.language.catalogue import open_catalogue

if TYPE_CHECKING:
    from kinegrade.language import Language


def _list_sources() -> Iterable[str]:
    from kinegrade.lms.responses.detection import DIALECTS

    return DIALECTS


_EXAM_LANGUAGE = click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
)


@command()
@click.argument("exam", type=FILE)
@click.argument("answers", type=FILE, nargs=-1, required=True)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="MARKS",
)
@click.option(
    "--from",
    "source",
    type=LateChoice(_list_sources),
)
@click.option(
    "--encoding",
    metavar="NAME",
)
@click.option(
    "--unfinished",
    is_flag=True,
)
@click.option(
    "--decimal",
    type=click.Choice(["point", "comma"]),
)
@click.option(
    "--policy",
    type=FILE,
    metavar="FILE",
)
@click.option(
    "--manual",
    type=FILE,
    multiple=True,
    metavar="FILE",
)
@click.option(
    "--never-lower",
    type=FILE,
    metavar="MARKS",
)
@click.option("--since", type=FILE, metavar="MARKS")
@click.option("--reason", default="", metavar="TEXT")
@click.option(
    "--own-papers",
    is_flag=True,
)
@click.option("--pseudonymous", is_flag=True)
@FORCE
@refusing
def grade(
    *,
    exam: Path,
    answers: tuple[Path, ...],
    output: Path,
    never_lower: Path | None,
    since: Path | None,
    force: bool,
    **options: Any,
) -> None:
    """Mark the class by ANSWERS: EXAM/answers.csv filled in, or a download (CSV, xlsx).

    Several ANSWERS are one class: the quizzes of versions, or parts of the exam that several people
    typed.
    """
    from kinegrade.cli.running.shortlist import shorten_list
    from kinegrade.public.folders import expect_folders

    expect_folders((exam, "EXAM"), (never_lower, "MARKS"), (since, "MARKS"))
    earlier, logged = (
        None if marks is None else kinegrade.open_marks(marks, to_mark_again=True)
        for marks in (never_lower, since)
    )
    wishes = kinegrade.GradeOptions(never_lower=earlier, since=logged, assuming=say, **options)
    graded = kinegrade.grade(
        kinegrade.open_exam(exam), answers, output, force=force, options=wishes
    )
    for note in graded.notes:
        say(note)
    finish_with_complaints(shorten_list(graded.grades.complaints, output))


@command()
@click.argument("before", type=FILE, metavar="MARKS1")
@click.argument("after", type=FILE, metavar="MARKS2")
@OPTIONAL_OUTPUT
@LANGUAGE
@FORCE
@refusing
def diff(
    before: Path, after: Path, output: Path | None, language: Language, *, force: bool
) -> None:
    """Show how the marks in MARKS2 differ from those in MARKS1."""
    from kinegrade.grading.same_key import require_one_exam
    from kinegrade.public.folders import expect_folders
    from kinegrade.reports.comparison import compare
    from kinegrade.reports.comparison_writing import write_comparison_csv, write_comparison_text

    expect_folders((before, "MARKS"), (after, "MARKS"))
    first, second = kinegrade.open_marks(before), kinegrade.open_marks(after)
    require_one_exam(first, second)
    comparison = compare(first, second, second.former_ids)
    if output is not None:
        from kinegrade.files.output import write_file

        content = write_comparison_csv(comparison, open_catalogue(language))
        write_file(output, content, "csv", force=force)
    click.echo(write_comparison_text(comparison, terminal_words()))


@command("report")
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@OUTPUT
@click.option(
    "--ranks",
    is_flag=True,
)
@_EXAM_LANGUAGE
@FORCE
@refusing
def class_report(*, exam: Path, marks: Path, output: Path, **options: Any) -> None:
    """Report on the class: distribution, how hard each ask was, where points were lost, whether
    papers were alike.
    """
    folder, marked = open_both(exam, marks)
    finish(kinegrade.report(folder, marked, output, **options))


@command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FEEDBACK",
)
@click.option(
    "--format",
    "form",
    type=click.Choice(["pdf", "html", "md"]),
    default="pdf",
    show_default=True,
)
@click.option(
    "--solutions/--no-solutions",
    default=None,
)
@click.option(
    "--before-due",
    is_flag=True,
)
@click.option("--send-list", type=FILE, metavar="FILE")
@click.option("--moodle", type=FILE, metavar="WORKSHEET")
@_EXAM_LANGUAGE
@JOBS
@CLUSTER
@FORCE
@refusing
def feedback(
    *,
    exam: Path,
    marks: Path,
    output: Path,
    language: Language | None,
    force: bool,
    **options: Any,
) -> None:
    """Write each student a sheet: answers, right answers, what probably went wrong."""
    folder, marked = open_both(exam, marks)
    wishes = kinegrade.FeedbackOptions(**options)
    finish(
        kinegrade.feedback(folder, marked, output, language=language, force=force, options=wishes)
    )
