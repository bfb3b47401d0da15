"""A proof run by several processes; where one dies, its seed is at fault and another goes on."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

from tests.prove.outcome import Outcome
from tests.prove.proof import Proof

DIED = "the process died"


def outcomes(proof: Proof, seeds: range, jobs: int, until: float) -> Iterator[Outcome]:
    """What came of the seeds; no batch begins after the time `until` of the monotonic clock."""
    batches = [seeds[place : place + proof.batch] for place in range(0, len(seeds), proof.batch)]
    with ThreadPoolExecutor(jobs) as pool:
        for found in pool.map(lambda batch: _in_time(proof, batch, until), batches):
            yield from found


def _in_time(proof: Proof, batch: range, until: float) -> list[Outcome]:
    return _by_processes(proof, batch) if time.monotonic() < until else []


def _by_processes(proof: Proof, batch: range) -> list[Outcome]:
    found: list[Outcome] = []
    while batch:
        came, status = _by_process(proof, batch)
        found += came
        batch = batch[len(came) :]
        if batch and status:
            found.append(Outcome(batch[0], f"{DIED} ({_tell_death(status)})"))
            batch = batch[1:]
    return found


def _by_process(proof: Proof, batch: range) -> tuple[list[Outcome], int]:
    """What came of a batch until its process ended, and with which status it did."""
    bounds = (str(batch.start), str(batch.stop))
    done = subprocess.run(
        [sys.executable, "-m", "tests.prove.batch", proof.address, *bounds],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        check=False,
        text=True,
    )
    lines = done.stdout.splitlines()
    return [Outcome(**json.loads(line)) for line in lines], done.returncode


def _tell_death(status: int) -> str:
    """Why: SIGXCPU is the limit of time."""
    return signal.Signals(-status).name if status < 0 else f"status {status}"
