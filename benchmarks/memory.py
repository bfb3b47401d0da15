"""The memory of a command together with all processes that it starts, as Linux tells it.

Linux keeps the peak of each process, but none of several together: these are looked at often.
"""

from __future__ import annotations

import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

NOW, PEAK = "VmRSS", "VmHWM"  # lines of a process's status
INTERVAL = 0.02  # seconds between two looks


def peak_of_tree(process: subprocess.Popen[bytes]) -> float:
    """Waits for the process; the largest sum of resident memory seen, or its own peak where that is
    more, in megabytes; 0.0 where there is no /proc.

    Pages that processes share count once for each of them, so the truth is a little below.
    """
    peak = 0.0
    while process.poll() is None:
        together = sum(read_memory(each, NOW) for each in family(process.pid))
        peak = max(peak, together, read_memory(process.pid, PEAK))
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


def read_memory(process: int, line: str) -> float:
    """Megabytes that a process holds in memory by that line of its status; 0.0 when it is gone."""
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(each.split()[1]) / 1024 for each in lines if each.startswith(line))
