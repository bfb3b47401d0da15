"""Questions in which nothing can follow from wrong answers, as their template cannot be read."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.folder.contents import TEMPLATES
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.tables import Complaint
from kinegrade.language.message import Message, list_all


def find_unfollowed(exam: ExamFolder) -> Iterator[Complaint]:
    """A complaint for each fault of a template that the exam keeps and this version cannot read;
    none where it keeps no templates at all, so that nothing was ever to follow.
    """
    if not (exam.path / TEMPLATES).is_dir():
        return
    readable = exam.templates.readable
    unread = [each.question for each in exam.head.questions if each.question not in readable]
    for fault in exam.templates.faults:
        what = Message("marking.unreadable-template", fault=fault)
        done = Message("marking.nothing-follows", questions=list_all(unread))
        yield Complaint(str(exam.head_file), None, "", "", what, done)
