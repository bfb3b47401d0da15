"""What one student gets to read: their answers, the right answers, what probably went wrong, and
the points.

`make_feedback_sheets` makes the sheets of a class one by one; the press prints them, as HTML,
Markdown and PDF.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby
from types import MappingProxyType

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import HandMark
from kinegrade.marks_folder.layout import GRADES
from kinegrade.marks_folder.open_questions import OpenQuestion
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal, Subtracted
from kinegrade.marks_folder.subtractions import describe_subtracted
from kinegrade.press.sheet import FeedbackQuestion, FeedbackSheet
from kinegrade.question_numbers import find_bank_number, number_printed
from kinegrade.reports.feedback.answer_rows import list_givens, make_feedback_row
from kinegrade.reports.feedback.by_hand import (
    explain_hand_mark,
    make_by_hand,
    make_extra,
    make_left_out,
)
from kinegrade.reports.feedback.points import (
    head_question,
    say_bonus,
    write_points,
    write_share,
    write_total,
)
from kinegrade.reports.paper_record import PaperRecord, PaperRecords

_NO_OTHERS: Mapping[Language, Wording] = MappingProxyType({})


def make_feedback_sheets(
    marks: MarksFolder,
    exam: ExamFolder,
    wording: Wording,
    language: Language,
    own: Mapping[Language, Wording] = _NO_OTHERS,
) -> Iterator[tuple[Candidate, FeedbackSheet]]:
    """The sheets in the order of the roster, each with its student: in the language of the
    student's paper where `own` has its words. Raises TableError, ExamError, PolicyError.
    """
    head, totals = exam.head, marks.totals.by_student
    papers = PaperRecords.of_marks(exam, marks)
    worded = {language: wording, **own}
    by_hand = (each.question for each in head.by_hand)
    left_out = frozenset(filter(marks.leaves_out, by_hand))
    for student, answers in marks.answers_by_student():
        if student in marks.elsewhere:
            continue  # of another paper, which this exam does not have
        if student not in head.candidates or student not in totals:
            raise ExamError(_describe_other_exam(student, marks, exam))
        candidate, total = head.candidates[student], totals[student]
        paper_language = Language(candidate.language)
        spoken = paper_language if paper_language in own else language
        paper = papers.marked(student, (answer.column for answer in answers))
        others = _Others(
            candidate,
            head,
            total,
            marks.by_hand.get(student, {}),
            marks.open,
            left_out,
            marks.subtracted.get(student),
        )
        yield candidate, _make_sheet(answers, paper, worded[spoken], spoken, others)


def _make_sheet(
    answers: Sequence[MarkedAnswer],
    paper: PaperRecord,
    wording: Wording,
    language: Language,
    others: _Others,
) -> FeedbackSheet:
    """One student's sheet."""
    catalogue, candidate = open_catalogue(language), others.candidate
    return FeedbackSheet(
        language,
        wording.course or others.head.course,
        wording.exam or others.head.title,
        others.head.date,
        candidate.student,
        candidate.name,
        candidate.paper,
        write_total(others.total, others.still_open, catalogue),
        others.total.kept is not None,
        tuple(_order_questions(answers, paper, wording, others, catalogue)),
        grade=others.total.grade,
        subtracted=_write_subtracted(others, catalogue),
        large=candidate.print_format == "large-print",
    )


def _describe_other_exam(student: str, marks: MarksFolder, exam: ExamFolder) -> Fault:
    what = Message(
        "feedback.other-exam",
        student=Quoted(student),
        head=HEAD,
        grades=GRADES.name,
        exam=str(exam.path),
    )
    return Fault(str(marks.path), what)


@dataclass(frozen=True)
class _Others:
    """What is not in a student's lines of marks.csv: who it is, the exam's head, the totals, what
    was marked `by_hand`, what is still to be marked so or was `left_out`, and what was
    `subtracted`.
    """

    candidate: Candidate
    head: ExamHead
    total: StudentTotal
    by_hand: Mapping[str, HandMark]
    still_open: Sequence[OpenQuestion]
    left_out: frozenset[str]
    subtracted: Subtracted | None


def _write_subtracted(others: _Others, catalogue: Catalogue) -> str:
    """What was subtracted from a total and why, "" for nothing."""
    found = others.subtracted
    if found is None or others.total.kept:
        return ""
    points, reason = write_points(found.points, catalogue), describe_subtracted(found)
    return catalogue.text("feedback.subtracted", points=points, reason=reason)


def _order_questions(
    answers: Sequence[MarkedAnswer],
    paper: PaperRecord,
    wording: Wording,
    others: _Others,
    catalogue: Catalogue,
) -> Iterator[FeedbackQuestion]:
    """All questions in the order of the paper, those marked by hand between the others; what comes
    on top of everything last.
    """
    numbers = number_printed(paper.printed)
    marked = _make_questions(answers, paper, wording, others, catalogue)
    found = dict(zip(numbers, marked, strict=True))
    by_number = {int(find_bank_number(each.question)): each for each in others.head.by_hand}
    for number, each in by_number.items():
        title = wording.titles.get(each.question, each.title)
        mark = others.by_hand.get(each.question)
        if each.question in others.left_out:
            found[number] = make_left_out(number, each, title, catalogue)
        else:
            found[number] = make_by_hand(number, each, title, mark, catalogue)
    yield from (found[number] for number in sorted(found))
    extra = make_extra(others.by_hand, catalogue)
    yield from [extra] if extra else []


def _make_questions(
    answers: Sequence[MarkedAnswer],
    paper: PaperRecord,
    wording: Wording,
    others: _Others,
    catalogue: Catalogue,
) -> Iterator[FeedbackQuestion]:
    """The questions that are marked here, in the order of the paper; the points of those that are a
    bonus say so.
    """
    by_question = {
        question: tuple(group)
        for question, group in groupby(answers, lambda answer: answer.question)
    }
    numbers = number_printed(paper.printed)
    for number, question in zip(numbers, paper.printed, strict=True):
        asked = by_question.get(question, ())
        heading = catalogue.write(head_question(question, number))
        mark = others.by_hand.get(question)
        added = sum((answer.points for answer in asked), Fraction(0))
        points = mark.points if mark else added
        out_of = sum((answer.out_of for answer in asked), Fraction(0))
        rows = tuple(make_feedback_row(answer, paper, wording, catalogue) for answer in asked)
        share = write_share(points, out_of, catalogue)
        worth = say_bonus(share, catalogue) if question in others.head.bonus else share
        givens = ", ".join(list_givens(question, paper, wording, catalogue))
        note = explain_hand_mark(mark, catalogue)
        title = wording.titles.get(question, "")
        yield FeedbackQuestion(heading, title, worth, givens, rows, note)
