"""What other hands changed in an exam folder, as far as its files tell it: lines of the key that
are not those of the arrays written with it, and the paper of one student in the place of another's.
"""

from __future__ import annotations

from collections.abc import Iterator
from hashlib import file_digest

from kinegrade.exam.folder.contradictions import name_place
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language.message import Fault, Message, Quoted, list_plainly


def find_changed_keys(exam: ExamFolder) -> Iterator[Fault]:
    """That the key is not as it was written, and each question that has another key now."""
    if not exam.has_changed_key:
        return
    yield Fault(str(exam.keys.file), Message("archive.key-changed"))
    for (student, question), asks in exam.list_changed_keys().items():
        place = name_place(exam.keys.file, student, question)
        yield Fault(place, Message("archive.answers-changed", asks=list_plainly(asks)))


def find_copied_papers(exam: ExamFolder) -> Iterator[Fault]:
    """The printed papers that are the same file as another paper's."""
    first: dict[str, tuple[str, str]] = {}
    for candidate in exam.head.everybody:
        file = exam.path / candidate.file
        if not candidate.file or not file.is_file():
            continue
        with file.open("rb") as stream:
            digest = file_digest(stream, "sha256").hexdigest()
        paper = candidate.version or candidate.paper
        other, held_by = first.setdefault(digest, (candidate.file, paper))
        if held_by != paper:
            what = Message("archive.same-paper", other=other)
            do = Message("archive.print-anew", student=Quoted(candidate.student))
            yield Fault(str(file), what, do=do)
