"""Worked solutions are given out after homework is due, and not before."""

from __future__ import annotations

from datetime import UTC, datetime

from kinegrade.deadlines.moment import is_past, parse_moment, write_moment
from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language.message import Fault, Message


def require_due_past(exam: ExamFolder) -> None:
    """Raises ExamError where an exam is still to be handed in; a time without its difference from
    UTC is taken in that of this machine.
    """
    due = parse_moment(exam.head.due)
    if due is not None and not is_past(due, datetime.now(UTC)):
        what = Message("exam.not-due", due=write_moment(due))
        expected, do = Message("exam.solutions-after"), Message("exam.before-due")
        raise ExamError(Fault(str(exam.path), what, expected, do))
