"""A crash: a fault of kinegrade itself. One line for the user, and a file that can be sent to its
developers.

The file says where in the code it happened, and neither what the user typed nor the exception's
message: they may hold names, answers or secrets. They are shown only on the terminal.
"""

from __future__ import annotations

import os
import platform
import tempfile
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path

from kinegrade import __version__
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Message

_SHOWN = 200  # characters of the exception's message


def write_crash(fault: BaseException, arguments: Sequence[str]) -> Message:
    """The line for the terminal about a crash; writes the file that it names."""
    words = show_in_one_line(" ".join(str(fault).split()))[:_SHOWN]
    what = f"{type(fault).__name__}: {words}" if words else type(fault).__name__
    try:
        written = _write("\n".join(_write_report(fault, arguments)) + "\n")
    except OSError as refusal:
        report = Message("terminal.no-crash-report", reason=str(refusal.strerror))
    else:
        report = Message("terminal.crash-report", path=str(written))
    return Message("terminal.crash", what=what, report=report)


def _write(text: str) -> Path:
    """In the system's folder for temporary files, for the user's eyes only."""
    handle, name = tempfile.mkstemp(prefix="kinegrade-crash-", suffix=".txt")
    with os.fdopen(handle, "w", encoding="utf-8", errors="backslashreplace") as stream:
        stream.write(text)
    return Path(name)


def _write_report(fault: BaseException, arguments: Sequence[str]) -> Iterator[str]:
    yield f"kinegrade {__version__}, Python {platform.python_version()}, {platform.platform()}"
    yield f"command: {' '.join(_drop_values(arguments))}"
    seen: BaseException | None = fault
    while seen is not None:
        yield ""
        yield from _list_places(seen)
        seen = seen.__cause__ or seen.__context__


def _drop_values(arguments: Sequence[str]) -> Iterator[str]:
    """The command and the names of its options; whatever else was typed is a dot."""
    for place, argument in enumerate(arguments):
        option = argument.startswith("-") and len(argument) > 1 and not argument[1].isdigit()
        yield argument.split("=")[0] if option or place == 0 else "."


def _list_places(fault: BaseException) -> Iterator[str]:
    """The type of a fault and the lines of code that led to it; of a worker's fault, those in the
    worker.
    """
    yield type(fault).__name__
    yield from "".join(traceback.format_tb(fault.__traceback__)).splitlines()
    if type(fault).__name__ == "_RemoteTraceback":
        yield from (line for line in str(fault).splitlines() if line.startswith("  "))
