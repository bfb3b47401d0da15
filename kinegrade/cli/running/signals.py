"""Signals that end a run: each becomes an exception, so that unfinished work is cleaned up on the
way out.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

BY_SIGNAL = 128  # and the signal's number is the exit status, as shells count
_ENDING = ("SIGINT", "SIGTERM", "SIGHUP")  # Windows has no SIGHUP


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
        for number, handler in usual.items():
            signal.signal(number, handler)


def _known(names: tuple[str, ...]) -> list[signal.Signals]:
    return [signal.Signals[name] for name in names if name in signal.Signals.__members__]


def _end(number: int, frame: FrameType | None) -> None:
    signal.signal(number, signal.SIG_DFL)
    raise Signalled(number)
