"""The marks of a class: a verdict for every student and ask, and the totals.

`mark` is called by `grade`; `report` writes what it gives.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from types import MappingProxyType

from kinegrade.grading.accepted import Alternatives
from kinegrade.grading.answers import Reading, read
from kinegrade.grading.decimal_style import FileStyle, file_style
from kinegrade.grading.decimal_style import Mark as DecimalMark
from kinegrade.grading.decision import decide, voided
from kinegrade.grading.judge import Verdict
from kinegrade.grading.key import Ask, Exam, Examinee
from kinegrade.grading.policy import AS_PRINTED, Attempts, Policy
from kinegrade.grading.sheet import Entry, Sheet, repeated
from kinegrade.tables import Complaint, shortened

_NO_ALTERNATIVES: Alternatives = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Mark:
    """One answer of one student, judged; the points of `ask` are those it has by the policy."""

    student: str
    ask: Ask
    reading: Reading
    verdict: Verdict
    points: Fraction


@dataclass(frozen=True, slots=True)
class Grade:
    """One student's points for each question, in the order of the paper, and in all.

    `kept` is the total that stands instead of the sum, where an earlier one was higher and nobody is to lose.
    """

    student: str
    name: str
    points: tuple[Fraction, ...]
    out_of: Fraction
    kept: Fraction | None = None

    @property
    def total(self) -> Fraction:
        """All points, or what was kept."""
        return sum(self.points, Fraction(0)) if self.kept is None else self.kept

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


def mark(
    exam: Exam,
    sheet: Sheet,
    decimal: DecimalMark | None = None,
    policy: Policy = AS_PRINTED,
    alternatives: Alternatives = _NO_ALTERNATIVES,
) -> Marks:
    """Marks a class. Never raises: what cannot be read gets no points, and a complaint.

    `decimal` declares the decimal mark of the sheet; without it, cells that leave no doubt tell what 1,234 means.
    `alternatives` are the policy's accepted answers, worked out.
    """
    styles = file_style((entries[-1].responses for entries in sheet.entries.values()), decimal)
    marker = _Marker(exam, policy, alternatives, styles)
    marks: list[Mark] = []
    grades: list[Grade] = []
    complaints = list(sheet.complaints)
    for examinee in exam.examinees:
        entries = sheet.entries[examinee.student]
        entry, judged = _counted([(each, marker.judged(examinee, each)) for each in entries], policy.attempts)
        marks += judged
        grades.append(_grade(exam, examinee, judged))
        complaints += repeated(sheet.file, entries, entry)
        complaints += _doubts(sheet, entry, judged)
    complaints.sort(key=lambda complaint: complaint.line or 0)
    return Marks(exam.questions, tuple(marks), tuple(grades), tuple(complaints))


@dataclass(frozen=True, slots=True)
class _Marker:
    """What it takes to mark one row."""

    exam: Exam
    policy: Policy
    alternatives: Alternatives
    styles: FileStyle

    def judged(self, examinee: Examinee, entry: Entry) -> list[Mark]:
        """The marks of one row, in the order of the asks."""
        style = self.styles.of_row(entry.responses)
        marks = []
        for ask, response in zip(self.exam.asks, entry.responses, strict=True):
            ruling, place = self.policy.ruling(ask.column), (examinee.student, ask.column)
            reader = partial(read, unit=ask.unit, style=style, convention=ask.sign)
            reading, now = reader(response), ruling.ask(ask)
            others = self.alternatives.get(place, ())
            verdict, share = decide(reading, examinee.keys[ask.column], ruling, others, reader)
            if ruling.void:
                verdict, share = voided((verdict, share), ruling, handed_in=entry.line is not None)
            marks.append(Mark(examinee.student, now, reading, verdict, share * now.points))
        return marks


def _counted(rows: Sequence[tuple[Entry, list[Mark]]], attempts: Attempts) -> tuple[Entry, list[Mark]]:
    """The row that counts, as a whole; of the best ones the last."""
    if attempts == "best":
        return max(reversed(rows), key=lambda row: sum(each.points for each in row[1]))
    return rows[0 if attempts == "first" else -1]


def _grade(exam: Exam, examinee: Examinee, judged: Sequence[Mark]) -> Grade:
    points = dict.fromkeys(exam.questions, Fraction(0))
    for each in judged:
        points[each.ask.question] += each.points
    out_of = sum((each.ask.points for each in judged), Fraction(0))
    return Grade(examinee.student, examinee.name, tuple(points.values()), out_of)


def _doubts(sheet: Sheet, entry: Entry, judged: Sequence[Mark]) -> Iterable[Complaint]:
    for column, each in zip(sheet.columns, judged, strict=True):
        content = shortened(each.reading.typed)
        if each.reading.kind in ("unreadable", "wrong unit"):
            done = f"{each.verdict.kind}, {'some' if each.points else 'no'} points"
            yield Complaint(sheet.file, entry.line, column, content, each.reading.reason, done)
        if each.reading.remark:
            yield Complaint(
                sheet.file, entry.line, column, content, each.reading.remark, f"judged {each.verdict.kind}"
            )
