"""One case: a seed chooses a door and damages its file; the command may refuse or complain, and
nothing else.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from types import FrameType

from click.testing import CliRunner, Result

from kinegrade.cli import main
from tests.fuzz.accounting import unaccounted
from tests.fuzz.doors import DOORS, Door, copy_material, damage

SECONDS = 10
_PLACE = re.compile(r'File "[^"]*/(kinegrade/[^"]+)", line (\d+), in (\w+)')


class Hang(BaseException):
    """A command took too long; no `Exception`, or code that survives faults would survive it."""


def fault_of_case(seed: int, material: Path, folder: Path) -> str:
    """What is wrong with the end of the case of that seed, "" where all is well; it runs in a new
    folder, which is removed again.
    """
    chance = Random(seed)
    door = DOORS[seed % len(DOORS)]
    copy_material(material, folder)
    damage(chance, folder / door.file)
    here = Path.cwd()
    os.chdir(folder)
    try:
        with _limited():
            result = CliRunner().invoke(main, list(door.command))
        fault = _fault(door, folder, result)
    except Hang as hang:
        fault = f"hang: {_place(hang)}"
    finally:
        os.chdir(here)
        shutil.rmtree(folder, ignore_errors=True)
    return f"{door.name}: {fault}" if fault else ""


def _fault(door: Door, folder: Path, result: Result) -> str:
    """What is wrong with the end of a command."""
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        return f"crash: {type(result.exception).__name__} {_place(result.exception)}"
    if result.exit_code not in (0, 1, 2):
        return f"status {result.exit_code}"
    if result.exit_code == 2:
        return _refusal_fault(folder, result)
    lost = unaccounted(door, folder, result.output)
    return f"lost: {', '.join(lost[:3])}" if lost else ""


def _refusal_fault(folder: Path, result: Result) -> str:
    if not any(line.startswith(("error: ", "Error: ")) for line in result.stderr.splitlines()):
        return f"a refusal that does not say what is wrong: {result.stderr[:80]!r}"
    return "half-written output" if (folder / "OUT").exists() else ""


def _place(fault: BaseException) -> str:
    """The last place in kinegrade's code that a fault went through."""
    found = _PLACE.findall("".join(traceback.format_exception(fault)))
    return f"{found[-1][0]}:{found[-1][1]} {found[-1][2]}" if found else "outside kinegrade"


@contextmanager
def _limited() -> Iterator[None]:
    """Raise Hang in the block after some seconds."""

    def end(number: int, frame: FrameType | None) -> None:
        raise Hang

    usual = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, usual)
