"""What may be marked by hand in an exam: whose papers, which questions and asks, out of how many
points.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.ask_names import AskNames
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.student_names import StudentNames
from kinegrade.grading.by_hand.addresses import Addresses
from kinegrade.grading.policy.policy import Policy
from kinegrade.grading.same_key import identify_exam
from kinegrade.language.message import Message, Quoted, Text, list_plainly
from kinegrade.marks_folder.hand_marks import EXTRA
from kinegrade.numbers.amounts import add_amounts
from kinegrade.question_numbers import find_printed_number

_NUMBER = re.compile(r"[0-9]+")
_SHOWN = 4  # names that a message gives as examples


@dataclass(frozen=True, slots=True)
class Markable:
    """`maxima` are the points under the policy, by question and by ask; `orders` are the questions
    of each paper that has others than the exam, or in another order; the policy `dropped` some
    questions and asks. The exam is known by its `identity`; its `students` are as in the roster,
    `codes` those of their papers, `had` those that they had before an exchange, and `spares` papers
    of nobody; `addresses` are those of e-mail.
    """

    identity: str
    students: Sequence[str]
    ids: StudentIds
    codes: Mapping[str, str]
    had: Set[tuple[str, str]]
    spares: StudentIds
    people: StudentNames
    names: AskNames
    maxima: Mapping[str, Fraction]
    orders: Mapping[str, tuple[str, ...]]
    by_hand: tuple[str, ...]
    dropped: Set[str]
    addresses: Addresses

    @property
    def questions(self) -> Sequence[str]:
        """All questions that have points."""
        return [column for column in self.maxima if "." not in column]

    def find_student(self, cell: str) -> str | None:
        """The student with that id, code of a paper or address."""
        return self.ids.exact(cell) or self.addresses.find(cell)

    def is_held(self, student: str, question: str) -> bool:
        """Whether a student's paper holds a question."""
        if question in (*self.by_hand, EXTRA) or student not in self.orders:
            return True
        return question in self.orders[student]

    def describe_held(self, student: str, written: str) -> Text:
        """Which alternatives a student's paper holds for what is written of their number, "" for
        none.
        """
        number, order = _NUMBER.search(written), self.orders.get(student, ())
        held = [each for each in order if number and find_printed_number(each) == number[0]]
        names = list_plainly(held)
        return Message("marking.held", names=names, student=Quoted(student)) if held else ""

    def leaves_out(self, column: str, points: Fraction) -> bool:
        """Whether a mark is for what is dropped; one of nothing may explain what a machine marks,
        but lets count what only hands do.
        """
        return column in self.dropped and (points > 0 or column in self.by_hand)

    def explain_names(self) -> Message:
        """What can be marked, by examples."""
        shown = list_plainly([*self.by_hand, *self.names.columns][:_SHOWN])
        if self.names.shuffled:
            return Message("marking.names-shuffled", names=shown, extra=EXTRA)
        return Message("marking.names", names=shown, extra=EXTRA)


def find_markable(
    exam: ExamFolder, policy: Policy, orders: Mapping[str, tuple[str, ...]]
) -> Markable:
    """What may be marked by hand under a policy; `orders` are those of the papers that differ from
    the bank's.
    """
    head = exam.head
    by_hand = tuple(each.question for each in head.by_hand)
    asks = [policy.ruling(ask.column).ask(ask) for ask in exam.asks]
    maxima = {ask.column: ask.points for ask in asks}
    maxima |= {
        question: add_amounts(ask.points for ask in asks if ask.question == question)
        for question in exam.questions
    }
    maxima |= {each.question: each.points for each in head.by_hand}
    shuffled = any(
        list(order) != sorted(order, key=exam.questions.index) for order in orders.values()
    )
    ids, people = StudentIds(exam.students, exam.codes, exam.former_ids), StudentNames(exam.names)
    codes = {student: code for code, student in exam.codes.items()}
    spares = StudentIds((), {code: code for code in exam.spare_codes})
    names = AskNames(exam.head.columns, by_hand, shuffled)
    dropped = {column for column in maxima if _is_dropped(column, exam, policy)}
    dropped |= policy.dropped_by_hand
    now = exam.former_ids
    had = {(now.get(student, student), code) for student, code in exam.codes_before}
    students = exam.students, ids, codes, had, spares, people
    rules = names, maxima, orders, by_hand, dropped, Addresses(head.students)
    return Markable(identify_exam(head), *students, *rules)


def _is_dropped(column: str, exam: ExamFolder, policy: Policy) -> bool:
    """Whether an ask, or every ask of a question, is dropped."""
    asks = {ask.column for ask in exam.asks if column in (ask.column, ask.question)}
    return bool(asks) and asks <= policy.dropped
