"""The commands about who is in the class: roster, assign, exchange."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import kinegrade
from kinegrade.cli.column_choice import COLUMN
from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, ODD_IDS, finish, finish_with_complaints, refusing
from kinegrade.cli.terminal import terminal_words

if TYPE_CHECKING:
    from kinegrade.exam.roster.columns import Wishes


@command()
@click.argument("roster", type=FILE)
@COLUMN
@ODD_IDS
@refusing
def roster(roster: Path, *, columns: Wishes, allow_odd_ids: bool) -> None:
    """Show how ROSTER is read: which column is what, what is not used, how many students there are;
    nothing is written.
    """
    from kinegrade.exam.roster.overview import describe_roster

    students = kinegrade.Roster.read(roster, odd_ids=allow_odd_ids, columns=columns)
    words = terminal_words()
    for line in describe_roster(students):
        click.echo(words.write(line))
    finish_with_complaints([each.fault for each in students.complaints])


def person(function: Callable[..., None]) -> Callable[..., None]:
    """The options that say who a student is whom the roster does not list."""
    for option in ("--group", "--email", "--name"):
        function = click.option(option, default="")(function)
    return function


@command()
@click.argument("exam", type=FILE)
@click.argument("code")
@click.argument("student")
@person
@refusing
def assign(exam: Path, code: str, student: str, *, name: str, email: str, group: str) -> None:
    """Give the spare paper of EXAM that bears CODE to a STUDENT, by id, who has none."""
    folder = kinegrade.open_exam(exam)
    finish(kinegrade.assign(folder, code, student, name=name, email=email, group=group))


@command()
@click.argument("exam", type=FILE)
@click.argument("code")
@click.argument("student")
@person
@click.option("--new-id", is_flag=True)
@click.option("--drop-pool", is_flag=True)
@refusing
def exchange(exam: Path, code: str, student: str, **wishes: Any) -> None:
    """Give the paper of EXAM that bears CODE to a STUDENT who wrote it in place of the own one."""
    options = kinegrade.ExchangeOptions(**wishes)
    finish(kinegrade.exchange(kinegrade.open_exam(exam), code, student, options=options))
