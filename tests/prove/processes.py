"""A proof run by several processes; where one dies, its seed is at fault and another goes on."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

from tests.prove.outcome import Outcome
from tests.prove.proof import Proof

DIED = "the process died"


def outcomes(
    proof: Proof, seeds: range, jobs: int, until: float, note: Callable[[Outcome], None]
) -> Iterator[Outcome]:
    """What came of the seeds, each of which is noted as soon as it is known; no batch begins after
    the time `until` of the monotonic clock.
    """
    batches = [seeds[place : place + proof.batch] for place in range(0, len(seeds), proof.batch)]

    def run(batch: range) -> list[Outcome]:
        return list(_run_batch(proof, batch, note)) if time.monotonic() < until else []

    with ThreadPoolExecutor(jobs) as pool:
        for found in pool.map(run, batches):
            yield from found


def _run_batch(proof: Proof, batch: range, note: Callable[[Outcome], None]) -> Iterator[Outcome]:
    """What came of a batch, by as many processes as it takes."""
    while batch:
        process = _begin(proof, batch)
        for line in process.stdout or ():
            found = Outcome(**json.loads(line))
            note(found)
            yield found
            batch = batch[1:]
        status = process.wait()
        if batch and status:
            died = Outcome(batch[0], f"{DIED} ({_tell_death(status)})")
            note(died)
            yield died
            batch = batch[1:]


def _begin(proof: Proof, batch: range) -> subprocess.Popen[str]:
    """The process that runs a batch."""
    bounds = (str(batch.start), str(batch.stop))
    return subprocess.Popen(
        [sys.executable, "-m", "tests.prove.batch", proof.address, *bounds],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )


def _tell_death(status: int) -> str:
    """Why: SIGXCPU is the limit of time."""
    return signal.Signals(-status).name if status < 0 else f"status {status}"
