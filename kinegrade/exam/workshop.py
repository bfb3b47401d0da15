"""A class drawn and printed by several processes at once, and the results in the order of the
roster.

Each task is a part of the class. A few tasks are under way at any time, so memory does not grow
with the class. What several workers need to draw, the first one draws and keeps for the others in a
folder of their own, where they also tell each other what numbers they gave away.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from kinegrade.exam.blueprint import Bank
from kinegrade.exam.drafts import Draft, Plans, Workplace, confirmed, drafts, plans_of, use
from kinegrade.exam.exam_secret import ExamSecret
from kinegrade.exam.ledger import Ledger
from kinegrade.exam.press import Press
from kinegrade.exam.printing import Printed, PrintRun, print_papers
from kinegrade.exam.roster import Roster
from kinegrade.exam.setting import Setting, set_exam
from kinegrade.processes import Shared, executor, mapped
from kinegrade.temporary import temporary_folder

CHUNK = 20  # papers in one task at least: else there are too many of them
# Papers in one task at most: what is worked out together for a part costs little for each paper
# then
MOST = 60
AHEAD = 2  # tasks for each process that are under way or wait for it


@dataclass(frozen=True)
class Job:
    """An exam to be printed, known by the folder of its ledger: what a worker needs, and keeps
    between its tasks.
    """

    ledger: Path
    run: PrintRun = field(compare=False)
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
                ledger,
                replace(run, sketchbook=figures),
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
    parts = list(parts_of(len(setting.roster.students), workers))
    with executor(workers, "generate") as others:
        plans = plans_of(job.setting())
        use(plans, setting)
        shared = Shared((job, plans))
        tasks = [(shared, number, part) for number, part in enumerate(parts)]
        results = mapped(others, work, tasks, AHEAD * workers)
        for part, found in zip(parts, results, strict=True):
            yield from confirmed(job.run, setting, press, part, found)


def work(task: tuple[Shared[tuple[Job, Plans]], int, range]) -> list[Draft]:
    """The part of the class with this number, the students at these places of the roster."""
    shared, number, places = task
    job, plans = shared.value
    place = workplace(job)
    use(plans, place.setting)
    return drafts(job.run, place, number, places)


@lru_cache(maxsize=1)
def workplace(job: Job) -> Workplace:
    """The workplace of this process: it is keeping it that makes it fast."""
    return Workplace(job.setting(), job.run.press_order.press(), Ledger(job.ledger))
