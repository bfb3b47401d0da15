"""The value of --column: what a column of a roster holds, and its title."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from kinegrade.cli.terminal import write_line
from kinegrade.language.message import Message, Quoted, list_choices

if TYPE_CHECKING:
    from kinegrade.exam.roster.columns import Wishes


def _read_columns(
    context: click.Context, parameter: click.Parameter, values: tuple[str, ...]
) -> Wishes:
    """The titles by what they hold. Raises BadParameter."""
    # Loads what reads tables, which most commands do not need
    from kinegrade.exam.roster.columns import COLUMNS

    titles = {}
    for value in values:
        name, equals, title = value.partition("=")
        column = next((each for each in COLUMNS if each == name.strip()), None)
        if column is None or not equals:
            known = list_choices(COLUMNS)
            what = Message("roster.not-a-column", text=Quoted(value), columns=known)
            raise click.BadParameter(write_line(what), context, parameter)
        titles[column] = title
    return titles


COLUMN = click.option(
    "--column",
    "columns",
    multiple=True,
    metavar="COLUMN=HEADER",
    callback=_read_columns,
)
