"""A class drawn and printed by several processes at once, and the results in the order of the
roster.

Each task is a part of the class. A few tasks are under way at any time, so memory does not grow
with the class, and a worker ends when the process that it works for is gone. Workers are copies of
this process, with all that it has loaded and looked at, as long as it surely has no other thread,
which a copy would lack; else they are started afresh. (A typesetter that has worked has threads.)
What several of them need to draw, the first one draws and keeps for the others in a folder of their
own, where they also tell each other what numbers they gave away.
"""

from __future__ import annotations

import gc
import os
from collections import deque
from collections.abc import Generator, Iterator
from concurrent.futures import BrokenExecutor, Future
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from kinegrade.errors import TypesetError
from kinegrade.exam.blueprint import Bank
from kinegrade.exam.crew import crew
from kinegrade.exam.drafts import Draft, Plans, Workplace, confirmed, drafts, plans_of, use
from kinegrade.exam.exam_secret import ExamSecret
from kinegrade.exam.ledger import Ledger
from kinegrade.exam.press import Press
from kinegrade.exam.printing import Printed, PrintRun, print_papers
from kinegrade.exam.roster import Roster
from kinegrade.exam.setting import Setting, set_exam
from kinegrade.temporary import temporary_folder

CHUNK = 20  # papers in one task at least: else there are too many of them
# Papers in one task at most: what is worked out together for a part costs little for each paper
# then
MOST = 60
AHEAD = 2  # tasks for each process that are under way or wait for it
ENDED = (
    "generate: a process that prints papers was ended from outside; expected room for all of "
    "them in memory; use fewer: --jobs 1"
)


@dataclass(frozen=True)
class Job:
    """An exam to be printed, known by the folder of its papers: what a worker needs, and keeps
    between its tasks.
    """

    folder: Path
    run: PrintRun = field(compare=False)
    ledger: Path = field(compare=False)
    bank: Bank = field(compare=False)
    roster: Roster = field(compare=False)
    secret: ExamSecret = field(compare=False)

    def setting(self) -> Setting:
        """A setting that has drawn nothing yet."""
        return set_exam(self.bank, self.roster, self.secret)


def printed(
    run: PrintRun, setting: Setting, press: Press, jobs: int
) -> Generator[Printed, None, None]:
    """What remains of each paper, in order, by up to `jobs` processes; a small class by this one
    and its press.

    Raises DrawError, and TypesetError with the faults of the first part of the class that has any.
    """
    count = len(setting.roster.students)
    workers = min(jobs, count // CHUNK)
    if workers > 1:
        with temporary_folder() as folder:
            figures, ledger = folder / "figures", folder / "ledger"
            figures.mkdir()
            ledger.mkdir()
            job = Job(
                run.papers,
                replace(run, sketchbook=figures),
                ledger,
                setting.bank,
                setting.roster,
                setting.secret,
            )
            yield from by_workers(job, setting, press, workers)
        return
    papers = setting.papers()
    for part in parts_of(count, 1):
        yield from print_papers(run, press, [next(papers) for _ in part])


def parts_of(count: int, workers: int) -> Iterator[range]:
    """The class in parts, smaller ones at the end, so that all workers end together."""
    first = 0
    while first < count:
        size = min(max((count - first) // (2 * workers), CHUNK), MOST)
        yield range(first, min(first + size, count))
        first += size


def by_workers(job: Job, setting: Setting, press: Press, workers: int) -> Iterator[Printed]:
    """The same by other processes; at the end, whatever ends it, none of them runs any more."""
    copies = alone()
    waiting: deque[tuple[range, Future[list[Draft]]]] = deque()
    try:
        with crew(workers, "fork" if copies else "spawn") as others:
            if copies:
                prepare(job)  # before the first task is handed out, which makes the copies
            else:
                for _ in range(workers):
                    others.submit(prepare, job)  # while this process finds the plans
            plans = plans_of(job.setting())
            use(plans, setting)
            for number, part in enumerate(parts_of(len(setting.roster.students), workers)):
                waiting.append((part, others.submit(work, job, number, part, plans)))
                if len(waiting) >= AHEAD * workers:
                    done, task = waiting.popleft()
                    yield from confirmed(job.run, setting, press, done, finished(task))
            for done, task in waiting:
                yield from confirmed(job.run, setting, press, done, finished(task))
    except BrokenExecutor as error:  # told when a task is handed out
        raise TypesetError(ENDED) from error


def alone() -> bool:
    """Whether this process surely has no thread but one; only Linux tells."""
    try:
        return len(os.listdir("/proc/self/task")) == 1
    except OSError:
        return False


def finished(task: Future[list[Draft]]) -> list[Draft]:
    """The results of a task. Raises what it raised, TypesetError where its process was killed."""
    try:
        return task.result()
    except BrokenExecutor as error:
        raise TypesetError(ENDED) from error


def prepare(job: Job) -> None:
    """Load and look at what a worker works with, which then stays."""
    for deck in workplace(job).setting.decks.values():
        deck.foresee(())
    gc.freeze()


def work(job: Job, number: int, places: range, plans: Plans) -> list[Draft]:
    """A task: the part of the class with this number, the students at these places of the
    roster.
    """
    place = workplace(job)
    use(plans, place.setting)
    return drafts(job.run, place, number, places)


@lru_cache(maxsize=1)
def workplace(job: Job) -> Workplace:
    """The workplace of this process: it is keeping it that makes it fast."""
    return Workplace(job.setting(), job.run.press_order.press(), Ledger(job.ledger))
