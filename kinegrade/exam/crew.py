"""Other processes that work for this one, and none of them outlives it, whatever ends it."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.process import BaseProcess
from typing import Literal, ParamSpec, TypeVar

from kinegrade.exam.attendance import attend
from kinegrade.temporary import clear_temporary_folders

PATIENCE = 0.2  # seconds for a dismissed process to stop its typesetter and to clear away its files

_Given = ParamSpec("_Given")
_Result = TypeVar("_Result")


@dataclass(frozen=True)
class Crew:
    """Processes that take tasks."""

    executor: ProcessPoolExecutor

    def submit(
        self, task: Callable[_Given, _Result], *given: _Given.args, **named: _Given.kwargs
    ) -> Future[_Result]:
        """Hand out a task. A process that starts for it is not hit by Ctrl-C before it is set
        up.
        """
        with _interruption_deferred():
            return self.executor.submit(task, *given, **named)


@contextmanager
def crew(workers: int, start: Literal["fork", "spawn"]) -> Iterator[Crew]:
    """Up to `workers` processes. Those still at work when the block ends by an exception are
    dismissed at once.
    """
    executor = ProcessPoolExecutor(workers, get_context(start), attend)
    try:
        yield Crew(executor)
    except BaseException:
        _dismiss(list((executor._processes or {}).values()))
        executor.shutdown(wait=True, cancel_futures=True)
        clear_temporary_folders()  # of those who had no time for that
        raise
    executor.shutdown(wait=True)


def _dismiss(processes: list[BaseProcess]) -> None:
    """Ask the processes to end, and after a while end them."""
    for process in processes:
        process.terminate()
    until = time.monotonic() + PATIENCE
    for process in processes:
        process.join(max(until - time.monotonic(), 0))
    for process in processes:
        process.kill()


@contextmanager
def _interruption_deferred() -> Iterator[None]:
    """Ctrl-C waits for the end of the block; where the system cannot do that, it does not wait."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
