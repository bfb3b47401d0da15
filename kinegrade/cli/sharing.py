"""The command about answers that fit other students' papers: sharing."""

from __future__ import annotations

from pathlib import Path

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.options import FILE, FORCE, refusing


@click.command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="FILE", help="The CSV file to write."
)
@click.option(
    "--level",
    type=click.FloatRange(0, 100, min_open=True, max_open=True),
    default=1.0,
    show_default=True,
    metavar="PERCENT",
    help="How often a class without any sharing may give a pair by chance.",
)
@FORCE
@refusing
def sharing(exam: Path, marks: Path, output: Path, *, level: float, force: bool) -> None:
    """Find wrong answers that fit another student's paper, more of them than chance explains: a
    hint, no verdict.

    \b
    Example: kinegrade sharing EXAM MARKS -o sharing.csv
    """
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.files import write_file
    from kinegrade.grading.sharing import find_sharing
    from kinegrade.grading.sharing_report import write_sharing_csv, write_sharing_text
    from kinegrade.marks_folder.folder import open_marks

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    found = find_sharing(open_exam(exam), open_marks(marks), level / 100)
    write_file(output, write_sharing_csv(found), force=force)
    click.echo(write_sharing_text(found), err=True)
