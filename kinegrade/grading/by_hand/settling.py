"""Marks by hand put in the place of those of the machine, which are kept beside them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import dataclass, field, replace
from fractions import Fraction

import msgspec

from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.tables import Complaint
from kinegrade.grading.marks import ClassGrades, MarkedBlock
from kinegrade.language.message import Message, Quoted
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


@dataclass(frozen=True)
class HandMarking:
    """The marks `by_hand` of a class, with what the machine gave when they were decided; `machine`
    is what it gives now to the asks they are for, by student and column, as far as the class has
    been marked. Asks `given_to_all` are void, and questions `dropped` are not waited for.
    """

    by_hand: ByHand
    head: ExamHead
    given_to_all: Set[str] = frozenset()
    dropped: Set[str] = frozenset()
    machine: dict[tuple[str, str], Fraction] = field(default_factory=dict)

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks; what the machine gave is noted on the way."""
        for block in blocks:
            papers = block.judged.rows.papers if self.by_hand else ()
            for row, paper in enumerate(papers):
                if marks := self.by_hand.get(paper.student):
                    self._note(block, row, marks)
            yield block
            del block  # so that the next takes its place

    def _note(self, block: MarkedBlock, row: int, marks: Mapping[str, HandMark]) -> None:
        """Notes what the machine gave to the asks that a person marked in a row."""
        student, first = block.judged.rows.papers[row].student, row * len(block.asks)
        for number, ask in enumerate(block.asks):
            if ask.column in marks:
                _, share = block.judged.decision(first + number)
                self.machine[student, ask.column] = share * ask.points

    @property
    def bonus(self) -> Set[str]:
        """What hands mark and comes on top of the maximum."""
        return {each.question for each in self.head.by_hand if each.bonus} | {EXTRA}

    def settle(self, grades: ClassGrades) -> Settled:
        """The grades with the marks by hand, after all blocks have been watched."""
        if not self.by_hand and not self.head.by_hand:  # as in most classes
            return Settled(grades, {}, (), {})
        beside = group_by_student(
            self._put_beside(mark, grade, grades.questions)
            for grade in grades.grades
            for mark in self.by_hand.get(grade.student, {}).values()
        )
        only = find_only_by_hand(beside)
        together = sort_as_in_bank((*grades.questions, *only))
        questions = together if only else grades.questions
        settled = [
            self._settle_grade(grade, grades.questions, questions, beside, only)
            for grade in grades.grades
        ]
        still_open = tuple(self._list_open(settled, only))
        lacking = [_complain_of_lacking(each) for each in still_open if each.counts]
        complaints = (*self._list_lower(beside), *lacking, *grades.complaints)
        found = replace(
            grades, questions=questions, grades=GradeList.of(settled), complaints=complaints
        )
        extra = {name: points for name, points in only.items() if name in self.bonus}
        return Settled(found, beside, still_open, extra)

    def _list_lower(self, beside: ByHand) -> Iterator[Complaint]:
        """The marks that give less than everybody gets who handed in, or than the machine gives
        now, which gave less when they were decided.
        """
        given = {*self.given_to_all, *(each.partition(".")[0] for each in self.given_to_all)}
        for mark in list_hand_marks(beside):
            before = self.by_hand[mark.student][mark.column].machine
            if what := _describe_lower(mark, before, to_all=mark.column in given):
                done = Message("marking.lower-stands", file=MANUAL.name)
                yield Complaint(MANUAL.name, None, mark.column, "", what, done)

    def _put_beside(self, mark: HandMark, grade: Grade, questions: tuple[str, ...]) -> HandMark:
        """The mark with what the machine gave in the same place."""
        if mark.ask:
            return replace(mark, machine=self.machine[mark.student, mark.column])
        if mark.question not in questions:
            return replace(mark, machine=None)
        return replace(mark, machine=grade.points[questions.index(mark.question)])

    def _settle_grade(
        self,
        grade: Grade,
        before: tuple[str, ...],
        questions: tuple[str, ...],
        beside: ByHand,
        only: Mapping[str, Fraction],
    ) -> Grade:
        marks = beside.get(grade.student, {}).values()
        if not marks and not only:
            return grade
        given = zip(before, grade.points, strict=True)
        machine = {name: points for name, points in given if points is not None}
        points = settle_points({**machine, **dict.fromkeys(only, Fraction(0))}, marks)
        more = add_amounts(worth for name, worth in only.items() if name not in self.bonus)
        return msgspec.structs.replace(
            grade,
            points=tuple(map(points.get, questions)),
            out_of=grade.out_of + more,
        )

    def _list_open(
        self, grades: Iterable[Grade], only: Mapping[str, Fraction]
    ) -> Iterator[OpenQuestion]:
        """Who is still to be marked by hand; where others have been, the absent are not."""
        everybody = list(grades)
        for each in self.head.by_hand:
            if each.question in self.dropped:
                continue
            counts = each.question in only
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


def _describe_lower(mark: HandMark, before: Fraction | None, *, to_all: bool) -> Message | None:
    """That a mark gives less than the machine, which gave what it did `before` when that was
    decided; None where there is nothing to say.
    """
    if mark.machine is None or mark.points >= mark.machine:
        return None
    student, points = Quoted(mark.student), write_amount(mark.points)
    now = write_amount(mark.machine)
    if to_all:
        return Message("marking.lower-than-all", student=student, points=points, all=now)
    if before is None or before >= mark.machine:
        return None
    then = write_amount(before)
    return Message("marking.lower-than-now", student=student, points=points, now=now, before=then)


def _complain_of_lacking(question: OpenQuestion) -> Complaint:
    done = Message("marking.fill-in-open", file=OPEN.name)
    return Complaint(OPEN.name, None, "", "", describe_lacking(question), done)
