"""Exams that stand beside marks, or beside another exam, and marks beside their exam: in the folder
around them, where no command names them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from kinegrade.errors import KinegradeError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.grading.same_key import identify_exam
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder, open_marks
from kinegrade.marks_folder.layout import MARKER


def find_later_keys(folders: Iterable[MarksFolder]) -> Iterator[Fault]:
    """A complaint for each folder of marks beside which their exam stands, corrected since; where
    a copy stands there that was not, nobody but people knows which of the two counts.
    """
    for marks in folders:
        beside = list(list_exams_of(marks))
        later = [str(each.path) for each in beside if each.head.corrections > marks.corrections]
        same = [str(each.path) for each in beside if each.head.corrections == marks.corrections]
        if later and same:
            what = Message("marks.another-key-than-copy", exam=later[0], copy=same[0])
            yield Fault(str(marks.path), what, do=Message("marks.which-counts"))
        elif later:
            what = Message("marks.another-key-beside", exam=later[0])
            yield Fault(str(marks.path), what, do=Message("exam.mark-again"))


def list_exams_around(folder: Path) -> Iterator[ExamFolder]:
    """The exams beside a folder; what is damaged there is passed over."""
    itself = folder.resolve()
    for file in sorted(itself.parent.glob(f"*/{HEAD}")):
        with suppress(KinegradeError):
            if file.parent != itself:
                yield open_exam(file.parent)


def list_marks_beside(exam: ExamFolder) -> Iterator[MarksFolder]:
    """The folders of marks of this exam beside it; what is damaged there is passed over."""
    identity = identify_exam(exam.head)
    for file in sorted(exam.path.resolve().parent.glob(f"*/{MARKER}")) if identity else ():
        with suppress(KinegradeError):
            marks = open_marks(file.parent)
            if marks.exam == identity:
                yield marks


def list_exams_of(marks: MarksFolder) -> Iterator[ExamFolder]:
    """The folders of the exam of these marks."""
    for exam in list_exams_around(marks.path) if marks.exam else ():
        if identify_exam(exam.head) == marks.exam:
            yield exam
