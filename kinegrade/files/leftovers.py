"""What a killed process leaves behind: recognised by its name, and removed by the next process on
the same machine.
"""

from __future__ import annotations

import os
import re
import secrets
import shutil
import socket
from contextlib import suppress
from pathlib import Path


def make_process_name(beginning: str) -> str:
    """A new name that states which process on which machine uses it: BEGINNING-HOST-PID-TOKEN."""
    return f"{_find_process(beginning)}{os.getpid()}-{secrets.token_hex(4)}"


def clear_leftovers(folder: Path, beginning: str) -> None:
    """Remove what ended processes left in the folder under such names. Raises OSError."""
    shape = re.compile(re.escape(_find_process(beginning)) + r"([0-9]+)-[0-9a-f]{8}")
    for entry in list(folder.iterdir()):
        found = shape.fullmatch(entry.name)
        if found and not _is_running(int(found.group(1))):
            remove(entry)


def remove(entry: Path) -> None:
    """Remove a file or a folder, as far as that is possible."""
    with suppress(OSError):  # even whether it is a folder cannot be asked of a name of 300 letters
        if entry.is_dir() and not entry.is_symlink():
            shutil.rmtree(entry, ignore_errors=True)
        else:
            entry.unlink()


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
