"""What a killed process leaves behind: recognised by its name, and removed by the next process on
the same machine.
"""

from __future__ import annotations

import os
import re
import secrets
import shutil
import socket
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

_LEFT = "left"  # in a name in place of the process: it has left this to others


def make_process_name(beginning: str) -> str:
    """A new name that states which process on which machine uses it: BEGINNING-HOST-PID-TOKEN."""
    return f"{_find_process(beginning)}{os.getpid()}-{secrets.token_hex(4)}"


def clear_leftovers(folder: Path, beginning: str) -> None:
    """Remove what ended processes left in the folder under such names. Raises OSError."""
    for entry in list(list_leftovers(folder, beginning)):
        remove(entry)


def list_leftovers(folder: Path, beginning: str) -> Iterator[Path]:
    """What ended processes of this machine left in the folder under such names. Raises OSError."""
    shape = re.compile(re.escape(_find_process(beginning)) + rf"([0-9]+|{_LEFT})-[0-9a-f]{{8}}")
    for entry in folder.iterdir():
        found = shape.fullmatch(entry.name)
        if found and (found.group(1) == _LEFT or not _is_running(int(found.group(1)))):
            yield entry


def leave(entry: Path, beginning: str) -> None:
    """Leave what this process has begun to others, or to itself later. Raises OSError."""
    entry.rename(entry.with_name(f"{_find_process(beginning)}{_LEFT}-{secrets.token_hex(4)}"))


def list_in_use(folder: Path, beginning: str) -> list[Path]:
    """What stands in the folder under such names, and may be in use: by a process that runs, or
    on another machine. Raises OSError.
    """
    shape = re.compile(re.escape(beginning) + r"-\w+-[0-9]+-[0-9a-f]{8}")
    left = set(list_leftovers(folder, beginning))
    return [each for each in folder.iterdir() if shape.fullmatch(each.name) and each not in left]


def remove(entry: Path) -> None:
    """Remove a file or a folder, also one of protected folders, as far as that is possible."""
    with suppress(OSError):  # even whether it is a folder cannot be asked of a name of 300 letters
        if entry.is_dir() and not entry.is_symlink():
            shutil.rmtree(entry, ignore_errors=True)
            if entry.exists():
                _take_protection_away(entry)
                shutil.rmtree(entry, ignore_errors=True)
        else:
            entry.unlink()


def _take_protection_away(folder: Path) -> None:
    """All folders in it, and itself, can be emptied by their owner."""
    folder.chmod(0o700)
    for place, names, _ in os.walk(folder):
        for inner in (Path(place, name) for name in names):
            if not inner.is_symlink():
                inner.chmod(0o700)


def _find_process(beginning: str) -> str:
    return f"{beginning}-{re.sub(r'[^A-Za-z0-9]', '_', socket.gethostname())}-"


def _is_running(process: int) -> bool:
    if os.name == "nt":  # asking by signal 0 would interrupt the process there: leftovers stay
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True
