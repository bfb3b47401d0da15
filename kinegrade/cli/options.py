"""What the commands share: options, refusals, complaints, progress."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import wraps
from pathlib import Path
from typing import Any

import click

from kinegrade.cli.folders import expect_own_place
from kinegrade.errors import KinegradeError, OutputError
from kinegrade.language import LANGUAGES
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import choose_terminal_language

COMPLAINTS = 1
FAILURE = 2
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
LANGUAGE = click.option(
    "--lang",
    "language",
    type=click.Choice(LANGUAGES),
    default="en",
    show_default=True,
    help="Language of the output.",
)
METHOD = click.option(
    "--method",
    type=click.Choice(["base-point", "projection", "pole"]),
    help="How worked solutions find velocities where several methods serve.  "
    "[default: what the template says]",
)
JOBS = click.option(
    "--jobs",
    type=click.IntRange(1),
    default=lambda: os.cpu_count() or 1,
    metavar="N",
    help="How many processes work.  [default: one for each core]",
)
FORCE = click.option("--force", is_flag=True, help="Replace an output that kinegrade wrote before.")
FILE = click.Path(path_type=Path)


def require_writable(
    context: click.Context, parameter: click.Parameter, seed: str | None
) -> str | None:
    """A seed that can be written down and used again. Raises BadParameter for a blank one and for
    broken text.
    """
    if seed is not None and (
        not seed.strip() or any("\ud800" <= character <= "\udfff" for character in seed)
    ):
        raise click.BadParameter("expected some text, like spring-2026")
    return seed


def refusing(command: Callable[..., None]) -> Callable[..., None]:
    """A command whose refusals become one line each on standard error, and status 2."""

    @wraps(command)
    def run(*arguments: Any, **options: Any) -> None:
        try:
            with _whole_output():
                if isinstance(output := options.get("output"), Path):
                    expect_own_place(output)
                command(*arguments, **options)
        except KinegradeError as error:
            words = open_catalogue(choose_terminal_language())
            for fault in error.faults:
                line = words.text("grammar.error", problem=" ".join(words.write(fault).split()))
                click.echo(line, err=True)
            sys.exit(FAILURE)

    return run


@contextmanager
def _whole_output() -> Iterator[None]:
    """What is printed on standard output inside arrives, or OutputError is raised: a full disk does
    not truncate it silently. A closed pipe is not such a fault.
    """
    try:
        try:
            yield
        finally:
            if sys.stdout is not None:  # as after >&-
                sys.stdout.flush()
    except OSError as fault:
        if fault.errno not in FULL or fault.filename is not None:
            raise
        # What is left in the buffer would fail again at the end
        with suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise OutputError(
            f"standard output: cannot be written ({fault.strerror}) - expected a place with room - "
            "send it elsewhere"
        ) from fault


def finish_with_complaints(complaints: tuple[str, ...]) -> None:
    """Print complaints on standard error; with any, end with status 1."""
    for complaint in complaints:
        click.echo(f"complaint: {' '.join(complaint.split())}", err=True)
    if complaints:
        sys.exit(COMPLAINTS)


def show_progress(items: Iterator[Any], count: int) -> Iterator[Any]:
    """The items with a progress bar on standard error, when that is a terminal."""
    if not sys.stderr.isatty():
        yield from items
        return
    with click.progressbar(items, length=count, label="papers", file=sys.stderr) as bar:
        yield from bar
