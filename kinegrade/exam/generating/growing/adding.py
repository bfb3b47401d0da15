"""`kinegrade generate --add`: late students get papers of an exam that exists, and no other
paper changes.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from msgspec import structs

from kinegrade.errors import OutputError, Problem
from kinegrade.exam.bank.blueprint import Blueprint
from kinegrade.exam.folder.contents import ANSWER_WORKBOOK, KEY, PAPERS, SOLUTIONS
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.exam.generating.complaints import list_complaints, require_none
from kinegrade.exam.generating.exam_files import write_blank_workbook, write_head, write_papers
from kinegrade.exam.generating.growing.added_answers import write_grown_answers
from kinegrade.exam.generating.growing.grown_class import LateClass, late_class
from kinegrade.exam.generating.growing.grown_folder import (
    copy_exam,
    digest_grown,
    open_grown_folder,
)
from kinegrade.exam.generating.hand_work import find_edited, refuse_edited
from kinegrade.exam.generating.key_books import list_spare_ids
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.generating.page_counts import list_longer_papers
from kinegrade.exam.generating.replacing.replaced_exam import read_replaced, required_secret
from kinegrade.exam.generating.replacing.same_sources import require_same_sources
from kinegrade.exam.printing.class_printing import count_processes, print_class
from kinegrade.exam.printing.head_record import candidate, make_exam_head
from kinegrade.exam.printing.key_pages import make_kept_keys
from kinegrade.exam.printing.paper_languages import require_languages
from kinegrade.exam.printing.printing import PrintRun, require_tools
from kinegrade.exam.printing.reprint import find_printed, kept_run
from kinegrade.exam.printing.room_booklets import write_room_booklets
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.figure.sketchbook import open_sketchbook
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.press.sheet import KeyPaper
from kinegrade.processes.executor import open_executor
from kinegrade.processes.garbage_collection import bulk_work

_NOBODY: Mapping[Candidate, Candidate] = MappingProxyType({})
_MISSING = {
    PAPERS: Message("exam.papers-missing"),
    SOLUTIONS: Message("exam.solutions-missing"),
}


@dataclass(frozen=True)
class Added:
    """How many papers were added, how many stay, what a person should look at, and what is said of
    numbers that several have and of a workbook that was typed into.
    """

    papers: int
    before: int
    complaints: tuple[Problem, ...]
    sharing: tuple[Message, ...]

    @property
    def summary(self) -> Message:
        """What was done, in one line."""
        stay = Message("exam.papers-stay", count=self.before)
        return Message("exam.papers-added", count=self.papers, stay=stay)


def add_students(
    path: Path,
    blueprint: Blueprint,
    roster: Roster,
    late: Roster,
    options: GenerateOptions,
) -> Added:
    """Add the students of `late` to the exam folder at `path`, which was generated from that
    blueprint for the students of that roster.

    Papers are printed as those of the folder were. Raises KinegradeError; then nothing is written.
    """
    exam = open_exam(path)
    kept = KeptExam(exam)
    changed = require_same_sources(exam, blueprint)
    students = late_class(exam, roster, late)
    run = _run(exam, kept, late)
    old = read_replaced(exam)
    jobs = count_processes(options.processes, len(students.together))
    processes = open_executor(jobs, "generate", cluster=options.cluster)
    book = open_sketchbook(jobs)
    with bulk_work(), open_grown_folder(exam) as folder, processes as workers, book as sketchbook:
        press = run.press_order.press()
        whole, secret = Roster(students.together, (), late.file), required_secret(exam)
        dealt = deal_exam(run.bank, whole, secret, workers, old.kept, sketchbook=sketchbook)
        said = list_complaints(students.late, press, dealt, strict=options.strict)
        _copy(exam, folder)
        with closing(
            print_class(run, replace(dealt, roster=students.late), workers, jobs)
        ) as papers:
            results = options.progress(papers, len(students.late.students))
            earlier = make_kept_keys(kept, exam.head.everybody)
            newcomers = students.late.students
            apart = list_spare_ids(exam.head)
            written = write_papers(folder, run, newcomers, results, earlier=earlier, spare=apart)
        longer = tuple(list_longer_papers(run, newcomers, written.pages))
        require_none(longer if options.strict else ())
        typed = write_rest(exam, folder, _grown_head(exam, dealt, run, students, written.keys))
    complaints, sharing = (*said, *longer), (*_list_changed(changed), *dealt.sharing(), *typed)
    return Added(len(newcomers), len(exam.students), complaints, sharing)


def _list_changed(templates: Sequence[str]) -> Iterator[Message]:
    """That the folder's copies of these hold, which another version of kinegrade shipped."""
    if templates:
        yield Message("exam.copies-hold", count=len(templates), files=list_plainly(templates))


def _run(exam: ExamFolder, kept: KeptExam, late: Roster) -> PrintRun:
    """Late papers are printed as the others were, in every kind of file that the folder has.

    Raises BankError where they cannot be in the language of a late student, OutputError where one
    with all papers is missing, as nothing could be added to it.
    """
    require_languages(kept.bank, exam.language, late)
    run = kept_run(exam, kept, **find_printed(exam))
    volumes = run.extras.folders
    missing = [name for name in volumes if not (exam.path / f"{name}.pdf").is_file()]
    if missing:
        raise OutputError(
            *(Fault(str(exam.path / f"{name}.pdf"), _MISSING[name]) for name in missing)
        )
    require_tools(run.extras)
    return run


def _copy(exam: ExamFolder, folder: Path) -> None:
    """All that stands in the exam folder; the last line of the key is ended, where it was not."""
    copy_exam(exam, folder)
    key = folder / KEY
    lines = key.read_bytes()
    if not lines.endswith(b"\n"):
        key.write_bytes(lines + b"\n")


def _grown_head(
    exam: ExamFolder, dealt: ClassDeal, run: PrintRun, students: LateClass, keys: Iterable[KeyPaper]
) -> ExamHead:
    newcomers = map(candidate, students.late.students, keys)
    head = make_exam_head(dealt, (*exam.head.students, *newcomers), run)
    before = exam.head
    return structs.replace(
        head,
        spares=before.spares,
        corrections=before.corrections,
        papers_before=before.papers_before,
        given=before.given,
    )


def _describe_kept_workbook(exam: ExamFolder, head: ExamHead) -> Message:
    """What is to be said of a workbook that stays as it was typed: that it has no row for those who
    are new, or that it has the ids or codes that students had before.
    """
    file = str(exam.path / ANSWER_WORKBOOK)
    changed = [each for each in head.students if each.student not in exam.head.candidates]
    new = [each for each in changed if not exam.head.candidates.keys() & set(each.formerly)]
    if new:
        students = list_plainly([Quoted(each.student) for each in new])
        return Message("exam.workbook-stays", file=file, students=students)
    if changed:
        return Message("exam.workbook-has-old-ids", file=file)
    return Message("exam.workbook-has-old-codes", file=file)


def write_rest(
    exam: ExamFolder,
    folder: Path,
    head: ExamHead,
    passed_on: Mapping[Candidate, Candidate] = _NOBODY,
) -> tuple[Message, ...]:
    """The booklets of rooms, the answer sheets, with what was typed into them, and the head; gives
    what is to be said of a workbook that has no row for those who are new. The rows of those who
    are `passed_on` are those of others now.

    Raises OutputError where a file would be lost that was edited by hand, TableError.
    """
    write_room_booklets(folder, head, exam)
    write_grown_answers(exam.path, head, folder, passed_on)
    write_blank_workbook(head, folder)
    lost = list(find_edited(exam.path, exam.head, folder))
    said: tuple[Message, ...] = ()
    if ANSWER_WORKBOOK in lost:
        shutil.copy2(exam.path / ANSWER_WORKBOOK, folder / ANSWER_WORKBOOK)
        lost.remove(ANSWER_WORKBOOK)
        said = (_describe_kept_workbook(exam, head),)
    if lost:
        raise refuse_edited(exam.path, lost)
    write_head(head, digest_grown(exam, folder), folder)
    return said
