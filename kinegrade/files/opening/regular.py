"""Files that can be read as often as marking needs to: no pipe, whose second reading is empty."""

from __future__ import annotations

from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import BinaryIO

from kinegrade.language.message import Fault, Message, Text


class ReadOnceOnlyError(OSError):
    """What is named gives its content a single time."""


def open_regular(path: Path) -> BinaryIO:
    """The bytes of a file. Raises OSError, before anything is read of a pipe or device."""
    mode = path.stat().st_mode
    if not S_ISREG(mode) and not S_ISDIR(mode):  # a folder is refused as it is opened
        raise ReadOnceOnlyError
    return path.open("rb")


def explain_unopened(path: Path, fault: OSError, expected: Text) -> Fault:
    """What is wrong with a file that cannot be opened, and what to do."""
    if isinstance(fault, ReadOnceOnlyError):
        what, do = Message("files.read-once-only"), Message("files.save-it-first")
    else:
        what = Message("files.cannot-be-read", reason=str(fault.strerror))
        do = Message("files.check-the-name")
    return Fault(str(path), what, expected, do)
