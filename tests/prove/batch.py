"""Cases of a proof in a process of their own, with limits of time and memory.

    python -m tests.prove.batch tests.prove.fairness:hold 100 120

Writes a line of JSON for each case, as soon as it is done.
"""

from __future__ import annotations

import faulthandler
import json
import resource
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from pkgutil import resolve_name

from kinegrade.files.temporary import temporary_folder
from tests.prove.outcome import Outcome

MEMORY = 1 << 30  # bytes
SECONDS = 900  # of the processor, after which a case is ended by the system
LONGEST = 4 * SECONDS  # by the clock, for a case that waits for what never comes


def main(address: str, first: str, stop: str) -> None:
    """Run the cases of these seeds."""
    resource.setrlimit(resource.RLIMIT_DATA, (2 * MEMORY, 2 * MEMORY))
    hold = resolve_name(address)
    with temporary_folder() as folder:
        for seed in range(int(first), int(stop)):
            _give_time()
            print(json.dumps(asdict(_try(hold, seed, folder))), flush=True)


def _give_time() -> None:
    """Give the next case its time: of the processor, as a busy machine is no fault of the claim."""
    _, highest = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (int(time.process_time()) + SECONDS, highest))
    faulthandler.dump_traceback_later(LONGEST, exit=True)


def _try(hold: Callable[[int, Path], int | None], seed: int, folder: Path) -> Outcome:
    """What is wrong at a seed, in one line; a case that takes more memory than any before it, and
    more than is allowed, is at fault too.
    """
    before = _most_memory()
    try:
        compared = hold(seed, folder) or 0
    except Exception as fault:
        place = traceback.extract_tb(fault.__traceback__)[-1]
        said = " ".join(str(fault).split())
        name = f"{type(fault).__name__} in {Path(place.filename).name}:{place.lineno}"
        return Outcome(seed, f"{name}: {said}")
    most = _most_memory()
    at_fault = most > max(before, MEMORY)
    return Outcome(seed, f"memory: {most >> 20} MB" if at_fault else "", compared)


def _most_memory() -> int:
    """The most bytes that this process has held; not those of the one that began it, which the
    system counts with them where it does not tell them apart.
    """
    status = Path("/proc/self/status")
    if status.exists():
        lines = dict(line.split(":", 1) for line in status.read_text("utf-8").splitlines())
        return int(lines["VmHWM"].split()[0]) << 10
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


if __name__ == "__main__":
    main(*sys.argv[1:])
