"""Signals that end a run: each becomes an exception, so that unfinished work is cleaned up on the
way out.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from types import FrameType

from kinegrade.processes.loading import is_loading

BY_SIGNAL = 128  # and the signal's number is the exit status, as shells count
_ENDING = ("SIGINT", "SIGTERM", "SIGHUP")  # Windows has no SIGHUP
_SOON = 0.02  # seconds until it is asked again whether code is being loaded


class Signalled(BaseException):
    """A signal ended the run. No `Exception`, or code that survives faults would survive it."""

    def __init__(self, number: int) -> None:
        self.number = number
        super().__init__(number)


@contextmanager
def signals_obeyed() -> Iterator[None]:
    """Meanwhile, Ctrl-C, SIGTERM and a closed terminal raise Signalled; a second one ends the
    process at once.

    What is ignored (nohup, a job in the background) stays ignored. To be called in the main thread.
    """
    usual = {
        number: handler
        for number in _known(_ENDING)
        if (handler := signal.getsignal(number)) in (signal.SIG_DFL, signal.default_int_handler)
    }
    for number in usual:
        signal.signal(number, _end)
    try:
        yield
    finally:
        if hasattr(signal, "setitimer"):  # one that waits for code being loaded comes too late now
            signal.setitimer(signal.ITIMER_REAL, 0)
        for number, handler in usual.items():
            signal.signal(number, handler)


def _known(names: tuple[str, ...]) -> list[signal.Signals]:
    return [signal.Signals[name] for name in names if name in signal.Signals.__members__]


def _end(number: int, frame: FrameType | None) -> None:
    """End the run, when what is being loaded is loaded."""
    signal.signal(number, signal.SIG_DFL)
    if is_loading(frame) and hasattr(signal, "setitimer"):
        signal.signal(signal.SIGALRM, partial(_end_later, number))
        signal.setitimer(signal.ITIMER_REAL, _SOON, _SOON)
    else:
        raise Signalled(number)


def _end_later(ended_by: int, number: int, frame: FrameType | None) -> None:
    """End the run by the signal that came earlier, unless something is still being loaded."""
    if not is_loading(frame):
        signal.setitimer(signal.ITIMER_REAL, 0)
        raise Signalled(ended_by)
