"""A class drawn and printed by several processes at once, and the results in the order of the roster.

Each task is a part of the class. Workers are started afresh (no fork: a typesetter has threads), a few tasks are under
way at any time, so memory does not grow with the class, and a worker ends when the process that it works for is gone.
What several of them need to draw, the first one draws and keeps for the others in a folder of their own.
"""

from __future__ import annotations

import gc
from collections import deque
from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from functools import lru_cache
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryDirectory

from kinegrade.errors import TypesetError
from kinegrade.exam.attendance import attend
from kinegrade.exam.blueprint import Bank
from kinegrade.exam.drafts import Draft, Plans, confirmed, drafts, plans_of
from kinegrade.exam.press import Press
from kinegrade.exam.printing import Printed, PrintRun, print_papers
from kinegrade.exam.roster import Roster
from kinegrade.exam.setting import Setting, set_exam

CHUNK = 20  # papers in one task: few enough for all processes to end together, many enough for a run of LaTeX
AHEAD = 2  # tasks for each process that are under way or wait for it
ENDED = ("generate: a process that prints papers was ended from outside; expected room for all of them in memory; "
         "use fewer: --jobs 1")


@dataclass(frozen=True)
class Job:
    """An exam to be printed, known by the folder of its papers: what a worker needs, and keeps between its tasks."""

    folder: Path
    run: PrintRun = field(compare=False)
    bank: Bank = field(compare=False)
    roster: Roster = field(compare=False)
    secret: str = field(compare=False)

    @staticmethod
    def of(run: PrintRun, setting: Setting) -> Job:
        """The job of a setting that has drawn nothing yet."""
        return Job(run.papers, run, setting.bank, setting.roster, setting.secret)

    def setting(self) -> Setting:
        """The setting anew."""
        return set_exam(self.bank, self.roster, self.secret)


def printed(run: PrintRun, setting: Setting, press: Press, jobs: int) -> Generator[Printed, None, None]:
    """What remains of each paper, in order, by up to `jobs` processes; a small class by this one and its press.

    Raises DrawError, and TypesetError with the faults of the first part of the class that has any.
    """
    count = len(setting.roster.students)
    parts = [range(first, min(first + CHUNK, count)) for first in range(0, count, CHUNK)]
    workers = min(jobs, count // CHUNK)
    if workers > 1:
        with TemporaryDirectory(prefix="kinegrade-") as sketchbook:
            yield from by_workers(replace(run, sketchbook=Path(sketchbook)), setting, press, parts, workers)
        return
    papers = setting.papers()
    for part in parts:
        yield from print_papers(run, press, [next(papers) for _ in part])


def by_workers(run: PrintRun, setting: Setting, press: Press, parts: Sequence[range],
               workers: int) -> Iterator[Printed]:
    """The same by other processes; at the end, whatever ends it, none of them runs any more."""
    job = Job.of(run, setting)
    executor = ProcessPoolExecutor(workers, get_context("spawn"), attend)
    waiting: deque[tuple[range, Future[list[Draft]]]] = deque()
    try:
        for _ in range(workers):
            executor.submit(prepare, job)  # while this process finds the plans
        plans = plans_of(job.setting())
        for part in parts:
            waiting.append((part, executor.submit(work, job, part, plans)))
            if len(waiting) >= AHEAD * workers:
                done, task = waiting.popleft()
                yield from confirmed(run, setting, press, done, finished(task))
        for done, task in waiting:
            yield from confirmed(run, setting, press, done, finished(task))
    except BrokenExecutor as error:  # told when a task is handed out
        raise TypesetError(ENDED) from error
    finally:
        executor.shutdown(wait=True, cancel_futures=True)


def finished(task: Future[list[Draft]]) -> list[Draft]:
    """The results of a task. Raises what it raised, TypesetError where its process was killed."""
    try:
        return task.result()
    except BrokenExecutor as error:
        raise TypesetError(ENDED) from error


def prepare(job: Job) -> None:
    """Load and look at what this process works with, which then stays."""
    setting, _ = workplace(job)
    for deck in setting.decks.values():
        deck.foresee(())
    gc.freeze()


def work(job: Job, places: range, plans: Plans) -> list[Draft]:
    """A task: the students at these places of the roster."""
    setting, press = workplace(job)
    return drafts(job.run, setting, press, places, plans)


@lru_cache(maxsize=1)
def workplace(job: Job) -> tuple[Setting, Press]:
    """The decks and the press of this process: it is keeping them that makes it fast."""
    return job.setting(), job.run.press_order.press()
