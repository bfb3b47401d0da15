"""Marking a class, block by block, so that memory hardly grows with the class.

`mark_blocks` is called by `grade`; `mark` gives everything at once.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from typing import assert_never

import msgspec
import numpy as np

from kinegrade.exam.folder.asks import Ask, add_counted
from kinegrade.exam.folder.papers import Paper, PaperBlock
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.files.cell_text import is_answered
from kinegrade.files.tables import Complaint
from kinegrade.grading.doubts import find_doubts, find_rows_of_others
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.block_judge import BlockJudge
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.grade_patterns import GradePatterns
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.lateness.submissions import Submissions
from kinegrade.grading.marks import MarkedBlock, Marks, collect_grades, list_points
from kinegrade.grading.policy.accepted import Alternatives
from kinegrade.grading.policy.policy import AS_PRINTED, Policy
from kinegrade.grading.sheets.alternatives import find_strange, leave_out
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.grid_entries import GridEntries, choose_block
from kinegrade.grading.sheets.pool import Pool
from kinegrade.grading.sheets.rows import Row, Rows
from kinegrade.grading.sheets.sheet import Sheet, find_repeated
from kinegrade.grading.sheets.sheet_style import find_sheet_style
from kinegrade.grading.typed.decimal_style import Mark as DecimalMark
from kinegrade.language.message import Text
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.rows import Grade, Submission

Settle = Callable[[Grade, Mapping[str, Fraction]], Grade]


def _leave_as_it_is(grade: Grade, _: Mapping[str, Fraction]) -> Grade:
    return grade


@dataclass(frozen=True, slots=True)
class MarkingTerms:
    """By what a sheet is marked beside its exam.

    `alternatives` are the policy's accepted answers, worked out. `decimal` declares the decimal
    mark of the sheet; without it, unambiguous cells decide what 1,234 means. `follows` works out
    what follows from a student's answers; `pool` has the papers whose questions were put to others.
    `by_hand` are those who have a mark by hand, and so handed in; `settle` gives a grade with these
    marks, from what the machine gave to each ask. With `own_papers` somebody has seen to it that
    all answered their own.
    """

    policy: Policy = AS_PRINTED
    alternatives: Alternatives = field(default_factory=dict)
    decimal: DecimalMark | None = None
    follows: Follows | None = None
    pool: Pool = field(default_factory=Pool)
    by_hand: Collection[str] = ()
    settle: Settle = _leave_as_it_is
    own_papers: bool = False


_BY_THE_PAPERS = MarkingTerms()


def mark(exam: Sitting, sheet: Sheet, terms: MarkingTerms = _BY_THE_PAPERS) -> Marks:
    """Marks a class. Raises nothing itself: what cannot be read gets no points and a complaint."""
    blocks = list(mark_blocks(PapersAnswered(exam), sheet, terms))
    found = collect_grades(exam, sheet, blocks)
    marks = chain.from_iterable(block.marks() for block in blocks)
    return Marks(found.questions, found.grades, found.complaints, tuple(marks))


def mark_blocks(papers: PapersAnswered, sheet: Sheet, terms: MarkingTerms) -> Iterator[MarkedBlock]:
    """The same in blocks, in the order of the roster. Raises ExamError where the papers cannot be
    read.
    """
    exam = papers.sitting
    styles, policy = find_sheet_style(sheet, terms.decimal), terms.policy
    judge = BlockJudge(papers, policy, terms.alternatives, styles, terms.follows)
    asks = tuple(policy.ruling(ask.column).ask(ask) for ask in exam.asks)
    submissions = Submissions(policy.penalties)
    patterns = GradePatterns(asks, papers.questions, add_counted(asks))
    marker = _Marker(sheet, judge, asks, terms, submissions, patterns)
    for block in exam.blocks(choose_block(len(exam.students))):
        yield marker.block(block)
        del block  # so that the next takes its place


@dataclass(frozen=True, slots=True)
class _Marker:
    """Everything needed to mark a class; `asks` have their points under the policy.

    `patterns` are the grades that were given so far.
    """

    sheet: Sheet
    judge: BlockJudge
    asks: tuple[Ask, ...]
    terms: MarkingTerms
    submissions: Submissions
    patterns: GradePatterns

    def block(self, papers: PaperBlock) -> MarkedBlock:
        """The marks of some papers."""
        rows = self._counted(papers)
        judged = self._judged(rows)
        grades = self._make_grades(rows, judged)
        complaints: list[Complaint] = []
        if not self.terms.own_papers:
            complaints += find_rows_of_others(judged, self.judge.papers, self.sheet.columns)
        for row in rows.papers.lacking:
            complaints += find_strange(*rows[row], self.asks, self.sheet.columns)
        for paper, entry in rows if self.sheet.repeated else ():
            if paper.student in self.sheet.repeated:
                complaints += find_repeated(self._entries(paper), entry)
        general: dict[Text, list[Complaint]] = defaultdict(list)
        for doubt in find_doubts(judged, self.asks, self.sheet.columns):
            if doubt.why in self.judge.styles.reasons:
                general[doubt.why].append(doubt.complaint)
            else:
                complaints.append(doubt.complaint)
        return MarkedBlock(self.asks, judged, grades, complaints, general)

    def _judged(self, rows: Rows) -> JudgedBlock:
        """These rows judged, by what their papers ask alone."""
        return self.judge.judged(leave_out(rows), self._handed_in)

    def _make_grades(self, rows: Rows, judged: JudgedBlock) -> GradeList:
        """A student's grade by each row; that of a paper without some alternatives is of the others
        alone.
        """
        which = self.patterns.find(rows, judged)
        blank = np.isnan(judged.cells.values.reshape(len(rows), -1))
        for row in np.flatnonzero(blank.all(axis=1)).tolist():  # without a number
            absent = not self._handed_in(rows.papers[row])
            which[row] = self.patterns.change(which[row], absent=absent)
        if self.submissions.penalties.are_any:
            for row, (paper, entry) in enumerate(rows):
                submission = self._find_submission(paper, entry)
                which[row] = self.patterns.change(which[row], submission=submission)
        return GradeList(rows.papers.students, rows.papers.names, which, self.patterns.grades)

    def _find_submission(self, paper: Paper, entry: Entry) -> Submission | None:
        """When and after how many others an entry was handed in, where that costs anything."""
        if not self.submissions.penalties.are_any:
            return None
        return self.submissions.find(paper.student, self._entries(paper), entry)

    def _entries(self, paper: Paper) -> Sequence[Entry]:
        return self.sheet.entries[paper.student]

    def _handed_in(self, paper: Paper) -> bool:
        """Whether a student answered anything, in any entry, or has a mark by hand."""
        responses = chain.from_iterable(entry.responses for entry in self._entries(paper))
        return paper.student in self.terms.by_hand or any(map(is_answered, responses))

    def _row(self, paper: Paper, entry: Entry) -> Row:
        return self.terms.pool.paper(paper, entry), entry

    def _counted(self, papers: PaperBlock) -> Rows:
        """The row that counts for each student, as a whole; among equally good rows the last."""
        entries = self.sheet.entries
        if isinstance(entries, GridEntries):
            return Rows(papers, entries.block(papers.students))
        match self.judge.policy.attempts:
            case "first":
                return Rows.of([self._row(paper, self._entries(paper)[0]) for paper in papers])
            case "last":
                return Rows.of([self._row(paper, self._entries(paper)[-1]) for paper in papers])
            case "best":
                return self._best(papers)
            case _:
                assert_never(self.judge.policy.attempts)

    def _best(self, papers: PaperBlock) -> Rows:
        rows = [self._row(paper, self._entries(paper)[-1]) for paper in papers]
        tried = Rows.of(
            [
                self._row(paper, entry)
                for paper in papers
                if len(self._entries(paper)) > 1
                for entry in self._entries(paper)
            ]
        )
        best: dict[str, tuple[Fraction, Row]] = {}
        judged, columns = self._judged(tried), {ask.column for ask in self.asks}
        for number, (row, which) in enumerate(
            zip(tried, self.patterns.find(tried, judged), strict=True)
        ):
            student = row[0].student
            grade = msgspec.structs.replace(self.patterns.grades[which], student=student)
            by_hand = student in self.terms.by_hand
            given = list_points(judged, self.asks, number, columns) if by_hand else {}
            total = self._find_net(row, self.terms.settle(grade, given))
            if student not in best or total >= best[student][0]:
                best[student] = total, row
        return Rows.of([best[row[0].student][1] if row[0].student in best else row for row in rows])

    def _find_net(self, row: Row, grade: Grade) -> Fraction:
        """The total of a row without what being late and trying again costs."""
        submission = self._find_submission(*row)
        if submission is None:
            return grade.total
        penalties = self.submissions.penalties
        return grade.total - penalties.subtract(submission, grade.total, grade.out_of)
