"""What the commands share: options, refusals, complaints, progress."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import wraps
from math import ceil
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any

import click

from kinegrade.cli.option_types import LanguageChoice
from kinegrade.cli.terminal import refuse_value, say, terminal_words, write_line
from kinegrade.errors import KinegradeError, OutputError, Problem
from kinegrade.language.message import Message

if TYPE_CHECKING:
    from kinegrade.public.outcome import Outcome

#: Done, with complaints for a person to look at.
COMPLAINTS = 1
#: It cannot be done, and nothing was written.
FAILURE = 2
# Seconds between two lines on the progress of long work in a log.
BETWEEN_LINES = 30.0
# Papers come in parts, the first behind the time in which all is loaded and dealt
_LEAST_MEASURED = 5.0
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
LANGUAGE = click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
    default="en",
    show_default=True,
)
METHOD = click.option(
    "--method",
    type=click.Choice(["base-point", "projection", "pole"]),
)
CYCLE = click.option("--cycle", is_flag=True)
LARGE_PRINT = click.option("--large-print", is_flag=True)
JOBS = click.option(
    "--jobs",
    type=click.IntRange(1),
    default=lambda: os.cpu_count() or 1,
    metavar="N",
)
CLUSTER = click.option("--cluster", metavar="ADDRESS")
FORCE = click.option(
    "--force",
    is_flag=True,
)
ODD_IDS = click.option("--allow-odd-ids", is_flag=True)
FILE = click.Path(path_type=Path)
_OUTPUT = "-o", "--output"
OUTPUT = click.option(*_OUTPUT, type=FILE, required=True, metavar="FILE")


def _read_place(
    context: click.Context, parameter: click.Parameter, output: Path | None
) -> Path | None:
    """Where to write; None for standard output, which may be called `-`."""
    return None if output == Path("-") else output


OPTIONAL_OUTPUT = click.option(*_OUTPUT, type=FILE, metavar="FILE", callback=_read_place)


def require_writable(
    context: click.Context, parameter: click.Parameter, seed: str | None
) -> str | None:
    """A seed that can be written down and used again. Raises BadParameter for a blank one and for
    broken text.
    """
    if seed is not None and (
        not seed.strip() or any("\ud800" <= character <= "\udfff" for character in seed)
    ):
        raise refuse_value("--seed", Message("terminal.blank-seed"))
    return seed


def refusing(command: Callable[..., None]) -> Callable[..., None]:
    """A command whose refusals become one line each on standard error, and status 2."""

    @wraps(command)
    def run(*arguments: Any, **options: Any) -> None:
        from kinegrade.files.placing.readings import watching_readings
        from kinegrade.public.folders import expect_own_place

        try:
            with watching_readings(), _whole_output():
                if isinstance(output := options.get("output"), Path):
                    expect_own_place(output)
                command(*arguments, **options)
        except KinegradeError as error:
            for fault in error.faults:
                say(Message("grammar.error", problem=write_line(fault)))
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
        raise OutputError(full_output(fault)) from fault


def _log_progress(items: Iterator[Any], count: int) -> Iterator[Any]:
    """The items; where they take long, a line for some of them says how long the rest will take, by
    the pace since the first.
    """
    said, first = monotonic(), None
    for done, item in enumerate(items, 1):
        yield item
        now = monotonic()
        first = now if first is None else first
        measured = now - first
        if now - said >= BETWEEN_LINES and measured >= _LEAST_MEASURED and done < count:
            left = ceil(measured / (done - 1) * (count - done))
            rate = _write_rate(done - 1, measured)
            say(Message("terminal.progress-so-far", done=done, all=count, rate=rate, count=left))
            said = now


def _write_rate(done: int, seconds: float) -> str:
    """How many papers a minute."""
    return f"{60 * done / seconds:.3g}"


def full_output(fault: OSError) -> Message:
    """That standard output takes no more."""
    return Message("terminal.full-output", reason=str(fault.strerror))


def finish(outcome: Outcome) -> None:
    """Say on standard error what was done; with any complaints, end with status 1."""
    for note in outcome.notes:
        say(note)
    finish_with_complaints(outcome.complaints)


def finish_with_complaints(complaints: Sequence[Problem]) -> None:
    """Print complaints on standard error; with any, end with status 1."""
    for complaint in complaints:
        say(Message("grammar.complaint", complaint=write_line(complaint)))
    if complaints:
        sys.exit(COMPLAINTS)


def show_progress(items: Iterator[Any], count: int) -> Iterator[Any]:
    """The items with their progress on standard error: a line that is written anew in a terminal,
    now and then one more line in a log or in a terminal that cannot go back.
    """
    if not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield from _log_progress(items, count)
        return
    with click.progressbar(
        items, length=count, label=terminal_words().text("terminal.progress"), file=sys.stderr
    ) as bar:
        yield from bar
