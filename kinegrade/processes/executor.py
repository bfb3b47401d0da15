"""Work for other processes, or for this one: one Executor for a whole command, and the results of
many tasks in order.

A command opens `open_executor` and passes it down; code that has tasks calls `map_in_order`. The
workers are those of a cluster where one is named, else processes of this machine. The first task
starts these: as copies of this process, with everything that it has loaded, where it certainly has
no other thread, which a copy would lack; otherwise from scratch. (A typesetter that has been used
has threads.) None of them outlives this process, however it ends.
"""

from __future__ import annotations

import os
import pickle
import signal
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from itertools import chain, islice
from multiprocessing import active_children, get_context
from typing import Generic, Literal, ParamSpec, TypeVar

from kinegrade.errors import WorkerError
from kinegrade.files.temporary import clear_temporary_folders
from kinegrade.language.message import Fault, Message
from kinegrade.processes.cluster import Cluster, open_cluster
from kinegrade.processes.worker import DEFERRED, begin_work, do_task

Start = Literal["fork", "spawn"]

_AHEAD = 2 * (os.cpu_count() or 1)  # tasks running, or done with results waiting

_PATIENCE = 0.2  # seconds for a dismissed process to stop its typesetter and to remove its files
_KEPT = 4  # shared values that a process keeps: a command has one or two

_Given = ParamSpec("_Given")
_Item = TypeVar("_Item")
_Result = TypeVar("_Result")
_Value = TypeVar("_Value")


@contextmanager
def open_executor(
    jobs: int, command: str, start: Start | None = None, *, cluster: str | None = None
) -> Iterator[Executor]:
    """The executor of a command's tasks: the workers of the `cluster` whose scheduler has that
    address; without one, up to `jobs` processes; for 1, this process, which does a task at once.

    Processes still at work when the block ends with an exception are dismissed at once. `start`
    fixes how they are started; by default that is decided at the first task. Raises WorkerError,
    which names the command, where one of them was ended from outside; with a cluster, as
    `open_cluster` does.
    """
    if cluster is not None:
        with open_cluster(cluster, command) as workers:
            yield workers
        return
    if jobs == 1:
        yield THIS_PROCESS
        return
    others = _OtherProcesses(jobs, start)
    try:
        yield others
    except BrokenExecutor as fault:
        others.dismiss()
        raise WorkerError(Fault(command, Message("files.process-ended"))) from fault
    except BaseException:
        others.dismiss()
        raise
    others.shutdown(cancel_futures=True)


def map_in_order(
    workers: Executor,
    task: Callable[[_Item], _Result],
    items: Iterable[_Item],
    ahead: int = _AHEAD,
) -> Generator[_Result, None, None]:
    """The result of the task for each item, in order, as they are requested.

    At most `ahead` tasks are running or have results waiting, or as many as keep a cluster busy, so
    memory does not grow with the number of items. A single item is not worth another process.
    Raises what the task raises; tasks handed out by then are given up with the executor.
    """
    remaining = iter(items)
    first = list(islice(remaining, 2))
    if len(first) < 2:
        yield from map(task, first)
        return
    if isinstance(workers, Cluster):
        ahead = workers.ahead
    waiting: deque[Future[_Result]] = deque()
    for item in chain(first, remaining):
        waiting.append(workers.submit(task, item))
        if len(waiting) >= ahead or waiting[0].done():
            yield waiting.popleft().result()
    while waiting:
        yield waiting.popleft().result()


def split_in_parts(items: Iterable[_Item], size: int) -> Iterator[list[_Item]]:
    """The items in order, so many in each part; fewer in the last.

    >>> list(split_in_parts("abcde", 2))
    [['a', 'b'], ['c', 'd'], ['e']]
    """
    remaining = iter(items)
    while part := list(islice(remaining, size)):
        yield part


@dataclass(frozen=True)
class Shared(Generic[_Value]):
    """A value that is the same for many tasks, as part of their items: pickled once, and unpickled
    once by each process.

    >>> pickle.loads(pickle.dumps(Shared("bank"))).value
    'bank'
    """

    value: _Value

    def __reduce__(self) -> tuple[Callable[[bytes], Shared[_Value]], tuple[bytes]]:
        return _receive, (self._packed,)

    @cached_property
    def _packed(self) -> bytes:
        return pickle.dumps(self.value)


@lru_cache(maxsize=_KEPT)
def _receive(packed: bytes) -> Shared[_Value]:
    return Shared(pickle.loads(packed))


class _ThisProcess(Executor):
    """Does each task when it is submitted."""

    def submit(
        self, task: Callable[_Given, _Result], /, *given: _Given.args, **named: _Given.kwargs
    ) -> Future[_Result]:
        future: Future[_Result] = Future()
        try:
            future.set_result(task(*given, **named))
        except Exception as fault:
            future.set_exception(fault)
        return future


THIS_PROCESS: Executor = _ThisProcess()


class _OtherProcesses(Executor):
    """Starts processes at the first task, because only then is it known how they can be started."""

    def __init__(self, jobs: int, start: Start | None) -> None:
        self._jobs = jobs
        self._start = start
        self._strangers = frozenset(active_children())

    @cached_property
    def _pool(self) -> ProcessPoolExecutor:
        start = self._start or ("fork" if _alone() else "spawn")
        return ProcessPoolExecutor(self._jobs, get_context(start), begin_work)

    def submit(
        self, task: Callable[_Given, _Result], /, *given: _Given.args, **named: _Given.kwargs
    ) -> Future[_Result]:
        """Hand out a task. No signal reaches a process started for it before it is set up."""
        with _signals_deferred():
            return self._pool.submit(do_task, partial(task, *given, **named))

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let the processes end when their tasks are done."""
        self._pool.shutdown(wait, cancel_futures=cancel_futures)

    def dismiss(self) -> None:
        """Ask the processes to end, after a while kill them, and remove what they left behind."""
        processes = [each for each in active_children() if each not in self._strangers]
        for process in processes:
            process.terminate()
        until = time.monotonic() + _PATIENCE
        for process in processes:
            process.join(max(until - time.monotonic(), 0))
        for process in processes:
            process.kill()
        for process in processes:
            process.join()
        self._end_results()
        self.shutdown(cancel_futures=True)
        clear_temporary_folders()

    def _end_results(self) -> None:
        """Close this end of the pipe of results, when the others are closed. A process that was
        killed while it sent a result left half of it: the pool would wait for the rest for ever.
        """
        results = self._pool._result_queue
        results._writer.close()  # type: ignore[attr-defined]


def _alone() -> bool:
    """Whether this process certainly has only one thread; only Linux reports that."""
    try:
        return len(os.listdir("/proc/self/task")) == 1
    except OSError:
        return False


@contextmanager
def _signals_deferred() -> Iterator[None]:
    """Ctrl-C and SIGTERM wait for the end of the block, where the system can do that."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, DEFERRED)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
