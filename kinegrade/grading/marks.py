"""The marks of a class: a verdict for every student and ask, and the totals.

`mark` is called by `grade`; `report` writes what it gives.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.grading.answers import Reading, read
from kinegrade.grading.decimal_style import FileStyle, file_style
from kinegrade.grading.decimal_style import Mark as DecimalMark
from kinegrade.grading.judge import Verdict, judge
from kinegrade.grading.key import Ask, Exam, Examinee
from kinegrade.grading.number_text import DecimalStyle
from kinegrade.grading.sheet import Entry, Sheet
from kinegrade.tables import Complaint, shortened


@dataclass(frozen=True, slots=True)
class Mark:
    """One answer of one student, judged."""

    student: str
    ask: Ask
    reading: Reading
    verdict: Verdict
    points: Fraction


@dataclass(frozen=True, slots=True)
class Grade:
    """One student's points for each question, in the order of the paper, and in all."""

    student: str
    name: str
    points: tuple[Fraction, ...]
    out_of: Fraction

    @property
    def total(self) -> Fraction:
        """All points."""
        return sum(self.points, Fraction(0))

    @property
    def percent(self) -> Fraction:
        """Of the points there are; 0 where there are none."""
        return 100 * self.total / self.out_of if self.out_of else Fraction(0)


@dataclass(frozen=True, slots=True)
class Marks:
    """All marks and grades in the order of the roster; complaints about the file first, then by line."""

    questions: tuple[str, ...]
    marks: tuple[Mark, ...]
    grades: tuple[Grade, ...]
    complaints: tuple[Complaint, ...]


def mark(exam: Exam, sheet: Sheet, decimal: DecimalMark | None = None) -> Marks:
    """Marks a class. Never raises: what cannot be read gets no points, and a complaint.

    `decimal` declares the decimal mark of the sheet; without it, cells that leave no doubt tell what 1,234 means.
    """
    styles = file_style((entry.responses for entry in sheet.entries.values()), decimal)
    marks: list[Mark] = []
    grades: list[Grade] = []
    complaints = list(sheet.complaints)
    for examinee in exam.examinees:
        entry = sheet.entries[examinee.student]
        judged = _judged(exam.asks, examinee, entry, styles)
        marks += judged
        grades.append(_grade(exam, examinee, judged))
        complaints += _doubts(sheet, entry, judged)
    complaints.sort(key=lambda complaint: complaint.line or 0)
    return Marks(exam.questions, tuple(marks), tuple(grades), tuple(complaints))


def _judged(asks: Sequence[Ask], examinee: Examinee, entry: Entry, styles: FileStyle) -> list[Mark]:
    style = styles.of_row(entry.responses)
    return [
        _judged_answer(ask, examinee, response, style)
        for ask, response in zip(asks, entry.responses, strict=True)
    ]


def _judged_answer(ask: Ask, examinee: Examinee, response: str, style: DecimalStyle) -> Mark:
    reading = read(response, ask.unit, style, ask.sign)
    verdict = judge(reading, examinee.keys[ask.column])
    points = ask.points if verdict.kind == "right" else Fraction(0)
    return Mark(examinee.student, ask, reading, verdict, points)


def _grade(exam: Exam, examinee: Examinee, judged: Sequence[Mark]) -> Grade:
    points = dict.fromkeys(exam.questions, Fraction(0))
    for each in judged:
        points[each.ask.question] += each.points
    out_of = sum((each.ask.points for each in judged), Fraction(0))
    return Grade(examinee.student, examinee.name, tuple(points.values()), out_of)


def _doubts(sheet: Sheet, entry: Entry, judged: Sequence[Mark]) -> Iterable[Complaint]:
    for column, each in zip(sheet.columns, judged, strict=True):
        content = shortened(each.reading.typed)
        if each.verdict.kind in ("unreadable", "wrong unit"):
            done = f"{each.verdict.kind}, no points"
            yield Complaint(sheet.file, entry.line, column, content, each.verdict.reason, done)
        if each.reading.remark:
            yield Complaint(
                sheet.file, entry.line, column, content, each.reading.remark, f"judged {each.verdict.kind}"
            )
