"""The workers of a cluster of Dask as an Executor: what `--cluster` names is the address of its
scheduler, which is to be trusted.

A task and what it gives travel as bytes that only kinegrade reads, so that no log of the cluster
holds a part of an exam. What a lost worker had begun is done again by another one.
"""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Executor, Future
from contextlib import contextmanager
from functools import partial
from threading import Lock
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from kinegrade import __version__
from kinegrade.errors import InstallationError, WorkerError
from kinegrade.language.message import Fault, Message, Quoted

if TYPE_CHECKING:
    from distributed import Client

_ENCRYPTED = "tls://"  # how an address of Dask begins whose connections are encrypted
_PATIENCE = 10  # seconds for the scheduler to answer
_EACH = 2  # tasks for each thread of the cluster that are under way or wait for it
_Outcome = tuple[bool, object]  # whether a task has given a result; this, or what it has raised
_ONE_AT_A_TIME = Lock()  # a typesetter serves one thread

_Given = ParamSpec("_Given")
_Result = TypeVar("_Result")


@contextmanager
def open_cluster(address: str, command: str) -> Iterator[Executor]:
    """The executor of a command's tasks: the workers of the cluster whose scheduler has this
    address. What is still under way when the block ends is given up.

    Raises InstallationError without the extra `cluster`; WorkerError where there is no such
    scheduler, where it has no workers or such of another version, and where tasks are lost.
    """
    try:
        from distributed import KilledWorker  # noqa: PLC0415
    except ModuleNotFoundError as fault:
        missing, do = Message("files.no-cluster"), Message("files.install-cluster")
        raise InstallationError(Fault("--cluster", missing, do=do)) from fault
    with _connect(address) as client:
        try:
            _require_same_version(client, address)
            yield Cluster(client)
        except (KilledWorker, CancelledError) as fault:
            lost, do = Message("files.cluster-lost"), Message("files.look-at-workers")
            raise WorkerError(Fault(command, lost, do=do)) from fault


@contextmanager
def _connect(address: str) -> Iterator[Client]:
    from distributed import Client  # noqa: PLC0415

    _require_certificates(address)
    try:
        client = Client(  # type: ignore[no-untyped-call]
            address, timeout=_PATIENCE, set_as_default=False
        )
    except (OSError, ValueError, TypeError) as fault:
        what = Message("files.no-scheduler", reason=Quoted(str(fault)))
        do = Message("files.start-scheduler")
        raise WorkerError(Fault(address, what, Message("files.scheduler"), do)) from fault
    with client:
        yield client


def _require_certificates(address: str) -> None:
    """Raises WorkerError where certificates are to be shown that the settings of Dask do not name:
    it would notice that only after a while, and with a traceback.
    """
    from distributed.security import Security  # noqa: PLC0415

    settings = Security().get_connection_args("client")  # type: ignore[no-untyped-call]
    if address.startswith(_ENCRYPTED) and settings["ssl_context"] is None:
        what, expected = Message("files.no-certificates"), Message("files.certificates")
        raise WorkerError(Fault(address, what, expected, Message("files.set-certificates")))


def _require_same_version(client: Client, address: str) -> None:
    """Raises WorkerError where there is no worker, or one without this version of kinegrade."""
    try:
        found = client.run(find_version)
    except ImportError:
        found = {address: ""}
    strange = [worker for worker, version in found.items() if version != __version__]
    if found and not strange:
        return
    what = Message("files.no-workers")
    if strange:
        what = Message("files.strange-worker", worker=strange[0], version=__version__)
    raise WorkerError(Fault(address, what, do=Message("files.start-workers")))


def find_version() -> str:
    """The version of kinegrade where this is called."""
    return __version__


def do_packed(packed: bytes) -> bytes:
    """What comes of a packed task, packed: a result, or what it raises."""
    with _ONE_AT_A_TIME:
        outcome: _Outcome
        try:
            outcome = True, pickle.loads(packed)()
        except Exception as fault:
            outcome = False, fault
    return pickle.dumps(outcome)


class Cluster(Executor):
    """Hands out tasks as bytes; `ahead` of them keep the cluster busy."""

    def __init__(self, client: Client) -> None:
        self._others: Executor = client.get_executor(pure=False)  # type: ignore[no-untyped-call]
        threads = client.nthreads()  # type: ignore[no-untyped-call]
        self.ahead = _EACH * max(sum(threads.values()), 1)

    def submit(
        self, task: Callable[_Given, _Result], /, *given: _Given.args, **named: _Given.kwargs
    ) -> Future[_Result]:
        """Hand out a task."""
        packed = self._others.submit(do_packed, pickle.dumps(partial(task, *given, **named)))
        future: Future[_Result] = Future()
        packed.add_done_callback(partial(_unpack, future))
        return future


def _unpack(future: Future[_Result], packed: Future[bytes]) -> None:
    """Give the future what its task came to."""
    if packed.cancelled():
        future.set_exception(CancelledError())
        return
    lost = packed.exception()
    if lost is not None:
        future.set_exception(lost)
        return
    sound, value = pickle.loads(packed.result())
    if sound:
        future.set_result(value)
    else:
        future.set_exception(value)
