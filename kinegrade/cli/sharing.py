"""The command about answers that fit other students' papers: sharing."""

from __future__ import annotations

from pathlib import Path

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, FORCE, OUTPUT, refusing
from kinegrade.cli.running.opening import open_both
from kinegrade.cli.terminal import say


@command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@OUTPUT
@click.option(
    "--level",
    type=click.FloatRange(0, 100, min_open=True, max_open=True),
    default=1.0,
    show_default=True,
    metavar="PERCENT",
)
@FORCE
@refusing
def sharing(exam: Path, marks: Path, output: Path, *, level: float, force: bool) -> None:
    """Find wrong answers that fit another student's paper, more of them than chance explains: a
    hint, no verdict.
    """
    from kinegrade.files.output import write_file
    from kinegrade.reports.sharing.report import describe_sharing, write_sharing_csv
    from kinegrade.reports.sharing.sharing import find_sharing

    folder, marked = open_both(exam, marks)
    found = find_sharing(folder, marked, level / 100)
    write_file(output, write_sharing_csv(found, folder.language), "csv", force=force)
    for sentence in describe_sharing(found):
        say(sentence)
