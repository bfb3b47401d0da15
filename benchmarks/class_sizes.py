"""What a class costs by its size: processor time, memory and files of `kinegrade generate`.

    python -m benchmarks.class_sizes 100 300 1000

prints a table for these sizes and what each further paper adds. It is processor time of one
process, so that it may be measured on a machine that does other work.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

BANK = "demo"  # four questions with figures


@dataclass(frozen=True)
class Cost:
    """What a class of so many students took: seconds of the processor, megabytes of memory at most,
    megabytes and files on the disk.
    """

    students: int
    seconds: float
    memory: float
    disk: float
    files: int


def measure(folder: Path, students: int) -> Cost:
    """Generate the exam of a class in the folder, by one process."""
    roster, exam = folder / f"{students}.csv", folder / f"EXAM-{students}"
    write_roster(roster, students)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = ["generate", BANK, str(roster), "-o", str(exam), "--reproducible", "sizes"]
    process = subprocess.Popen(
        [sys.executable, "-m", "kinegrade", *command, "--jobs", "1"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):
        raise RuntimeError(f"generate ended with status {process.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    sizes = [file.stat().st_size for file in exam.rglob("*") if file.is_file()]
    return Cost(students, seconds, used.ru_maxrss / 1024, sum(sizes) / 1e6, len(sizes))


def write_roster(file: Path, students: int) -> None:
    """The roster of a class of so many students."""
    rows = "".join(f"{number:06},Student {number}\n" for number in range(students))
    file.write_text(f"student,name\n{rows}", encoding="utf-8")


def write_cost(cost: Cost) -> str:
    """A row of the table."""
    return (
        f"{cost.students:>8} {cost.seconds:>9.1f} {cost.memory:>10.0f} {cost.disk:>9.1f} "
        f"{cost.files:>7}"
    )


def write_slope(one: Cost, other: Cost) -> str:
    """What each paper adds between two sizes."""
    more = other.students - one.students
    return (
        f"from {one.students} to {other.students}, each paper: "
        f"{1e3 * (other.seconds - one.seconds) / more:.1f} ms, "
        f"{1e3 * (other.memory - one.memory) / more:.0f} kB memory, "
        f"{1e3 * (other.disk - one.disk) / more:.0f} kB disk"
    )


def main() -> None:
    """Print the table for the sizes that are named, as they are measured."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.class_sizes")
    parser.add_argument("students", nargs="+", type=int)
    print(f"{'papers':>8} {'seconds':>9} {'MB memory':>10} {'MB disk':>9} {'files':>7}")
    costs: list[Cost] = []
    with TemporaryDirectory() as name:
        for students in sorted(parser.parse_args().students):
            costs.append(measure(Path(name), students))
            print(write_cost(costs[-1]), flush=True)
    for one, other in pairwise(costs):
        print(write_slope(one, other))


if __name__ == "__main__":
    main()
