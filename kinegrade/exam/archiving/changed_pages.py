"""Printed papers that are not what follows from the exam: one that was edited, or printed of
another key.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from kinegrade import __version__
from kinegrade.errors import ExamError, Problem
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.printing.printing import PrintRun
from kinegrade.exam.printing.reprint import kept_run, print_again
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language.message import Fault, Location, Message, Quoted
from kinegrade.press.protocol import Press


def solve_again(
    exam: ExamFolder, sample: Sequence[Candidate], named: Set[Location]
) -> Iterator[Problem]:
    """What no longer follows from the values of these papers, and which printed ones are not, byte
    for byte, what is printed of them again; files that are `named` already are left out.

    Pages are compared where they were printed by this version and by Typst, as the bytes of other
    ones may differ, and where the key is as it was written, as far as that is known.
    """
    kept = KeptExam(exam)
    run = kept_run(exam, kept)
    press = run.press_order.press() if _can_compare(exam, run) else None
    for candidate in sample:
        try:
            paper = kept.paper(candidate)
        except ExamError as error:
            yield from error.faults
            continue
        if press is not None and str(exam.path / candidate.file) not in named:
            yield from _compare_pages(exam, candidate, run, paper, press)


def _can_compare(exam: ExamFolder, run: PrintRun) -> bool:
    head = exam.head
    printed = not (head.forgotten or head.unprinted or exam.has_changed_key)
    return printed and head.kinegrade == __version__ and run.press_order.engine == "typst"


def _compare_pages(
    exam: ExamFolder, candidate: Candidate, run: PrintRun, paper: SetPaper, press: Press
) -> Iterator[Fault]:
    file = exam.path / candidate.file
    if file.is_file() and file.read_bytes() != print_again(run, paper, press):
        do = Message("archive.print-anew", student=Quoted(candidate.student))
        yield Fault(str(file), Message("archive.other-pages"), do=do)
