"""Commands that tests run in this process work in it alone, unless a test says how many processes
it wants: each core has tests of its own to run, and further processes would find anew what this one
keeps. What tests start as a program of its own, and `make prove`, takes all cores as users do.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import click

from kinegrade.cli import main
from tests.by_hand import school
from tests.small_class import kinegrade


def work_in_one_process() -> None:
    """Let `--jobs` be 1 where it is not given, and let the school hand its commands in here."""
    for option in list_options(main, "jobs"):
        option.default = 1
    school.run = _run_here


def _run_here(command: Sequence[str]) -> tuple[int, str]:
    """The status of a command in this process, and what it says of faults."""
    result = kinegrade(*command)
    return result.exit_code, result.stderr


def list_options(command: click.Command, name: str) -> Iterator[click.Parameter]:
    """The options of that name of a command and of those below it."""
    yield from (each for each in command.params if each.name == name)
    if isinstance(command, click.Group):
        for below in command.commands.values():
            yield from list_options(below, name)
