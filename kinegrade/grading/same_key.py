"""Marks go with the exam, and the key, by which they were given."""

from __future__ import annotations

import re
from hmac import digest

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import ExamHead
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder

_BYTES = 8  # of what an exam is known by: enough to tell apart all that there are
_KNOWN_AS = re.compile(rf"[0-9a-f]{{{2 * _BYTES}}}")
_NAME_THEIR_EXAM = Message("exam.name-exam-of-marks")


def require_same_key(exam: ExamFolder, marks: MarksFolder) -> None:
    """Raises TableError for marks of another exam, and where answers of this one were corrected
    after them.
    """
    require_same_exam(exam, marks)
    if marks.corrections != exam.head.corrections:
        what, expected = Message("marks.another-key"), Message("marks.key-of-now")
        raise TableError(Fault(str(marks.path), what, expected, Message("exam.mark-again")))


def require_same_exam(exam: ExamFolder, marks: MarksFolder, do: Message = _NAME_THEIR_EXAM) -> None:
    """Raises TableError for marks of another exam, as far as both say which one they are."""
    if marks.exam and marks.exam != (identify_exam(exam.head) or marks.exam):
        what = Message("marks.another-exam", exam=str(exam.path))
        raise TableError(Fault(str(marks.path), what, do=do))


def require_unmerged(marks: MarksFolder) -> None:
    """Raises TableError for a folder put together of several exams, where that of one is meant:
    marks by hand and totals of another would be taken over.
    """
    if marks.elsewhere:
        what = Message("marks.merged", count=len(marks.elsewhere))
        raise TableError(Fault(str(marks.path), what, do=Message("marks.name-unmerged")))


def require_one_exam(first: MarksFolder, second: MarksFolder) -> None:
    """Raises TableError for markings of two exams, as far as both say of which one they are."""
    if first.exam and second.exam and first.exam != second.exam:
        what, do = Message("marks.of-two-exams", other=str(first.path)), Message("marks.name-both")
        raise TableError(Fault(str(second.path), what, do=do))


def is_of_another_exam(cell: str, identity: str) -> bool:
    """Whether a cell says by what an exam is known, and it is not this one; people may have put
    anything else there.
    """
    return bool(identity and _KNOWN_AS.fullmatch(cell) and cell != identity)


def identify_exam(head: ExamHead) -> str:
    """By what marks know an exam, whoever is added to it and however often its key is corrected;
    empty where its secret was taken out of the folder.

    It tells nothing of the secret.
    """
    drawn_from = head.drawn_from
    if head.known_as or drawn_from is None:
        return head.known_as
    asked = [f"{each.question}={each.template}" for each in head.questions]
    whole = "\n".join((drawn_from.coding, *asked, *head.columns))
    return digest(drawn_from.drawing.encode(), whole.encode(), "sha256")[:_BYTES].hex()
