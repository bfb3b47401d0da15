"""The marks of a class: a verdict for every student and ask, and the totals.

`marking` makes them in blocks, `answer_lines` writes them.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from kinegrade.errors import Problem
from kinegrade.exam.folder.asks import Ask, list_questions
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.files.cell_text import trim
from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.grade_list import GradeList


@dataclass(frozen=True, slots=True)
class Mark:
    """One answer of one student, judged; `ask` has the points it has under the policy."""

    student: str
    ask: Ask
    reading: Reading
    verdict: Verdict
    points: Fraction


@dataclass(frozen=True, slots=True)
class ClassGrades:
    """All grades in the order of the roster; complaints about the file first, then by line; notes
    on marks by hand.
    """

    questions: tuple[str, ...]
    grades: GradeList
    complaints: tuple[Complaint, ...]
    notes: tuple[Problem, ...] = field(default=(), kw_only=True)


@dataclass(frozen=True, slots=True)
class Marks(ClassGrades):
    """The grades and complaints of a class, and every mark, in the order of the roster and of the
    asks.
    """

    marks: tuple[Mark, ...]


@dataclass(frozen=True, slots=True)
class MarkedBlock:
    """The marks of some students; `asks` have their points under the policy, `judged` has a row for
    each grade; all blocks of a marking share the patterns of grades.

    `general` holds, by reason, complaints about cells that were read as declared or decided for the
    whole file.
    """

    asks: tuple[Ask, ...]
    judged: JudgedBlock
    grades: GradeList
    complaints: Sequence[Complaint]
    general: Mapping[Text, Sequence[Complaint]] = field(default_factory=dict)

    def marks(self) -> Iterator[Mark]:
        """Every single mark."""
        for place in range(len(self.judged.kinds)):
            row, number = divmod(place, len(self.asks))
            if number in self.judged.rows.papers[row].lacks:
                continue
            (verdict, share), ask = self.judged.decision(place), self.asks[number]
            yield Mark(
                self.judged.rows.papers[row].student,
                ask,
                self.judged.cells.reading(place),
                verdict,
                share * ask.points,
            )


def list_points(
    judged: JudgedBlock, asks: Sequence[Ask], row: int, wanted: Container[str]
) -> Mapping[str, Fraction]:
    """The points in a row of those asks whose columns are wanted, by column."""
    shares = judged.shares[row * len(asks) : (row + 1) * len(asks)].tolist()
    return {
        ask.column: judged.credits[share] * ask.points
        for ask, share in zip(asks, shares, strict=True)
        if ask.column in wanted
    }


def collect_grades(exam: Sitting, sheet: Sheet, blocks: Iterable[MarkedBlock]) -> ClassGrades:
    """What remains of the blocks: every student's points, and the complaints together with those
    about the sheet.
    """
    grades: list[GradeList] = []
    complaints = list(sheet.complaints)
    general: dict[Text, list[Complaint]] = defaultdict(list)
    for block in blocks:
        grades.append(block.grades)
        complaints += block.complaints
        for reason, alike in block.general.items():
            general[reason] += alike
        del block  # so that the next takes its place
    complaints += map(_merge_complaints, general.values())
    complaints.sort(key=_find_place)
    together = GradeList.joined(grades)
    return ClassGrades(list_questions(exam.asks), together, tuple(complaints))


def _find_place(complaint: Complaint) -> tuple[str, int]:
    """The sort key of a complaint: first those about no single line, then file by file."""
    return ("", 0) if complaint.line is None else (complaint.file, complaint.line)


def _merge_complaints(alike: Sequence[Complaint]) -> Complaint:
    """One complaint for all cells that were read for the same reason; the first is the example."""
    first = alike[0]
    if len(alike) == 1:
        return first
    files = ", ".join(dict.fromkeys(each.file for each in alike))
    problem = Message(
        "marking.alike", count=len(alike), first=trim(first.content), problem=first.problem
    )
    return Complaint(files, None, "", first.content, problem, Message("marking.as-read"))
