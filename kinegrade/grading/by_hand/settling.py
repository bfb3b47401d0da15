"""Marks by hand put in the place of those of the machine, which are kept beside them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

import msgspec

from kinegrade.exam.folder.asks import list_questions
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import is_answered
from kinegrade.files.tables import Complaint
from kinegrade.grading.marks import ClassGrades, MarkedBlock, list_points
from kinegrade.grading.policy.policy import Policy
from kinegrade.language.message import Message, Quoted, list_all, list_first
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.hand_marks import (
    EXTRA,
    ByHand,
    HandMark,
    find_only_by_hand,
    group_by_student,
    list_hand_marks,
    settle_points,
)
from kinegrade.marks_folder.layout import MANUAL, OPEN
from kinegrade.marks_folder.open_questions import OpenQuestion, describe_lacking
from kinegrade.marks_folder.rows import Grade
from kinegrade.numbers.amounts import add_amounts, write_amount
from kinegrade.question_numbers import sort_as_in_bank

_NAMED = 5  # students that a message names


@dataclass(frozen=True)
class HandMarking:
    """The marks `by_hand` of a class, with what the machine gave when they were decided; `machine`
    is what it gives now to the asks they are for, by student and column, as far as the class has
    been marked. Everybody has the points of asks `given_to_all`, and questions `dropped` are not
    waited for. Of those with marks by hand, `silent` have typed nothing.
    """

    by_hand: ByHand
    head: ExamHead
    given_to_all: Mapping[str, Fraction] = field(default_factory=dict)
    dropped: Set[str] = frozenset()
    machine: dict[str, Mapping[str, Fraction]] = field(default_factory=dict)
    silent: list[str] = field(default_factory=list)

    @classmethod
    def under(cls, policy: Policy, exam: ExamFolder, by_hand: ByHand) -> HandMarking:
        """The marks by hand of an exam that is marked under a policy."""
        given = policy.list_given(exam.asks)
        return cls(by_hand, exam.head, given, policy.dropped_by_hand)

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks; what the machine gave is noted on the way."""
        for block in blocks:
            papers = block.judged.rows.papers if self.by_hand else ()
            for row, paper in enumerate(papers):
                if marks := self.by_hand.get(paper.student):
                    found = list_points(block.judged, block.asks, row, marks)
                    self.machine[paper.student] = found
                    _, entry = block.judged.rows[row]
                    if not any(map(is_answered, entry.responses)):
                        self.silent.append(paper.student)
            yield block
            del block  # so that the next takes its place

    @cached_property
    def _marked(self) -> tuple[str, ...]:
        """The questions that a machine marks."""
        return list_questions(self.head.asks)

    @cached_property
    def _only(self) -> Mapping[str, Fraction]:
        """Those that only hands mark, which count for everybody."""
        marks = (mark for mark in list_hand_marks(self.by_hand) if not mark.ask)
        only = (replace(mark, machine=None) for mark in marks if mark.question not in self._marked)
        return find_only_by_hand(group_by_student(only))

    @cached_property
    def _questions(self) -> tuple[str, ...]:
        """All of both."""
        return sort_as_in_bank((*self._marked, *self._only)) if self._only else self._marked

    def describe_silent(self) -> Iterator[Message]:
        """Who typed nothing and has no point by hand, but counts as present by these marks; after
        all blocks have been watched.
        """
        nothing = [
            Quoted(student)
            for student in self.silent
            if not any(mark.points for mark in self.by_hand[student].values())
        ]
        if nothing:
            named = list_first(nothing, _NAMED)
            yield Message(
                "marking.present-by-zeros", count=len(nothing), students=named, file=MANUAL.name
            )

    @property
    def bonus(self) -> Set[str]:
        """What hands mark and comes on top of the maximum."""
        return {each.question for each in self.head.by_hand if each.bonus} | {EXTRA}

    def settle(self, grades: ClassGrades) -> Settled:
        """The grades with the marks by hand, after all blocks have been watched."""
        if not self.by_hand and not self.head.by_hand:  # as in most classes
            return Settled(grades, {}, (), {})
        beside = group_by_student(
            self._put_beside(mark, grade, self.machine[grade.student])
            for grade in grades.grades
            for mark in self.by_hand.get(grade.student, {}).values()
        )
        settled = [
            self.settle_grade(grade, self.machine.get(grade.student, {})) for grade in grades.grades
        ]
        still_open = tuple(self._list_open(settled))
        lacking = [_complain_of_lacking(each) for each in still_open if each.counts]
        complaints = (*self._list_lower(beside), *lacking, *grades.complaints)
        together = GradeList.of(settled)
        found = replace(grades, questions=self._questions, grades=together, complaints=complaints)
        extra = {name: points for name, points in self._only.items() if name in self.bonus}
        return Settled(found, beside, still_open, extra)

    def _list_lower(self, beside: ByHand) -> Iterator[Complaint]:
        """The marks that give less than everybody gets who handed in, or than the machine gives
        now, which gave less when they were decided.
        """
        for mark in list_hand_marks(beside):
            before = self.by_hand[mark.student][mark.column].machine
            if what := self._describe_lower_than_all(mark) or _describe_lower(mark, before):
                done = Message("marking.lower-stands", file=MANUAL.name)
                yield Complaint(MANUAL.name, None, mark.column, "", what, done)

    def _describe_lower_than_all(self, mark: HandMark) -> Message | None:
        """That a mark gives less than everybody gets for the asks that are void in its place."""
        void = {
            column: points
            for column, points in self.given_to_all.items()
            if column == mark.column or (not mark.ask and column.startswith(f"{mark.question}."))
        }
        everybody = add_amounts(void.values())
        if mark.points >= everybody:
            return None
        return Message(
            "marking.lower-than-all",
            student=Quoted(mark.student),
            points=write_amount(mark.points),
            all=write_amount(everybody),
            columns=list_all([*void]),
        )

    def _put_beside(
        self, mark: HandMark, grade: Grade, machine: Mapping[str, Fraction]
    ) -> HandMark:
        """The mark with what the machine gave in the same place."""
        if mark.ask:
            return replace(mark, machine=machine[mark.column])
        if mark.question not in self._marked:
            return replace(mark, machine=None)
        return replace(mark, machine=grade.points[self._marked.index(mark.question)])

    def settle_grade(self, grade: Grade, machine: Mapping[str, Fraction]) -> Grade:
        """A student's grade with the marks by hand, where the machine gave so much to each ask."""
        given = self.by_hand.get(grade.student, {}).values()
        if not given and not self._only:
            return grade
        both = zip(self._marked, grade.points, strict=True)
        own = {name: points for name, points in both if points is not None}
        marks = (self._put_beside(mark, grade, machine) for mark in given)
        points = settle_points({**own, **dict.fromkeys(self._only, Fraction(0))}, marks)
        more = (worth for name, worth in self._only.items() if name not in self.bonus)
        return msgspec.structs.replace(
            grade,
            points=tuple(map(points.get, self._questions)),
            out_of=grade.out_of + add_amounts(more),
        )

    def _list_open(self, grades: Iterable[Grade]) -> Iterator[OpenQuestion]:
        """Who is still to be marked by hand; where others have been, the absent are not."""
        everybody = list(grades)
        for each in self.head.by_hand:
            if each.question in self.dropped:
                continue
            counts = each.question in self._only
            students = tuple(
                grade.student
                for grade in everybody
                if each.question not in self.by_hand.get(grade.student, ())
                and not (counts and grade.absent)
            )
            if students:
                yield OpenQuestion(each.question, each.points, students, counts)


@dataclass(frozen=True, slots=True)
class Settled:
    """The grades, the marks by hand with what the machine gave beside them, who is still to be
    marked by hand, and what hands mark on top of the maximum.
    """

    grades: ClassGrades
    by_hand: ByHand
    still_open: tuple[OpenQuestion, ...]
    bonus: Mapping[str, Fraction]

    def list_marks(self) -> Iterator[HandMark]:
        """All marks by hand."""
        return list_hand_marks(self.by_hand)


def _describe_lower(mark: HandMark, before: Fraction | None) -> Message | None:
    """That a mark gives less than the machine, which gave what it did `before` when that was
    decided; None where there is nothing to say.
    """
    if mark.machine is None or mark.points >= mark.machine:
        return None
    if before is None or before >= mark.machine:
        return None
    student, points = Quoted(mark.student), write_amount(mark.points)
    now, then = write_amount(mark.machine), write_amount(before)
    return Message("marking.lower-than-now", student=student, points=points, now=now, before=then)


def _complain_of_lacking(question: OpenQuestion) -> Complaint:
    done = Message("marking.fill-in-open", file=OPEN.name)
    return Complaint(OPEN.name, None, "", "", describe_lacking(question), done)
