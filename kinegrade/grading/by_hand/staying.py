"""Marks by hand that stay with students whose papers have changed hands, while their answers, which
were typed by codes, went with the papers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.ownership import list_moved
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.answer_file import AnswerFile
from kinegrade.grading.by_hand.hand_file import HandFile
from kinegrade.language.message import Fault, Message, list_first
from kinegrade.marks_folder.corrections import read_corrections
from kinegrade.marks_folder.hand_marks import EXTRA
from kinegrade.marks_folder.layout import MARKER

_NAMED = 5  # marks that a message names


@dataclass(frozen=True, slots=True)
class StayingMarks:
    """The papers of an exam that have changed hands, and the `codes` of those by which answers were
    typed, by student.
    """

    head: ExamHead
    codes: Mapping[str, str]

    @classmethod
    def of(cls, exam: ExamFolder, files: Iterable[AnswerFile]) -> StayingMarks:
        """Those of an exam whose answers stand in these files."""
        coded = {student for each in files for student in each.coded}
        owners = exam.codes.items() if coded else ()
        return cls(exam.head, {student: code for code, student in owners if student in coded})

    def describe(self, paths: Sequence[Path], files: Sequence[HandFile]) -> Iterator[Fault]:
        """Which marks of these files were given by ids and stay."""
        for path, file in zip(paths, files, strict=True):
            if staying := list(self._list_staying(path, file)):
                names = list_first(staying, _NAMED)
                what = Message("marking.staying-by-hand", count=len(staying), names=names)
                yield Fault(str(path), what, do=Message("marking.give-anew"))

    def _list_staying(self, path: Path, file: HandFile) -> Iterator[str]:
        """Those of students who have other papers than when the file could have been made: of one
        outside a folder of marks nothing is known, so it may be as old as the exam.
        """
        in_folder = (path.parent / MARKER).exists()
        moved = {*list_moved(self.head, read_corrections(path.parent) if in_folder else 0)}
        for row in (*file.rows, *file.left_out) if moved else ():
            mark = row.mark
            by_id = not mark.paper and mark.question != EXTRA
            if by_id and mark.student in moved and mark.student in self.codes:
                yield " ".join(mark.place)
