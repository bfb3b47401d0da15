"""`kinegrade solutions`: worked solutions of an exam that exists, byte for byte those that
`generate --solutions` would have written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from msgspec import structs

from kinegrade.errors import OptionError, OutputError
from kinegrade.exam.bank.texts import require_bank_language
from kinegrade.exam.folder.contents import SOLUTIONS
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.generating.exam_files import write_head
from kinegrade.exam.generating.growing.grown_folder import (
    copy_exam,
    digest_grown,
    open_grown_folder,
)
from kinegrade.exam.generating.hand_work import find_edited, refuse_edited
from kinegrade.exam.printing.class_printing import count_processes
from kinegrade.exam.printing.class_solutions import print_class_solutions
from kinegrade.exam.printing.printed_files import write_solutions
from kinegrade.exam.printing.printing import PrintRun
from kinegrade.exam.printing.reprint import find_candidates, kept_run
from kinegrade.exam.roster.students import read_place
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.press.protocol import Printout
from kinegrade.problem.template.template import Method
from kinegrade.processes.executor import open_executor
from kinegrade.processes.garbage_collection import bulk_work

_Manner = Literal["method", "cycle"]  # in which worked solutions are those of a whole class
_NAMED = 5  # students that a message names
Progress = Callable[[Iterator[tuple[str, Printout]], int], Iterator[tuple[str, Printout]]]


@dataclass(frozen=True)
class SolutionWishes:
    """Whose worked solutions are wanted, by id or by the name of a spare paper; none for all.

    `method` finds velocities where several serve, by default that of the exam; they have graphs
    over the `cycle` if that is wished, or if those of the exam do; they are in
    `language`, by default in that of each paper; with `force` those that exist are replaced. They
    are printed by up to `jobs` processes, or by the workers of the `cluster` whose scheduler has
    that address; `progress` is given them one after another, and their number.
    """

    students: tuple[str, ...]
    method: Method | None
    cycle: bool
    language: Language | None
    jobs: int
    force: bool
    progress: Progress
    cluster: str | None = None


def add_solutions(exam: ExamFolder, wishes: SolutionWishes) -> int:
    """Write worked solutions into the exam folder, as the papers were printed; gives their number.
    All that the folder has then stand in one file too.

    Raises ExamError where there is no such student, or where something else follows from the
    folder than its key says, OutputError, OptionError; then nothing is written.
    """
    everybody = exam.head.everybody
    students = find_candidates(exam, wishes.students) if wishes.students else everybody
    run = _make_run(exam, wishes, students)
    if not wishes.force:
        _require_new(exam, students)
    jobs = count_processes(wishes.jobs, len(students))
    processes = open_executor(jobs, "solutions", cluster=wishes.cluster)
    with bulk_work(), open_grown_folder(exam) as folder, processes as workers:
        copy_exam(exam, folder)
        with closing(print_class_solutions(exam, run, students, workers, jobs)) as printed:
            places = [read_place(each.file) for each in everybody]
            write_solutions(folder, wishes.progress(printed, len(students)), places)
        _write_head(exam, run, folder)
    return len(students)


def _make_run(exam: ExamFolder, wishes: SolutionWishes, students: Sequence[Candidate]) -> PrintRun:
    """How the worked solutions are printed. Raises OptionError where those of some of the class
    would be others than those of the rest; BankError, or TemplateError, where texts are missing
    in the language.
    """
    kept = KeptExam(exam)
    if wishes.language:
        require_bank_language(kept.bank, wishes.language)
    printed = {"solutions": True, "solution_language": wishes.language}
    changed = dict(_list_changes(exam, wishes))
    if changed and len(students) < len(exam.head.everybody):
        raise OptionError(*map(_refuse_for_some, changed))
    return kept_run(exam, kept, **printed, **changed)


def _list_changes(exam: ExamFolder, wishes: SolutionWishes) -> Iterator[tuple[_Manner, object]]:
    """What is wished otherwise than the exam has it."""
    if wishes.method not in (None, exam.head.method):
        yield "method", wishes.method
    if wishes.cycle and not exam.head.cycle:
        yield "cycle", True


def _refuse_for_some(manner: _Manner) -> Fault:
    what, expected = Message(f"exam.one-{manner}"), Message(f"exam.{manner}-of-all")
    return Fault(f"--{manner}", what, expected, Message("exam.name-nobody"))


def _require_new(exam: ExamFolder, students: Sequence[Candidate]) -> None:
    """Raises OutputError where some of these students have worked solutions."""
    folder = exam.path / SOLUTIONS
    solved = [each.student for each in students if exam.solution_file(each.student).exists()]
    if solved:
        names = [*solved[:_NAMED], *(["..."] if len(solved) > _NAMED else [])]
        what = Message("exam.solved-already", count=len(solved), names=list_plainly(names))
        raise OutputError(
            Fault(
                str(folder),
                what,
                Message("exam.students-without-solutions"),
                Message("exam.replace-solutions"),
            )
        )


def _write_head(exam: ExamFolder, run: PrintRun, folder: Path) -> None:
    """What the folder says of its worked solutions, where that is new.

    Raises OutputError where a source would be lost that was edited by hand.
    """
    lost = list(find_edited(exam.path, exam.head, folder))
    if lost:
        raise refuse_edited(exam.path, lost)
    editable = digest_grown(exam, folder)
    head = structs.replace(exam.head, method=run.extras.method, cycle=run.cycle)
    if editable != exam.head.editable or head != exam.head:
        write_head(head, editable, folder)
