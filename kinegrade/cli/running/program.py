"""The command line as a process: how it ends, and what a shell can read from its status.

`kinegrade` and `python -m kinegrade` call `Program`. 0 is fine, 1 done with complaints, 2 cannot be
done; whatever else ends a run is none of these: a fault of kinegrade is 70, and a signal 128 and
its number, as shells count.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from copy import copy
from functools import partial
from typing import Any, NoReturn

import click

from kinegrade.cli.help import read_help
from kinegrade.cli.options import FAILURE, FULL, full_output
from kinegrade.cli.running.signals import BY_SIGNAL, Signalled, signals_obeyed
from kinegrade.cli.terminal import say
from kinegrade.language.message import Message, Part

#: A fault in kinegrade; one line names a report that can be sent, without names of students.
CRASH = 70  # EX_SOFTWARE of sysexits.h
#: What was to read the output no longer does, as after `| head`.
CLOSED_PIPE = BY_SIGNAL + 13  # as if SIGPIPE had ended it, which Windows does not have


class _ClosedPipe(Exception):
    """What this process writes is no longer read, as after `| head`."""


class Program(click.Group):
    """The group of all commands. Called, it ends the process; its method `main` leaves that to
    tests, as in click.
    """

    def __call__(self, *arguments: Any, **options: Any) -> NoReturn:
        """Run the command that the process was started with, and exit with its status."""
        status = _run_to_status(partial(self.main, *arguments, standalone_mode=False, **options))
        gc.freeze()  # as it ends, Python would look for cycles in all of it three times
        sys.exit(status)

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what the program does."""
        described = copy(self)
        described.help = read_help("main")
        super(Program, described).format_help_text(ctx, formatter)

    def make_context(self, *arguments: Any, **options: Any) -> click.Context:
        """Read the arguments, which may print the help."""
        with _not_for_click():
            return super().make_context(*arguments, **options)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command."""
        with _not_for_click():
            return super().invoke(ctx)


class _UnexpectedEnd(Exception):
    """Some data ended where that was not expected."""


@contextmanager
def _not_for_click() -> Iterator[None]:
    """click takes a closed pipe for status 1, which here means complaints, and the end of any data
    for Ctrl-C.
    """
    try:
        yield
    except BrokenPipeError as fault:
        raise _ClosedPipe from fault
    except EOFError as fault:
        raise _UnexpectedEnd from fault


def _run_to_status(run: Callable[[], object]) -> int:
    """The exit status of a run; anything to report about its end goes to standard error, in one
    line.
    """
    try:
        with signals_obeyed():
            return _run_to_end(run)
    except Signalled as ending:
        _report_signal(ending.number)
        return BY_SIGNAL + ending.number
    except (_ClosedPipe, BrokenPipeError):
        _discard_output()
        return CLOSED_PIPE
    except click.Abort:
        return BY_SIGNAL + signal.SIGINT
    except _UnexpectedEnd as fault:
        return _report_crash(fault.__cause__ or fault)
    except OSError as fault:
        if fault.errno not in FULL or fault.filename is not None:
            return _report_crash(fault)
        _echo(Message("grammar.error", problem=full_output(fault)))
        _discard_output()
        return FAILURE
    except Exception as fault:
        return _report_crash(fault)


def _run_to_end(run: Callable[[], object]) -> int:
    """The status of a run that ends by itself. Raises what it raises otherwise."""
    status: object = 0
    try:
        run()
    except SystemExit as ending:
        status = ending.code
    except click.ClickException as fault:
        fault.show()
        status = FAILURE
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()
    return status if isinstance(status, int) else 0


def _report_crash(fault: BaseException) -> int:
    from kinegrade.cli.running.crash import write_crash  # what it loads would slow every start

    _echo(write_crash(fault, sys.argv[1:]))
    return CRASH


def _report_signal(number: int) -> None:
    name = signal.Signals(number).name
    interrupted = number == signal.SIGINT
    _echo(
        Message("terminal.interrupted", name=name)
        if interrupted
        else Message("terminal.ended", name=name)
    )


def _echo(what: Part) -> None:
    """A last line on standard error, if it can still be written."""
    with suppress(OSError):
        say(what)


def _discard_output() -> None:
    """Discard what is still to be written, or Python would complain about it when it ends."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in filter(None, (sys.stdout, sys.stderr)):
        try:
            stream.flush()
        except OSError:
            with suppress(OSError):
                os.dup2(nowhere, stream.fileno())
