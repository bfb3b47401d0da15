"""The memory of a command together with all processes that it starts, as Linux tells it."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

INTERVAL = 0.05  # seconds between two looks


def peak_of_tree(process: subprocess.Popen[bytes]) -> float:
    """Waits for the process; the largest sum of resident memory seen, in megabytes; 0.0 where there
    is no /proc.

    Pages that processes share count once for each of them, so the truth is a little below.
    """
    peak = 0.0
    while process.poll() is None:
        peak = max(peak, sum(map(resident, family(process.pid))))
        time.sleep(INTERVAL)
    return peak


def family(process: int) -> Iterator[int]:
    """A process and all its descendants that run now."""
    yield process
    try:
        tasks = list(Path(f"/proc/{process}/task").iterdir())
        children = [
            int(number) for task in tasks for number in (task / "children").read_text().split()
        ]
    except OSError:  # it has just ended, or this is no Linux
        return
    for child in children:
        yield from family(child)


def resident(process: int) -> float:
    """Megabytes that a process holds in memory; 0.0 when it is gone."""
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmRSS"))
