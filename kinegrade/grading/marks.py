"""The marks of a class: a verdict for every student and ask, and the totals.

`mark_blocks` is called by `grade` and gives the class in blocks, so that memory hardly grows with
the class; `mark` gives everything at once. `answer_lines` writes the result.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain, islice
from types import MappingProxyType
from typing import assert_never

from kinegrade.exam.folder.keys import Ask, Paper, Sitting, list_questions
from kinegrade.files.tables import Complaint, is_answered, shorten, trim
from kinegrade.grading.fast.block_judge import BlockJudge
from kinegrade.grading.fast.judged_block import USUAL_CREDITS, JudgedBlock, Row
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.policy.accepted import Alternatives
from kinegrade.grading.policy.policy import AS_PRINTED, Policy
from kinegrade.grading.sheets.pool import Pool
from kinegrade.grading.sheets.sheet import Entry, Sheet, find_repeated
from kinegrade.grading.typed.answers import Reading
from kinegrade.grading.typed.decimal_style import Mark as DecimalMark
from kinegrade.grading.typed.decimal_style import find_file_style
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.rows import Grade
from kinegrade.numbers.amounts import add_amounts

_BLOCK = 250  # papers marked together
_NO_ALTERNATIVES: Alternatives = MappingProxyType({})
_NO_POOL = Pool()


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
    """All grades in the order of the roster; complaints about the file first, then by line."""

    questions: tuple[str, ...]
    grades: tuple[Grade, ...]
    complaints: tuple[Complaint, ...]


@dataclass(frozen=True, slots=True)
class Marks(ClassGrades):
    """The grades and complaints of a class, and every mark, in the order of the roster and of the
    asks.
    """

    marks: tuple[Mark, ...]


@dataclass(frozen=True, slots=True)
class MarkedBlock:
    """The marks of some students; `asks` have their points under the policy, `judged` has a row for
    each grade.

    `general` holds, by reason, complaints about cells that were read as declared or decided for the
    whole file.
    """

    asks: tuple[Ask, ...]
    judged: JudgedBlock
    grades: Sequence[Grade]
    complaints: Sequence[Complaint]
    general: Mapping[Text, Sequence[Complaint]] = field(default_factory=dict)

    def marks(self) -> Iterator[Mark]:
        """Every single mark."""
        for place in range(len(self.judged.kinds)):
            row, number = divmod(place, len(self.asks))
            (verdict, share), ask = self.judged.decision(place), self.asks[number]
            yield Mark(
                self.judged.rows[row][0].student,
                ask,
                self.judged.cells.reading(place),
                verdict,
                share * ask.points,
            )


def mark(
    exam: Sitting,
    sheet: Sheet,
    decimal: DecimalMark | None = None,
    policy: Policy = AS_PRINTED,
    alternatives: Alternatives = _NO_ALTERNATIVES,
    *,
    follows: Follows | None = None,
    pool: Pool = _NO_POOL,
) -> Marks:
    """Marks a class. Raises nothing itself: what cannot be read gets no points and a complaint.

    `decimal` declares the decimal mark of the sheet; without it, unambiguous cells decide what
    1,234 means. `alternatives` are the policy's accepted answers, worked out; `follows` works out
    what follows from a student's answers; `pool` has the papers whose questions were put to others.
    """
    blocks = list(
        mark_blocks(exam, sheet, decimal, policy, alternatives, follows=follows, pool=pool)
    )
    found, marks = (
        collect_grades(exam, sheet, blocks),
        chain.from_iterable(block.marks() for block in blocks),
    )
    return Marks(found.questions, found.grades, found.complaints, tuple(marks))


def mark_blocks(
    exam: Sitting,
    sheet: Sheet,
    decimal: DecimalMark | None = None,
    policy: Policy = AS_PRINTED,
    alternatives: Alternatives = _NO_ALTERNATIVES,
    *,
    follows: Follows | None = None,
    pool: Pool = _NO_POOL,
) -> Iterator[MarkedBlock]:
    """The same in blocks, in the order of the roster. Raises ExamError where the papers cannot be
    read.
    """
    styles = find_file_style((entries[-1].responses for entries in sheet.entries.values()), decimal)
    judge = BlockJudge(exam.asks, policy, alternatives, styles, follows, exam.language)
    asks = tuple(policy.ruling(ask.column).ask(ask) for ask in exam.asks)
    marker = _Marker(sheet, judge, asks, add_amounts(ask.points for ask in asks), pool)
    papers = exam.papers()
    while block := list(islice(papers, _BLOCK)):
        yield marker.block(block)


def collect_grades(exam: Sitting, sheet: Sheet, blocks: Iterable[MarkedBlock]) -> ClassGrades:
    """What remains of the blocks: every student's points, and the complaints together with those
    about the sheet.
    """
    grades: list[Grade] = []
    complaints = list(sheet.complaints)
    general: dict[Text, list[Complaint]] = defaultdict(list)
    for block in blocks:
        grades += block.grades
        complaints += block.complaints
        for reason, alike in block.general.items():
            general[reason] += alike
    complaints += map(_merge_complaints, general.values())
    complaints.sort(key=_find_place)
    return ClassGrades(list_questions(exam.asks), tuple(grades), tuple(complaints))


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


@dataclass(frozen=True, slots=True)
class _Marker:
    """Everything needed to mark a class; `asks` have their points under the policy.

    `known` are the points of rows in which every answer gets all or nothing, by their indices into
    `JudgedBlock.credits`.
    """

    sheet: Sheet
    judge: BlockJudge
    asks: tuple[Ask, ...]
    out_of: Fraction
    pool: Pool
    known: dict[tuple[int, ...], tuple[Fraction, ...]] = field(default_factory=dict)

    def block(self, papers: Sequence[Paper]) -> MarkedBlock:
        """The marks of some papers."""
        rows = self._counted(papers)
        judged = self.judge.judged(rows)
        grades = [
            Grade(paper.student, paper.name, points, self.out_of, None, self._is_absent(paper))
            for (paper, _), points in zip(rows, self._points(judged), strict=True)
        ]
        complaints = [
            complaint
            for paper, entry in rows
            if len(self._entries(paper)) > 1
            for complaint in find_repeated(self._entries(paper), entry)
        ]
        general: dict[Text, list[Complaint]] = defaultdict(list)
        doubts = list(self._doubts(judged, general))
        return MarkedBlock(self.asks, judged, grades, [*complaints, *doubts], general)

    def _entries(self, paper: Paper) -> Sequence[Entry]:
        return self.sheet.entries[paper.student]

    def _is_absent(self, paper: Paper) -> bool:
        responses = chain.from_iterable(entry.responses for entry in self._entries(paper))
        return not any(map(is_answered, responses))

    def _row(self, paper: Paper, entry: Entry) -> Row:
        return self.pool.paper(paper, entry), entry

    def _counted(self, papers: Sequence[Paper]) -> list[Row]:
        """The row that counts for each student, as a whole; among equally good rows the last."""
        match self.judge.policy.attempts:
            case "first":
                return [self._row(paper, self._entries(paper)[0]) for paper in papers]
            case "last":
                return [self._row(paper, self._entries(paper)[-1]) for paper in papers]
            case "best":
                return self._best(papers)
            case _:
                assert_never(self.judge.policy.attempts)

    def _best(self, papers: Sequence[Paper]) -> list[Row]:
        rows = [self._row(paper, self._entries(paper)[-1]) for paper in papers]
        tried = [
            self._row(paper, entry)
            for paper in papers
            if len(self._entries(paper)) > 1
            for entry in self._entries(paper)
        ]
        best: dict[str, tuple[Fraction, Row]] = {}
        for row, points in zip(tried, self._points(self.judge.judged(tried)), strict=True):
            total, student = add_amounts(points), row[0].student
            if student not in best or total >= best[student][0]:
                best[student] = total, row
        return [best[row[0].student][1] if row[0].student in best else row for row in rows]

    def _points(self, judged: JudgedBlock) -> Iterator[tuple[Fraction, ...]]:
        """The points of each row by question; there are few combinations, and each is added up
        once.
        """
        known = self.known if len(judged.credits) == USUAL_CREDITS else {}
        for first in range(0, len(judged.shares), len(self.asks)):
            way = tuple(judged.shares[first : first + len(self.asks)])
            if way not in known:
                known[way] = tuple(
                    [
                        self._question_points(judged, question, way)
                        for question in self.judge.questions
                    ]
                )
            yield known[way]

    def _question_points(
        self, judged: JudgedBlock, question: range, way: tuple[int, ...]
    ) -> Fraction:
        shares = [judged.credits[share] for share in way[question.start : question.stop]]
        return add_amounts(
            share * self.asks[number].points
            for number, share in zip(question, shares, strict=True)
            if share
        )

    def _doubts(
        self, judged: JudgedBlock, general: dict[Text, list[Complaint]]
    ) -> Iterator[Complaint]:
        """The complaints about single cells; those whose reason applies to the whole file go to
        `general`.
        """
        reasons = self.judge.styles.reasons
        for place, reading in judged.cells.readings.items():
            row, number = divmod(place, len(self.asks))
            file, line = judged.rows[row][1].place(number)
            column = self.sheet.columns[number]
            content, verdict = shorten(reading.typed), judged.kinds[place]
            if reading.kind in ("unreadable", "wrong unit"):
                points = judged.credits[judged.shares[place]] * self.asks[number].points
                done = (
                    Message("marking.some-points", verdict=verdict)
                    if points
                    else Message("marking.no-points", verdict=verdict)
                )
                yield Complaint(file, line, column, content, reading.reason, done)
            if reading.remark:
                said = Complaint(
                    file,
                    line,
                    column,
                    content,
                    reading.remark,
                    Message("marking.judged", verdict=verdict),
                )
                reason = _find_reason(reading.remark)
                if reason in reasons:
                    general[reason].append(said)
                else:
                    yield said


def _find_reason(remark: Text) -> Text:
    """Why a number was read as it was, where that alone is remarked on; "" otherwise."""
    reason = remark.parts.get("reason") if isinstance(remark, Message) else None
    return reason if isinstance(reason, str | Message) else ""
