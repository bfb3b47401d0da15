"""The answers of another paper earn nothing by follow-through, and a person is told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

import pytest

from kinegrade.exam.exam_wording import ExamWording
from kinegrade.files.tables import parse_table
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.judging.trivial_answers import Own
from kinegrade.grading.marking import MarkingTerms, mark
from kinegrade.grading.marks import Marks
from kinegrade.grading.policy.policy import AS_PRINTED, Policy
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.reports.classes.words import explain_verdict, name_verdict
from kinegrade.reports.feedback.remarks import make_remark
from kinegrade.reports.paper_record import PaperRecord
from tests.grading.one_by_one import marks_one_by_one
from tests.grading.sitting_class import ASKS, sitting_class
from tests.said import said

Typed = Callable[[int], Mapping[str, Fraction]]
SITTING = sitting_class(40, 3)
COLUMNS = [ask.column for ask in SITTING.exam.asks]
COPIED = [column for column in COLUMNS if not column.startswith("q2")]


def whatever_is_right_next(
    student: str, question: str, own: Own, later: str
) -> tuple[Fraction, ...]:
    """Follow-through from which the answers of the next paper follow, from any others."""
    place = (int(student[1:]) + 1) % len(SITTING.exam.examinees)
    return (SITTING.key(place, f"{question}.{later}"),)


FOLLOWS = Follows(whatever_is_right_next)


def sheet_of(typed: Typed) -> Sheet:
    """The sheet of a class that answers so, and else rightly."""
    lines = [",".join(["student", *COLUMNS])]
    for place, examinee in enumerate(SITTING.exam.examinees):
        given = typed(place)
        values = [given.get(column, SITTING.key(place, column)) for column in COLUMNS]
        lines.append(",".join([examinee.student, *(f"{float(value):.6f}" for value in values)]))
    return read_sheet(parse_table("\n".join(lines).encode(), "answers.csv"), SITTING.exam)


def first_copies(columns: list[str]) -> Typed:
    """The first student answers these as is right on the second's paper."""
    return lambda place: {} if place else SITTING.copied(1, *columns)


def marked(typed: Typed, policy: Policy = AS_PRINTED) -> Marks:
    return mark(SITTING.exam, sheet_of(typed), MarkingTerms(policy, follows=FOLLOWS))


def kinds(marks: Marks) -> dict[str, str]:
    """The verdicts on the first student's answers that are not right."""
    return {
        each.ask.column: each.verdict.kind
        for each in marks.marks[: len(COLUMNS)]
        if each.verdict.kind != "right"
    }


def test_what_follows_from_the_answers_of_another_paper_earns_nothing() -> None:
    marks = marked(first_copies(COPIED))
    found = kinds(marks)
    assert set(found) == set(COPIED)
    assert set(found.values()) == {"wrong", "another paper"}
    assert marks.grades[0].points == (0, 4, 0, 0)


@pytest.mark.parametrize("questions", ["q1", "q3"])
def test_one_question_keeps_its_follow_through(questions: str) -> None:
    columns = [f"{questions}.{ask}" for ask in ASKS[questions]]
    assert "follow-through" in kinds(marked(first_copies(columns))).values()


def test_each_answer_decided_alone_says_the_same() -> None:
    sheet = sheet_of(lambda place: {} if place % 3 else SITTING.copied((place + 1) % 40, *COPIED))
    alone = marks_one_by_one(SITTING.exam, sheet, AS_PRINTED, follows=FOLLOWS)
    together = mark(SITTING.exam, sheet, MarkingTerms(follows=FOLLOWS)).marks
    assert [
        (each.student, each.ask.column, each.verdict.kind, said(each.verdict.reason), each.points)
        for each in together
    ] == [
        (each.student, each.ask.column, each.verdict.kind, said(each.verdict.reason), each.points)
        for each in alone
    ]
    assert any(each.verdict.kind == "another paper" for each in together), together


def test_a_person_is_told_in_words_that_accuse_nobody() -> None:
    marks = marked(first_copies(COPIED))
    assert [str(complaint) for complaint in marks.complaints] == [
        "answers.csv:2: q1.omega: the answers to q1, q3 and q4 are right on one other paper of the"
        " exam - judged without what follows from them; perhaps papers were mixed up"
    ]
    withheld = next(each for each in marks.marks if each.verdict.kind == "another paper")
    assert said(withheld.verdict.reason).endswith(
        "; nothing is taken to follow: the answers to this question, and to another one at least,"
        " are right on one other paper"
    )


def test_feedback_and_report_have_words_for_it() -> None:
    answer = MarkedAnswer(
        "s0", "q1", "v", "1", "1", "m/s", "another paper", Fraction(0), Fraction(2), ""
    )
    remark = make_remark(answer, PaperRecord((), {}, {}, {}), ExamWording())
    assert said(remark.prose) == (
        "This number, and your answers to another question, are right on another paper. Please"
        " check that you worked with the numbers of your own paper."
    )
    assert said(name_verdict("another paper")) == "right on another paper"
    assert said(explain_verdict("another paper")).endswith("; nothing is credited for following")
