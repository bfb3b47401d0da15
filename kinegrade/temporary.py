"""Folders for what is needed only while a command runs. Those of killed runs are cleared by the
next run.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.leftovers import clear_leftovers, own_name, remove

_BEGINNING = "kinegrade"


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """A new folder for this user's eyes only, removed when the block ends. Raises OutputError."""
    place = Path(tempfile.gettempdir())
    clear_temporary_folders()
    folder = place / own_name(_BEGINNING)
    try:
        folder.mkdir(mode=0o700)
    except OSError as fault:
        raise OutputError(
            f"{place}: no temporary folder can be made ({fault.strerror}) - expected room and "
            "permission - make room, or name another place by TMPDIR"
        ) from fault
    try:
        yield folder
    finally:
        remove(folder)


def clear_temporary_folders() -> None:
    """Remove what processes left behind that run no more."""
    with suppress(OSError):  # a folder that may not be listed
        clear_leftovers(Path(tempfile.gettempdir()), _BEGINNING)
