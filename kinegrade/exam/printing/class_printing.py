"""Printing a class: each part of it is set and printed separately, by this process or others, and
the results come in the order of the roster.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from kinegrade.exam.printing.printing import PressOrder, Printed, PrintRun, print_papers
from kinegrade.exam.roster.usual_pages import find_most_pages
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.exam.setting.setting import DealtPaper, Exam, set_papers
from kinegrade.press.protocol import Press
from kinegrade.processes.executor import Shared, map_in_order

# Papers worth a process, and in one task at least; of several processes the last tasks have half as
# many, as nobody else has work while the last is done, and its papers are bound behind it
CHUNK = 20
# Papers in one task at most: enough for the work they share to cost little per paper
MOST = 60
AHEAD = 2  # tasks for each process that are under way or wait for it


@dataclass(frozen=True)
class _PrintTask:
    """A part of a class, and what holds for all parts. All papers will have as many pages as the
    `longest` of the parts that are printed when this one is handed out.
    """

    exam: Shared[Exam]
    run: Shared[PrintRun]
    papers: tuple[DealtPaper, ...]
    longest: int


def print_class(
    run: PrintRun, dealt: ClassDeal, workers: Executor, jobs: int
) -> Generator[Printed, None, None]:
    """Each paper as it was printed, in order, by `jobs` processes.

    Raises TypesetError with the faults of the first part of the class that has any.
    """
    shared, longest = Shared(run), 0
    students = dealt.roster.students
    tasks = (
        _PrintTask(
            dealt.shared,
            shared,
            tuple(map(dealt.dealt, students[part.start : part.stop])),
            longest,
        )
        for part in split_class(len(students), jobs)
    )
    waiting = iter(students)
    for part in map_in_order(workers, _print, tasks, AHEAD * jobs):
        counts = [printed.pages for printed in part]
        longest = max(longest, find_most_pages(tuple(islice(waiting, len(part))), counts))
        yield from part


def count_processes(wanted: int, students: int) -> int:
    """How many processes print a class: no more than there are parts worth one."""
    return max(min(wanted, students // CHUNK), 1)


def split_class(count: int, jobs: int) -> Iterator[range]:
    """The class in parts, smaller ones at the end, so that all processes end together, and at the
    beginning of several, so that what binds them has something to do soon.
    """
    first, least = 0, CHUNK if jobs == 1 else -(-CHUNK // 2)
    begun = 0 if jobs == 1 else jobs * least
    while first < count:
        size = least if first < begun else max((count - first) // (2 * jobs), least)
        size = min(size, MOST)
        yield range(first, min(first + size, count))
        first += size


def _print(task: _PrintTask) -> list[Printed]:
    """A part of the class set and printed."""
    run, exam = task.run.value, task.exam.value
    papers = set_papers(exam, task.papers)
    return print_papers(run, open_press(run.press_order), papers, exam.sketcher, task.longest)


@lru_cache(maxsize=1)
def open_press(order: PressOrder) -> Press:
    """The press of this process, kept because a press is only fast after its first papers."""
    return order.press()
