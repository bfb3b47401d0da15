"""`kinegrade paper`: a paper of an exam, or its worked solutions, printed again from what its
folder keeps.

As numbers come from the folder and are held against its key, nothing is drawn, and no other
paper is printed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TypeVar, get_args

import msgspec
from msgspec import Struct

from kinegrade.errors import ExamError, Problem, suggest
from kinegrade.exam.folder.contents import PAPERS, SOLUTIONS
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import describe_damage, explain_broken
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.printing import Extras, PressOrder, PrintRun
from kinegrade.exam.roster.complaints import find_unprintable
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.students import make_student_key, read_place
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.press.protocol import Press

_Kind = TypeVar("_Kind")


class Reprint(Struct, frozen=True, dict=True):
    """One paper to be printed again."""

    run: PrintRun
    paper: SetPaper
    file: str

    def pages(self, *, large: bool = False) -> bytes:
        """The paper as PDF, in `large` print also for a student who has usual print. Raises
        TypesetError.
        """
        return print_again(self.run, self.paper, self._press, large=large)

    def solution(self, *, large: bool = False) -> bytes:
        """Its worked solutions as PDF, in `large` print as by `pages`. Raises TypesetError."""
        # Loads the whole of worked solutions
        from kinegrade.exam.printing.solution_pages import (  # noqa: PLC0415
            SolutionWriter,
            write_solution_sheet,
        )

        run = self.run
        writer = SolutionWriter(run.language, run.extras.method, cycle=run.cycle)
        sheet = write_solution_sheet(run.bank, self.paper, writer)
        sheet = replace(sheet, large=large or sheet.large)
        return self._press.solutions({self._name: sheet})[self._name].pdf

    def tactile(self) -> bytes:
        """Its figures for swell paper as a ZIP file. Raises TypesetError."""
        # Few papers need it
        from kinegrade.exam.printing.tactile_sheets import make_tactile_sheets  # noqa: PLC0415

        return make_tactile_sheets(self.paper, self.run.language)

    def complaints(self) -> tuple[Problem, ...]:
        """What a person should look at before it is handed out."""
        return tuple(find_unprintable((self.paper.student,), self.file, self._press))

    @property
    def _name(self) -> str:
        return self.paper.student.file_name

    @cached_property
    def _press(self) -> Press:
        return self.run.press_order.press()


def print_again(run: PrintRun, paper: SetPaper, press: Press, *, large: bool = False) -> bytes:
    """A paper as PDF, as `Reprint.pages` gives it. Raises TypesetError."""
    sheet = lay_out_paper(run.bank, paper, run.language)
    sheet = replace(sheet, pages=run.pages or 0, large=large or sheet.large)
    name = paper.student.file_name
    return run.bind(press.papers({name: sheet})[name]).pdf


def reprint(exam: ExamFolder, student: str) -> Reprint:
    """The paper of a student by id, or by its code, as it was generated.

    Raises ExamError where there is no such student, or where something else follows from the
    folder than its key says, BankError.
    """
    coded = {each.paper: each for each in exam.head.everybody if each.paper}
    code = StudentIds(exam.students, {each: each for each in coded}).coded(student)
    if code is not None and make_student_key(student) not in map(make_student_key, exam.students):
        return reprint_candidate(exam, coded[code])
    (candidate,) = find_candidates(exam, (student,))
    return reprint_candidate(exam, candidate)


def reprint_candidate(exam: ExamFolder, candidate: Candidate) -> Reprint:
    """The paper of a student, or a spare one, as it was generated. Raises ExamError where something
    else follows from the folder than its key says, BankError.
    """
    kept = KeptExam(exam)
    paper = kept.paper(candidate)
    return Reprint(kept_run(exam, kept), paper, str(exam.head_file))


def kept_run(exam: ExamFolder, kept: KeptExam, **extras: object) -> PrintRun:
    """How the papers of an exam were printed; earlier versions knew A4 and the bank's engine.

    Raises ExamError, BankError.
    """
    head = exam.head
    order = {"engine": head.engine or kept.bank.engine, "paper_size": head.paper_size or "a4"}
    worked = {"method": head.method, "cycle": head.cycle}
    return PrintRun(
        kept.bank,
        exam.language,
        _converted(exam, order, PressOrder),
        _converted(exam, {**worked, **extras}, Extras),
        pages=head.pages,
    )


def find_printed(exam: ExamFolder) -> Mapping[str, object]:
    """What of an exam is printed, as `kept_run` takes it."""
    return {
        "papers": not exam.head.unprinted,
        "solutions": (exam.path / SOLUTIONS).exists(),
        "also": find_kinds(exam),
    }


def find_kinds(exam: ExamFolder) -> tuple[str, ...]:
    """The kinds of files, besides PDF, in which the folder has papers."""
    # Papers alone are never printed by it
    from kinegrade.press.word.pandoc import Kind  # noqa: PLC0415

    places = [read_place(each.file) for each in exam.head.students]
    return tuple(
        kind
        for kind in get_args(Kind)
        if any((exam.path / PAPERS / f"{place}.{kind}").is_file() for place in places)
    )


def find_candidates(exam: ExamFolder, students: Sequence[str]) -> tuple[Candidate, ...]:
    """The students of these ids, or who had them before, and the spare papers of these names, each
    once, in the order of the roster. Raises ExamError with every id that nobody has.
    """
    known = {make_student_key(each.student): each for each in exam.head.everybody}
    now = {
        make_student_key(before): make_student_key(each) for before, each in exam.former_ids.items()
    }
    stated = {make_student_key(each): each for each in students}
    asked = {now.get(key, key): each for key, each in stated.items()}
    faults = [_explain_stranger(exam, asked[key]) for key in asked if key not in known]
    if faults:
        raise ExamError(*faults)
    return tuple(candidate for key, candidate in known.items() if key in asked)


def _explain_stranger(exam: ExamFolder, student: str) -> Fault:
    return Fault(
        str(exam.head_file),
        Message("exam.no-student", student=Quoted(student)),
        Message("exam.id-with-paper"),
        suggest(student, exam.students),
    )


def _converted(exam: ExamFolder, stated: Mapping[str, object], kind: type[_Kind]) -> _Kind:
    try:
        return msgspec.convert(stated, kind)
    except msgspec.ValidationError as fault:
        raise explain_broken(exam.head_file, [describe_damage(fault)]) from fault
