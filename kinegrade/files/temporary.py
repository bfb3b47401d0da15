"""Folders that are needed only while a command runs. Those of killed runs are removed by the next
run.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.files.placing.leftovers import clear_leftovers, make_process_name, remove
from kinegrade.language.message import Fault, Message

_BEGINNING = "kinegrade"


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """A new folder that only this user can read, removed after the block. Raises OutputError."""
    place = Path(tempfile.gettempdir())
    clear_temporary_folders()
    folder = place / make_process_name(_BEGINNING)
    try:
        folder.mkdir(mode=0o700)
    except OSError as fault:
        problem = Message("files.no-temporary-folder", reason=str(fault.strerror))
        expected, do = Message("files.room-and-permission"), Message("files.make-room")
        raise OutputError(Fault(str(place), problem, expected, do)) from fault
    try:
        yield folder
    finally:
        remove(folder)


def clear_temporary_folders() -> None:
    """Remove what processes that no longer run left behind."""
    with suppress(OSError):  # a folder that may not be listed
        clear_leftovers(Path(tempfile.gettempdir()), _BEGINNING)
