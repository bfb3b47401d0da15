"""What a worker process does first: it prepares to end with the process that it works for, or
earlier.

This file loads next to nothing, so that a new process is set up before it loads the rest.
"""

from __future__ import annotations

import gc
import os
import signal
import threading
import time
from collections.abc import Callable
from multiprocessing import connection, parent_process
from types import FrameType
from typing import TypeVar

from kinegrade.processes.garbage_collection import NEW_OBJECTS
from kinegrade.processes.loading import is_loading

DEFERRED = (signal.SIGINT, signal.SIGTERM)  # while a process starts, until it is set up
_PATIENCE = 1.0  # seconds to stop a typesetter and to remove files

_Result = TypeVar("_Result")


class _LeaveError(BaseException):
    """This process shall end. No `Exception`, or code that survives faults would survive it."""


def begin_work() -> None:
    """Make this process leave Ctrl-C to the one that it works for, end with it, and rarely collect
    garbage.
    """
    gc.set_threshold(NEW_OBJECTS)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # outside a task there is nothing to clear away
    if hasattr(signal, "pthread_sigmask"):  # it was started with signals deferred
        signal.pthread_sigmask(signal.SIG_UNBLOCK, DEFERRED)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def do_task(task: Callable[[], _Result]) -> _Result:
    """What a task gives. SIGTERM meanwhile ends this process when the task has cleared away; were
    it a result, it would end the process that waits for it.
    """
    signal.signal(signal.SIGTERM, _leave)
    try:
        return task()
    except _LeaveError:
        os._exit(128 + signal.SIGTERM)
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


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
        time.sleep(_PATIENCE)
    os._exit(1)


def _leave(number: int, frame: FrameType | None) -> None:
    """Clear away on the way out what was begun. A process that is loading code is soon ended by the
    one that it works for, which removes what it leaves.
    """
    if not is_loading(frame):
        raise _LeaveError
