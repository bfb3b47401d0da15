"""The command that sets several sheets of one bank: series."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import kinegrade
from kinegrade.cli.column_choice import COLUMN
from kinegrade.cli.help import command
from kinegrade.cli.options import (
    FILE,
    JOBS,
    LANGUAGE,
    ODD_IDS,
    finish_with_complaints,
    refusing,
    require_writable,
    show_progress,
)
from kinegrade.cli.terminal import refuse_value, say, write_line
from kinegrade.errors import FieldError, Problem
from kinegrade.language.message import Message

if TYPE_CHECKING:
    from kinegrade.exam.roster.columns import Wishes

_MOST_SHEETS, _MOST_DAYS = 60, 365


def _read_due(
    context: click.Context, parameter: click.Parameter, text: str | None
) -> datetime | None:
    """A date with a time. Raises BadParameter."""
    from kinegrade.deadlines.moment import read_moment

    try:
        return None if text is None else read_moment(text)
    except FieldError as error:
        said = Message("terminal.due", fault=write_line(error.faults[0]))
        raise refuse_value("--due", said) from error


@command()
@click.argument("bank", type=FILE)
@click.argument("roster", type=FILE)
@click.option("--sheets", type=click.IntRange(1, _MOST_SHEETS), required=True, metavar="N")
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="DIR",
)
@click.option("--due", callback=_read_due, metavar="WHEN")
@click.option(
    "--every",
    type=click.IntRange(1, _MOST_DAYS),
    default=7,
    show_default=True,
    metavar="DAYS",
)
@click.option(
    "--reproducible",
    callback=require_writable,
    metavar="WORDS",
)
@click.option(
    "--avoid",
    type=FILE,
    multiple=True,
    metavar="EXAM",
)
@LANGUAGE
@click.option("--paper-size", type=click.Choice(["a4", "letter"]), default="a4", show_default=True)
@JOBS
@COLUMN
@ODD_IDS
@refusing
def series(
    *,
    bank: Path,
    roster: Path,
    sheets: int,
    output: Path,
    due: datetime | None,
    every: int,
    language: str,
    columns: Wishes,
    allow_odd_ids: bool,
    **options: Any,
) -> None:
    """Set several sheets of homework of one BANK, each an exam folder below DIR, without repeats:
    nobody gets numbers that anybody had on another sheet.
    """
    from kinegrade.exam.generating.series import SeriesPlan, describe_kept, plan_sheets

    students = kinegrade.Roster.read(roster, odd_ids=allow_odd_ids, columns=columns)
    wishes = kinegrade.GenerateOptions(progress=show_progress, **options)
    complaints: list[Problem] = []
    output.mkdir(parents=True, exist_ok=True)
    for sheet in plan_sheets(bank, output, SeriesPlan(sheets, due, timedelta(days=every))):
        if sheet.exists:
            for line in describe_kept(sheet, students):
                say(line)
            continue
        written = kinegrade.generate(
            kinegrade.Bank(sheet.blueprint),
            students,
            sheet.folder,
            language=language,
            options=sheet.adapt(wishes),
        )
        for note in written.notes:
            say(note)
        complaints += written.complaints
    finish_with_complaints(complaints)
