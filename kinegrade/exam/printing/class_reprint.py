"""Papers of a class printed again from what an exam folder keeps: a part of the class at a time, by
this process or others.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.printing.class_printing import AHEAD, open_press, split_class
from kinegrade.exam.printing.printing import Printed, PrintRun, print_papers
from kinegrade.exam.setting.kept_exam import KeptExam, list_with_keys
from kinegrade.processes.executor import Shared, map_in_order


@dataclass(frozen=True)
class _ReprintTask:
    """A part of a class, and what holds for all parts."""

    kept: Shared[KeptExam]
    run: Shared[PrintRun]
    students: Sequence[tuple[Candidate, KeyLine | None]]


def print_class_again(
    kept: KeptExam, run: PrintRun, workers: Executor, jobs: int
) -> Generator[Printed, None, None]:
    """Each paper of an exam as it was printed, in order, by `jobs` processes.

    Raises ExamError where something else follows than the key says, BankError, TypesetError.
    """
    exam = kept.exam
    shared_kept, shared_run = Shared(KeptExam(exam, run.bank)), Shared(run)
    students = exam.head.everybody
    tasks = (
        _ReprintTask(
            shared_kept, shared_run, list_with_keys(exam, students[part.start : part.stop])
        )
        for part in split_class(len(students), jobs)
    )
    for part in map_in_order(workers, _print, tasks, AHEAD * jobs):
        yield from part


def _print(task: _ReprintTask) -> list[Printed]:
    """A part of the class."""
    papers = [task.kept.value.paper_by(*each) for each in task.students]
    run = task.run.value
    return print_papers(run, open_press(run.press_order), papers)
