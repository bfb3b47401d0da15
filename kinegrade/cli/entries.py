"""The command about answers that were typed twice: compare-entries."""

from __future__ import annotations

import sys
from pathlib import Path

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import (
    COMPLAINTS,
    FILE,
    FORCE,
    OPTIONAL_OUTPUT,
    finish_with_complaints,
    refusing,
)
from kinegrade.cli.terminal import terminal_words
from kinegrade.errors import Problem
from kinegrade.language.message import Fault, Message


@command("compare-entries")
@click.argument("first", type=FILE, metavar="A")
@click.argument("second", type=FILE, metavar="B")
@click.argument("exam", type=FILE, required=False)
@OPTIONAL_OUTPUT
@FORCE
@refusing
def compare_entries(
    first: Path, second: Path, exam: Path | None, output: Path | None, *, force: bool
) -> None:
    """Compare two files into which the same answers were typed, cell by cell."""
    from kinegrade.public.folders import expect_folders
    from kinegrade.reports.double_entry import encode_agreed, write_double_entry_text

    expect_folders((exam, "EXAM"))
    folder = None if exam is None else kinegrade.open_exam(exam)
    compared = kinegrade.compare_entries(first, second, folder)
    click.echo(write_double_entry_text(compared, terminal_words()))
    complaints: list[Problem] = [complaint.fault for complaint in compared.complaints]
    if output is not None:
        if compared.differences or complaints:
            complaints.append(Fault(str(output), Message("marking.not-merged")))
        else:
            from kinegrade.files.output import write_file

            write_file(output, encode_agreed(compared), "csv", force=force)
    finish_with_complaints(complaints)
    if compared.differences:
        sys.exit(COMPLAINTS)
