"""A marked class as arrays: how many points each student got for each ask, and why points were
lost.

One pass over marks.csv and the key; the class report is built from it.
"""

from __future__ import annotations

from array import array
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import nan

import numpy as np

from kinegrade.errors import TableError
from kinegrade.exam.choices import Choice
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.grading.judging.hints import Hint, find_hint
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import ANSWERS, GRADES
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal
from kinegrade.numbers.written import read_number
from kinegrade.reports.classes.item_statistics import Points
from kinegrade.reports.classes.whole_questions import find_whole_shares
from kinegrade.reports.paper_record import PaperRecord, PaperRecords

_RIGHT, _BLANK = "right", "blank"
_UNEXPLAINED = "unexplained"
_UNKNOWN = PaperRecord((), {}, {}, {})  # of another exam


@dataclass(frozen=True)
class ClassTally:
    """The students who answered anything; `points` has a row for each, and a column for each of
    `columns`, NaN where a student's paper does not ask that. `whole` are by question the shares of
    its points that a hand gave for it as a whole, NaN for who has no such mark.

    `answered` are these students, `silent` those who answered nothing. `verdicts` counts verdicts
    by ask. `losses` counts by ask why points were lost: the identifier of a mistake, a kind of
    hint, a verdict, or `_UNEXPLAINED`. `difficulties` are those predicted, by question; NaN where
    none is. `versions` and `groups` are those of the students who answered, "" for none.
    """

    columns: tuple[str, ...]
    out_of: Points
    answered: tuple[StudentTotal, ...]
    silent: tuple[StudentTotal, ...]
    points: Points
    verdicts: Mapping[str, Counter[str]]
    losses: Mapping[str, Counter[str]]
    versions: tuple[str, ...]
    groups: tuple[str, ...]
    parameters: Mapping[tuple[str, str], Points]
    difficulties: Mapping[str, Points]
    whole: Mapping[str, Points] = field(default_factory=dict)

    def share(self, question: str) -> Points:
        """Each student's share of the points of a question, as grades.csv has them; NaN where the
        question has no points for that student.
        """
        places = [
            place for place, column in enumerate(self.columns) if column.split(".")[0] == question
        ]
        out_of = float(self.out_of[places].sum())
        shares: Points = self.points[:, places].sum(axis=1) / (out_of or np.nan)
        by_hand = self.whole.get(question)
        return shares if by_hand is None else np.where(np.isnan(by_hand), shares, by_hand)

    @property
    def lost(self) -> Points:
        """Each student's share of the points that were lost, of those that there were; NaN where
        there were none.
        """
        given = np.where(np.isnan(self.points), 0.0, self.out_of).sum(axis=1)
        lost: Points = 1 - np.nansum(self.points, axis=1) / np.where(given > 0, given, nan)
        return lost

    def merge_alternatives(self, choices: Iterable[Choice]) -> Points:
        """The points with one column for all questions of a choice in place of theirs: what a
        student has of those that the paper holds.
        """
        questions = np.array([column.split(".")[0] for column in self.columns])
        merged, left = [], np.ones(len(questions), dtype=bool)
        for choice in choices:
            members = np.isin(questions, choice.questions)
            merged.append(np.nansum(self.points[:, members], axis=1))
            left &= ~members
        points: Points = np.column_stack([self.points[:, left], *merged])
        return points

    @cached_property
    def percents(self) -> Sequence[float]:
        """The totals as percentages, as in grades.csv; 0 where there are no points to get."""
        return [float(100 * each.share) for each in self.answered]


@dataclass
class _Count:
    """Accumulates the class student by student."""

    answered: list[StudentTotal] = field(default_factory=list)
    silent: list[StudentTotal] = field(default_factory=list)
    columns: tuple[str, ...] = ()
    out_of: dict[str, float] = field(default_factory=dict)
    points: array[float] = field(default_factory=lambda: array("d"))  # row after row
    verdicts: dict[str, Counter[str]] = field(default_factory=dict)
    losses: dict[str, Counter[str]] = field(default_factory=dict)
    versions: list[str] = field(default_factory=list)
    groups: list[str] = field(default_factory=list)
    parameters: list[array[float]] = field(default_factory=list)
    difficulties: list[Mapping[str, float]] = field(default_factory=list)
    names: tuple[tuple[str, str], ...] = ()  # of the parameters of all papers so far

    def include(
        self,
        total: StudentTotal,
        answers: Sequence[MarkedAnswer],
        paper: PaperRecord,
        candidate: Candidate | None,
    ) -> None:
        """Adds a student who answered something."""
        self.answered.append(total)
        got = {answer.column: float(answer.points) for answer in answers}
        self.points.extend([got.get(column, nan) for column in self.columns])
        self.versions.append(candidate.version if candidate else "")
        self.groups.append(candidate.group if candidate else "")
        self.names += tuple(name for name in paper.parameters if name not in self.names)
        self.parameters.append(array("d", (paper.parameters.get(name, nan) for name in self.names)))
        self.difficulties.append(paper.difficulties)
        for answer in answers:
            if answer.column not in self.verdicts:
                continue  # asked in another exam alone
            self.verdicts[answer.column][answer.verdict] += 1
            if answer.points < answer.out_of:
                self.losses[answer.column][_loss(answer, paper)] += 1


def tally(marks: MarksFolder, exam: ExamFolder) -> ClassTally:
    """Counts a marks folder, with the exam folder it was made from. Raises TableError,
    ExamError.
    """
    papers, totals = PaperRecords.of_marks(exam, marks), marks.totals.by_student
    count = _Count()
    orders = marks.printed if exam.head.choices else {}
    for student, answers in marks.answers_by_student():
        columns = tuple(answer.column for answer in answers)
        here = student not in marks.elsewhere
        if here:
            _open(count, exam.head, answers)
        asked = columns == _list_asked(count, orders.get(student))
        if (here and not asked) or student not in totals:
            what = Message("report.other-asks", student=Quoted(student), grades=GRADES.name)
            raise TableError(Fault(str(marks.path / ANSWERS.name), what))
        answered = any(answer.verdict != _BLANK and answer.typed.strip() for answer in answers)
        if answered or student in marks.by_hand:
            count.include(
                totals[student],
                answers,
                papers.marked(student, columns) if here else _UNKNOWN,
                exam.head.candidates.get(student),
            )
        else:
            count.silent.append(totals[student])
    return replace(_close(count), whole=find_whole_shares(count.answered, marks.by_hand))


def _open(count: _Count, head: ExamHead, answers: Sequence[MarkedAnswer]) -> None:
    """Takes the asks from the first student, or all of the exam where it has alternatives; and
    their points from the first student who has them.
    """
    if not count.columns:
        count.columns = head.columns if head.choices else tuple(each.column for each in answers)
        count.verdicts = {column: Counter() for column in count.columns}
        count.losses = {column: Counter() for column in count.columns}
    for answer in answers:
        count.out_of.setdefault(answer.column, float(answer.out_of))


def _list_asked(count: _Count, held: Sequence[str] | None) -> tuple[str, ...]:
    """The columns of a paper with these questions, None for all."""
    return tuple(column for column in count.columns if held is None or column.split(".")[0] in held)


def _close(count: _Count) -> ClassTally:
    points = np.array(count.points).reshape(len(count.answered), len(count.columns))
    numbers = np.full((len(count.parameters), len(count.names)), nan)
    for row, known in zip(numbers, count.parameters, strict=True):
        row[: len(known)] = known
    parameters = {name: numbers[:, place] for place, name in enumerate(count.names)}
    difficulties = {
        question: np.array([each.get(question, nan) for each in count.difficulties])
        for question in dict.fromkeys(chain.from_iterable(count.difficulties))
    }
    return ClassTally(
        count.columns,
        np.array([count.out_of.get(column, 0.0) for column in count.columns]),
        tuple(count.answered),
        tuple(count.silent),
        points,
        count.verdicts,
        count.losses,
        tuple(count.versions),
        tuple(count.groups),
        parameters,
        difficulties,
    )


def _loss(answer: MarkedAnswer, paper: PaperRecord) -> str:
    """Why an answer did not get all its points, in one term: that a hand marked it, a mistake, a
    kind of hint, or else the verdict.
    """
    if answer.by_hand:
        return answer.judged
    if answer.mistakes:
        return answer.mistakes[0]
    if answer.verdict != "wrong":
        return answer.verdict
    found = hint_of(answer, paper)
    return found.kind if found else _UNEXPLAINED


def hint_of(answer: MarkedAnswer, paper: PaperRecord) -> Hint | None:
    """The hint that the number of a wrong answer gives."""
    right = paper.answers.get(answer.column)
    if right is None or not answer.read_as:
        return None
    others = dict(_find_others(answer, paper))
    typed = read_number(answer.read_as)
    return find_hint(typed, right.value, right.rule, right.unit, others, coarse=right.coarse)


def _find_others(answer: MarkedAnswer, paper: PaperRecord) -> Iterator[tuple[str, Fraction]]:
    for column in paper.answers:
        if column != answer.column and column.startswith(f"{answer.question}."):
            yield column, paper.answers[column].value
