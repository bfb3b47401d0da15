"""What a worker process does first: it prepares to end with the process that it works for, or
earlier.

This file loads next to nothing, so that a new process is set up before it loads the rest.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
import time
from multiprocessing import connection, parent_process
from types import FrameType

from kinegrade.garbage_collection import NEW_OBJECTS

PATIENCE = 1.0  # seconds to stop a typesetter and to remove files


def begin_work() -> None:
    """Make this process leave Ctrl-C to the one that it works for, end with it, and rarely collect
    garbage.
    """
    gc.set_threshold(NEW_OBJECTS)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _leave)
    if hasattr(signal, "pthread_sigmask"):  # it was started with interruptions deferred
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """Wait until the process that this one works for has ended, then end, together with a
    typesetter that may be running.
    """
    parent = parent_process()
    if parent is None:
        return
    connection.wait([parent.sentinel])
    main = threading.main_thread().ident
    if main is not None and hasattr(signal, "pthread_kill"):
        signal.pthread_kill(main, signal.SIGTERM)
        time.sleep(PATIENCE)
    os._exit(1)


def _leave(number: int, frame: FrameType | None) -> None:
    """Remove unfinished output before leaving."""
    sys.exit(128 + number)
