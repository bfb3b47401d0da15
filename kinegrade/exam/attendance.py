"""What a process that works for another one does first: it sets itself up and stays no longer than it is needed.

This file loads next to nothing, so that a new process is set up before it loads what it works with.
"""

from __future__ import annotations

import gc
import os
import signal
import threading
from multiprocessing import connection, parent_process

from kinegrade.collection import NEW_OBJECTS


def attend() -> None:
    """Let this process leave an interruption to the one it works for, end with it, and seldom look for rubbish."""
    gc.set_threshold(NEW_OBJECTS)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=end_with_parent, daemon=True).start()


def end_with_parent() -> None:
    """Wait until the process that this one works for is gone, then end at once."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
