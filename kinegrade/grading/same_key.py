"""Marks go with the key by which they were given."""

from __future__ import annotations

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder


def require_same_key(exam: ExamFolder, marks: MarksFolder) -> None:
    """Raises TableError where answers of the exam were corrected after these marks."""
    if marks.corrections != exam.head.corrections:
        what, expected = Message("marks.another-key"), Message("marks.key-of-now")
        raise TableError(Fault(str(marks.path), what, expected, Message("exam.mark-again")))
