"""One process after the other, where two would put their output in the same folder."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

if sys.platform != "win32":
    import fcntl

_MOST_TRIES = 100
_PAUSE = 0.02  # seconds


@contextmanager
def alone_in(folder: Path) -> Iterator[None]:
    """Nobody else is in such a block for this folder, as far as the system can tell: it ends with
    its process, and leaves nothing behind.

    Network disks have no locks on folders, and somebody else may have locked it for long, so that
    after two seconds the block begins in any case. Raises OSError.
    """
    if sys.platform == "win32":  # folders cannot be opened there
        yield
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        _wait_for(handle)
        yield
    finally:
        os.close(handle)


def _wait_for(handle: int) -> None:
    if sys.platform != "win32":
        for _ in range(_MOST_TRIES):
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                time.sleep(_PAUSE)
            except OSError:  # no locks here
                return
            else:
                return
