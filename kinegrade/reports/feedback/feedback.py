"""What one student gets to read: their answers, the right answers, what probably went wrong, and
the points.

`make_feedback_sheets` makes the sheets of a class one by one; the press prints them, as HTML,
Markdown and PDF.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from math import isnan, nan
from types import MappingProxyType

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate, ExamHead, HandQuestion
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_math
from kinegrade.language.message import Fault, Message, Quoted, Text
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import GRADES
from kinegrade.marks_folder.open_questions import OpenQuestion, add_open_points
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal
from kinegrade.numbers.amounts import bound_rounding, write_amount
from kinegrade.press.sheet import FeedbackQuestion, FeedbackRow, FeedbackSheet
from kinegrade.question_numbers import find_bank_number, find_other_number, number_printed
from kinegrade.reports.feedback.remarks import make_remark, name_verdict
from kinegrade.reports.feedback.right_answers import (
    write_allowed,
    write_closed_form,
    write_decimal,
    write_with_unit,
)
from kinegrade.reports.paper_record import PaperRecord, PaperRecords

_LONGEST_TYPED = 80  # characters: the rest of a longer cell adds nothing
_GIVEN_DIGITS = 6
_NO_OTHERS: Mapping[Language, Wording] = MappingProxyType({})
_FULL, _PART, _NOTHING, _UNDECIDED = "✓", "(✓)", "✗", "–"  # told apart without colour


def make_feedback_sheets(
    marks: MarksFolder,
    exam: ExamFolder,
    wording: Wording,
    language: Language,
    own: Mapping[Language, Wording] = _NO_OTHERS,
) -> Iterator[tuple[Candidate, FeedbackSheet]]:
    """The sheets in the order of the roster, each with its student: in the language of the
    student's paper where `own` has its words. Raises TableError, ExamError.
    """
    head, totals = exam.head, marks.totals.by_student
    papers = PaperRecords(exam, marks.put)
    worded = {language: wording, **own}
    for student, answers in marks.answers_by_student():
        if student not in head.candidates or student not in totals:
            raise ExamError(_describe_other_exam(student, marks, exam))
        candidate, total = head.candidates[student], totals[student]
        paper_language = Language(candidate.language)
        spoken = paper_language if paper_language in own else language
        catalogue = open_catalogue(spoken)
        paper = papers.marked(student, (answer.column for answer in answers))
        gained = total.total - sum(answer.points for answer in answers)
        kept = gained > bound_rounding(len(answers))  # three written thirds fall short of a point
        yield (
            candidate,
            FeedbackSheet(
                spoken,
                worded[spoken].course or head.course,
                worded[spoken].exam or head.title,
                head.date,
                student,
                candidate.name,
                candidate.paper,
                _write_total(total, marks.open, catalogue),
                kept,
                tuple(_order_questions(answers, paper, worded[spoken], exam.head, catalogue)),
                grade=total.grade,
            ),
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


def _write_total(
    total: StudentTotal, still_open: Sequence[OpenQuestion], catalogue: Catalogue
) -> str:
    """Points out of the maximum, and what is still to be marked by hand."""
    share = _write_share(total.total, total.out_of, catalogue)
    if not still_open:
        return share
    points = _mark_decimals(write_amount(add_open_points(still_open)), catalogue)
    return catalogue.text("feedback.total-open", total=share, points=points)


def _order_questions(
    answers: Sequence[MarkedAnswer],
    paper: PaperRecord,
    wording: Wording,
    head: ExamHead,
    catalogue: Catalogue,
) -> Iterator[FeedbackQuestion]:
    """All questions in the order of the paper, those to be marked by hand between the others."""
    numbers = number_printed(paper.printed)
    marked = _make_questions(answers, paper, wording, head.bonus, catalogue)
    questions = zip(numbers, marked, strict=True)
    by_number = {int(find_bank_number(each.question)): each for each in head.by_hand}
    found = dict(questions)
    for number, each in by_number.items():
        title = wording.titles.get(each.question, each.title)
        found[number] = _make_open(number, each, title, catalogue)
    yield from (found[number] for number in sorted(found))


def _make_open(
    number: int, question: HandQuestion, title: str, catalogue: Catalogue
) -> FeedbackQuestion:
    """A question that is marked by hand."""
    points = _mark_decimals(write_amount(question.points), catalogue)
    worth = _say_bonus(points, catalogue) if question.bonus else points
    said = catalogue.text("feedback.by-hand", points=worth)
    heading = catalogue.write(_head_question(question.question, number))
    return FeedbackQuestion(heading, title, said, "", ())


def _make_questions(
    answers: Sequence[MarkedAnswer],
    paper: PaperRecord,
    wording: Wording,
    bonus: Container[str],
    catalogue: Catalogue,
) -> Iterator[FeedbackQuestion]:
    """The questions that are marked here, in the order of the paper; the points of those that are a
    `bonus` say so.
    """
    by_question = {
        question: tuple(group)
        for question, group in groupby(answers, lambda answer: answer.question)
    }
    numbers = number_printed(paper.printed)
    for number, question in zip(numbers, paper.printed, strict=True):
        asked = by_question.get(question, ())
        heading = catalogue.write(_head_question(question, number))
        points = sum((answer.points for answer in asked), Fraction(0))
        out_of = sum((answer.out_of for answer in asked), Fraction(0))
        rows = tuple(_make_feedback_row(answer, paper, wording, catalogue) for answer in asked)
        share = _write_share(points, out_of, catalogue)
        worth = _say_bonus(share, catalogue) if question in bonus else share
        givens = ", ".join(_list_givens(question, paper, wording, catalogue))
        yield FeedbackQuestion(heading, wording.titles.get(question, ""), worth, givens, rows)


def _say_bonus(points: str, catalogue: Catalogue) -> str:
    """Points that come on top of the maximum."""
    return catalogue.text("feedback.bonus", points=points)


def _list_givens(
    question: str, paper: PaperRecord, wording: Wording, catalogue: Catalogue
) -> Iterator[str]:
    """The numbers of a question as they were printed, each as prose; none where its asks were put
    with different ones.
    """
    for (asked, name), unit in wording.givens.items():
        number = paper.parameters.get((asked, name), nan)
        if asked == question and not isnan(number):
            shown = f"{number:.{_GIVEN_DIGITS}g}"
            relation = "=" if float(shown) == number else r"\approx"
            symbol = wording.parameters.get((asked, name), name)
            formula = _mark_formula(f"{symbol} {relation} {shown}", catalogue)
            yield write_with_unit(f"${formula}$", unit)


def _head_question(question: str, number: int) -> Message:
    other = find_other_number(question, number)
    if other is None:
        return Message("feedback.question", number=number)
    return Message("feedback.question-known", number=number, other=other)


def _make_feedback_row(
    answer: MarkedAnswer, paper: PaperRecord, wording: Wording, catalogue: Catalogue
) -> FeedbackRow:
    """The row for one answer."""
    right = paper.answers.get(answer.column)
    remark = make_remark(answer, paper, wording)
    prose = catalogue.write(remark.prose)
    return FeedbackRow(
        wording.symbols.get(answer.column, rf"\mathrm{{{answer.ask.replace('_', ' ')}}}"),
        wording.meanings.get(answer.column, ""),
        wording.conventions.get(answer.column, ""),
        _cut(answer.typed),
        catalogue.write(_describe_reading(answer, catalogue)),
        _mark_formula(write_closed_form(right), catalogue) if right else "",
        _mark_decimals(write_decimal(right), catalogue) if right else "",
        _mark_decimals(write_allowed(right), catalogue) if right else "",
        _choose_mark(answer),
        catalogue.write(name_verdict(answer.verdict)),
        _write_share(answer.points, answer.out_of, catalogue),
        prose,
        remark.guess,
        remark.note,
    )


def _cut(typed: str) -> str:
    return typed if len(typed) <= _LONGEST_TYPED else f"{typed[:_LONGEST_TYPED]}…"


def _mark_decimals(number: str, catalogue: Catalogue) -> str:
    """A number that is written with a decimal point, with the mark of the language."""
    return number.replace(".", catalogue.decimal_mark)


def _mark_formula(latex: str, catalogue: Catalogue) -> str:
    """A formula with the decimal mark of the language."""
    return write_decimals_of_math(latex, catalogue.language)


def _choose_mark(answer: MarkedAnswer) -> str:
    """The sign beside the verdict: whether all points were given, some, or none."""
    if answer.verdict in ("blank", "void"):
        return _UNDECIDED
    if answer.points >= answer.out_of:
        return _FULL
    return _PART if answer.points > 0 else _NOTHING


def _describe_reading(answer: MarkedAnswer, catalogue: Catalogue) -> Text:
    if answer.read_as in ("", answer.typed.strip()):
        return ""
    number = write_with_unit(answer.read_as, answer.unit).replace("-", "−")
    return Message("feedback.read-as", number=_mark_decimals(number, catalogue))


def _write_share(points: Fraction, out_of: Fraction, catalogue: Catalogue) -> str:
    """Points out of the maximum."""
    return _mark_decimals(f"{write_amount(points)} / {write_amount(out_of)}", catalogue)
