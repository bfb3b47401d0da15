"""Worked solutions of papers that exist, derived again from what the exam folder keeps: a part of
the class at a time, by this process or others.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.printing.class_printing import AHEAD, open_press, split_class
from kinegrade.exam.printing.printing import PrintRun, print_solutions
from kinegrade.exam.setting.kept_exam import KeptExam, list_with_keys
from kinegrade.press.protocol import Printout
from kinegrade.processes.executor import Shared, map_in_order


@dataclass(frozen=True)
class _SolutionTask:
    """A part of a class, and what holds for all parts."""

    kept: Shared[KeptExam]
    run: Shared[PrintRun]
    students: Sequence[tuple[Candidate, KeyLine | None]]


def print_class_solutions(
    exam: ExamFolder, run: PrintRun, students: Sequence[Candidate], workers: Executor, jobs: int
) -> Generator[tuple[str, Printout], None, None]:
    """The stem of each student's files, and the worked solutions; in order, by `jobs` processes.

    Raises ExamError where something else follows than the key says, BankError, TypesetError.
    """
    kept = Shared(KeptExam(exam, run.bank))
    shared = Shared(run)
    tasks = (
        _SolutionTask(kept, shared, list_with_keys(exam, students[part.start : part.stop]))
        for part in split_class(len(students), jobs)
    )
    for part in map_in_order(workers, _print, tasks, AHEAD * jobs):
        yield from part


def _print(task: _SolutionTask) -> list[tuple[str, Printout]]:
    """The worked solutions of a part of the class."""
    papers = [task.kept.value.paper_by(*each) for each in task.students]
    press = open_press(task.run.value.press_order)
    return list(print_solutions(task.run.value, press, papers).items())
