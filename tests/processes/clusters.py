"""A scheduler of Dask and its workers as processes, for tests and benchmarks."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ENVIRONMENT = {
    **os.environ,
    "PYTHONPATH": os.pathsep.join(sys.path),
    "DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "2s",
}


class Cluster:
    """A scheduler and its workers, each a process."""

    def __init__(self, folder: Path) -> None:
        self._file = folder / "scheduler.json"
        self._folder = folder
        self.processes = [
            self._start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-show")
        ]
        wait_until(self._file.exists)
        self.address = str(json.loads(self._file.read_text(encoding="utf-8"))["address"])

    def add_worker(self) -> subprocess.Popen[bytes]:
        """One more worker: it has nothing of this machine's but the installed package."""
        worker = self._start("dask_worker", "--nthreads", "1", "--no-nanny", "--no-dashboard")
        self.processes.append(worker)
        return worker

    def end(self) -> None:
        """End every process."""
        for process in reversed(self.processes):
            process.kill()
            process.wait()

    def _start(self, program: str, *options: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [
                *(sys.executable, "-m", f"distributed.cli.{program}"),
                *("--scheduler-file", str(self._file), *options),
            ],
            cwd=self._folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env=ENVIRONMENT,
        )


def wait_until(ready: Callable[[], bool]) -> None:
    """Wait for something that takes seconds."""
    until = time.monotonic() + 120
    while not ready():
        if time.monotonic() > until:
            raise TimeoutError
        time.sleep(0.02)


def count_workers(address: str) -> int:
    """How many workers a scheduler has."""
    from distributed import (
        Client,
    )  # takes a second to import, which one worker of tests alone needs

    with Client(address, set_as_default=False) as client:  # type: ignore[no-untyped-call]
        return len(client.nthreads())  # type: ignore[no-untyped-call]
