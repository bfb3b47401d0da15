"""Many damaged files through every door, by several processes with limits of time and memory.

    python -m tests.fuzz --cases 10000 --seed 1

Prints a table of the doors and every fault with its seeds; the status is 1 if there is any. Without
--seed the seed is new every time. A seed that failed belongs into `tests/fuzz/failed_seeds.py`,
with the fault mended.
"""

from __future__ import annotations

import argparse
import faulthandler
import json
import os
import resource
import subprocess
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from pathlib import Path
from secrets import randbelow

from kinegrade.temporary import temporary_folder
from tests.fuzz.case import SECONDS, Outcome, run_case
from tests.fuzz.doors import write_material

MEMORY = 1 << 30  # bytes
BATCH = 100  # cases in one process
DEADLY = 3 * SECONDS  # after which even code that never looks at signals is ended


def main() -> int:
    """Run the cases, print what came of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz")
    parser.add_argument("--cases", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--batch", type=int, nargs=2, help=argparse.SUPPRESS)
    parser.add_argument("--material", type=Path, help=argparse.SUPPRESS)
    wanted = parser.parse_args()
    if wanted.batch is not None:
        _run_batch(range(*wanted.batch), wanted.material)
        return 0
    first = randbelow(10**9) if wanted.seed is None else wanted.seed
    print(f"seeds {first} to {first + wanted.cases - 1}", flush=True)
    begin = time.monotonic()
    outcomes = list(_all(range(first, first + wanted.cases), wanted.jobs))
    return _report(outcomes, time.monotonic() - begin)


def _all(seeds: range, jobs: int) -> Iterator[Outcome]:
    with temporary_folder() as material, ThreadPoolExecutor(jobs) as pool:
        write_material(material)
        batches = [seeds[place : place + BATCH] for place in range(0, len(seeds), BATCH)]
        for outcomes in pool.map(lambda batch: _by_processes(batch, material), batches):
            yield from outcomes


def _by_processes(batch: range, material: Path) -> list[Outcome]:
    """The outcomes of a batch; where its process dies, that seed is at fault, and another one goes
    on after it.
    """
    outcomes: list[Outcome] = []
    while batch:
        found, ended = _by_process(batch, material)
        outcomes += found
        batch = batch[len(found) :]
        if batch and not ended:
            outcomes.append(Outcome(batch[0], "?", -1, 0.0, "the process died"))
            batch = batch[1:]
    return outcomes


def _by_process(batch: range, material: Path) -> tuple[list[Outcome], bool]:
    bounds = ("--batch", str(batch.start), str(batch.stop))
    done = subprocess.run(
        [sys.executable, "-m", "tests.fuzz", *bounds, "--material", str(material)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        check=False,
        text=True,
    )
    lines = done.stdout.splitlines()
    return [Outcome(**json.loads(line)) for line in lines], done.returncode == 0


def _run_batch(batch: range, material: Path) -> None:
    """In a process of its own: a line of JSON for each case."""
    resource.setrlimit(resource.RLIMIT_DATA, (2 * MEMORY, 2 * MEMORY))
    with temporary_folder() as folder:
        for seed in batch:
            faulthandler.dump_traceback_later(DEADLY, exit=True)
            before = _most_memory()
            outcome = run_case(seed, material, folder / "case")
            most = _most_memory()
            if most > MEMORY and most > before and not outcome.fault:
                outcome = Outcome(**{**asdict(outcome), "fault": f"memory: {most >> 20} MB"})
            print(json.dumps(asdict(outcome)), flush=True)


def _most_memory() -> int:
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


def _report(outcomes: list[Outcome], seconds: float) -> int:
    statuses: dict[str, Counter[int]] = defaultdict(Counter)
    faults: dict[str, list[int]] = defaultdict(list)
    slowest: dict[str, float] = defaultdict(float)
    for each in outcomes:
        statuses[each.door][each.status] += 1
        slowest[each.door] = max(slowest[each.door], each.seconds)
        if each.fault:
            faults[f"{each.door}: {each.fault}"].append(each.seed)
    print(f"{'file':14}{'cases':>8}{'fine':>8}{'complaints':>12}{'refused':>9}{'slowest':>10}")
    for door, counts in sorted(statuses.items()):
        row = f"{door:14}{counts.total():8}{counts[0]:8}{counts[1]:12}{counts[2]:9}"
        print(f"{row}{slowest[door]:8.1f} s")
    print(f"{len(outcomes)} cases in {seconds:.0f} s, {sum(map(len, faults.values()))} faults")
    for fault, seeds in sorted(faults.items()):
        print(f"FAULT {fault}: seeds {', '.join(map(str, seeds[:5]))} ({len(seeds)} in all)")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
