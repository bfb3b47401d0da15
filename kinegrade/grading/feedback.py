"""What one student gets to read: their answers, the right answers, what probably went wrong, and
the points.

`make_feedback_sheets` makes the sheets of a class one by one; `feedback_html`, `feedback_markdown`
and `kinegrade.press.typst.feedback` (PDF) print them. Three kinds of text, as in an exam: plain,
prose (Markdown with `$...$` LaTeX math), math (LaTeX).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction
from itertools import groupby
from typing import assert_never

from kinegrade.amounts import PLACES, write_amount
from kinegrade.errors import ExamError
from kinegrade.exact.written import read_number
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.grading.class_tally import hint_of, mistakes_of
from kinegrade.grading.feedback_words import FULL, FeedbackWords, choose_feedback_words
from kinegrade.grading.hints import Hint
from kinegrade.grading.math_html import write_unit_text
from kinegrade.grading.paper_record import PaperRecord, PaperRecords, RightAnswer
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import GRADES
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.question_numbers import find_other_number

_LONGEST_TYPED = 80  # characters: the rest of a longer cell adds nothing
_LONGEST_EXACT = 32
_POLICY = "policy"  # in the reason of a verdict by a tolerance other than the paper's
_CLOSED_FORM = re.compile(r"(?:[-+*/() 0-9]|sqrt|pi)+")


@dataclass(frozen=True)
class FeedbackRow:
    """One ask. `remark` is prose for the student, `guess` is whether the remark is a guess;
    `reason` is the note made on reading the cell.
    """

    symbol: str  # math
    meaning: str  # prose
    typed: str  # plain, as are the next four
    read_as: str  # "" where nothing was read, or exactly what was typed
    right: str
    verdict: str
    points: str
    remark: str  # prose
    guess: bool
    reason: str  # plain


@dataclass(frozen=True)
class FeedbackQuestion:
    """One question, in its place on the paper."""

    heading: str  # plain
    title: str  # prose
    points: str  # plain, "4 / 7"
    rows: tuple[FeedbackRow, ...]


@dataclass(frozen=True)
class FeedbackSheet:
    """One student's sheet, plain text except for its questions; `solution` is the name of a file
    beside it, or "".
    """

    words: FeedbackWords
    course: str
    title: str
    date: str
    student: str
    name: str
    code: str
    total: str
    kept: bool  # whether the total is a higher one from an earlier marking
    questions: tuple[FeedbackQuestion, ...]
    solution: str = ""

    @property
    def guesses(self) -> bool:
        """Whether any remark is a guess."""
        return any(row.guess for question in self.questions for row in question.rows)


def make_feedback_sheets(
    marks: MarksFolder, exam: ExamFolder, wording: Wording, language: Language
) -> Iterator[tuple[Candidate, FeedbackSheet]]:
    """The sheets in the order of the roster, each with its student. Raises TableError,
    ExamError.
    """
    head, totals = exam.head, marks.totals.by_student
    papers = PaperRecords(exam, marks.put)
    words = choose_feedback_words(language)
    for student, answers in marks.answers_by_student():
        if student not in head.candidates or student not in totals:
            raise ExamError(
                f'{marks.path}: student "{student}" is not in {HEAD} and {GRADES.name} - '
                f"expected the marks of this exam - grade again with {exam.path}"
            )
        candidate, total = head.candidates[student], totals[student]
        paper = papers.marked(student, (answer.column for answer in answers))
        # Every amount is written with four places, so that three thirds of a point fall short of
        # one.
        rounding = Fraction(len(answers) + 1, 2 * 10**PLACES)
        kept = total.total - sum(answer.points for answer in answers) > rounding
        yield (
            candidate,
            FeedbackSheet(
                words,
                head.course,
                head.title,
                head.date,
                student,
                candidate.name,
                candidate.paper,
                _write_share(total.total, total.out_of),
                kept,
                tuple(_make_questions(answers, paper, wording, words)),
            ),
        )


def _make_questions(
    answers: Sequence[MarkedAnswer], paper: PaperRecord, wording: Wording, words: FeedbackWords
) -> Iterator[FeedbackQuestion]:
    """The questions in the order of the paper."""
    by_question = {
        question: tuple(group)
        for question, group in groupby(answers, lambda answer: answer.question)
    }
    for number, question in enumerate(paper.printed, start=1):
        asked = by_question.get(question, ())
        other = find_other_number(question, number)
        heading = (
            words.question.format(number)
            if other is None
            else words.question_known.format(number, other)
        )
        points = sum((answer.points for answer in asked), Fraction(0))
        out_of = sum((answer.out_of for answer in asked), Fraction(0))
        rows = tuple(_make_feedback_row(answer, paper, wording, words) for answer in asked)
        yield FeedbackQuestion(
            heading, wording.titles.get(question, ""), _write_share(points, out_of), rows
        )


def _make_feedback_row(
    answer: MarkedAnswer, paper: PaperRecord, wording: Wording, words: FeedbackWords
) -> FeedbackRow:
    """The row for one answer."""
    right = paper.answers.get(answer.column)
    typed = (
        answer.typed if len(answer.typed) <= _LONGEST_TYPED else f"{answer.typed[:_LONGEST_TYPED]}…"
    )
    read = (
        _write_with_unit(answer.read_as, answer.unit)
        if answer.read_as not in ("", answer.typed.strip())
        else ""
    )
    remark, reason = _write_remark(answer, paper, wording, words)
    return FeedbackRow(
        wording.symbols.get(answer.column, rf"\mathrm{{{answer.ask.replace('_', ' ')}}}"),
        wording.meanings.get(answer.column, ""),
        typed,
        read.replace("-", "−"),
        write_right(right) if right else "",
        words.verdicts.get(answer.verdict, answer.verdict),
        _write_share(answer.points, answer.out_of),
        remark,
        bool(remark) and answer.verdict == "wrong",
        reason,
    )


def _write_remark(
    answer: MarkedAnswer, paper: PaperRecord, wording: Wording, words: FeedbackWords
) -> tuple[str, str]:
    """(prose, plain): the explanation of the verdict, and the note made on reading the cell."""
    if answer.verdict == "mistake":
        return words.or_else.join(filter(None, map(wording.mistakes.get, mistakes_of(answer)))), ""
    if answer.verdict == "wrong":
        found, right = hint_of(answer, paper), paper.answers.get(answer.column)
        return (_write_hint(found, answer, right, wording, words) if found and right else ""), ""
    if answer.verdict in ("right", "blank"):
        return "", ""
    if answer.verdict == "void" and answer.out_of:
        return words.explained[FULL], ""
    if answer.verdict in words.explained:
        shown = words.reasons_are_shown and answer.verdict in ("wrong unit", "unreadable")
        return words.explained[answer.verdict], answer.reason if shown else ""
    return "", answer.reason


def _write_hint(
    found: Hint, answer: MarkedAnswer, right: RightAnswer, wording: Wording, words: FeedbackWords
) -> str:
    """A hint in words for a student, as prose."""
    match found.kind:
        case "power of ten":
            factor = f"{10 ** abs(found.power):,}"
            text = (words.too_large if found.power > 0 else words.too_small).format(factor)
        case "another ask":
            symbol = wording.symbols.get(found.column, "")
            text = words.other_ask.format(symbol) if symbol else ""
        case "close":
            difference = abs(read_number(answer.read_as) - right.value) / abs(right.value)
            allowed = (
                words.by_policy
                if _POLICY in answer.reason
                else _write_percent(right.allowed / abs(right.value))
            )
            text = words.close.format(_write_percent(difference), allowed)
        case (
            "opposite"
            | "degrees for radians"
            | "radians for degrees"
            | "revolutions per second"
            | "revolutions per minute"
            | "twice"
            | "half"
        ):
            text = words.hints[found.kind]
        case _:
            assert_never(found.kind)
    return f"{text} {words.turned}" if found.reversed_sign and text else text


def _write_percent(share: Fraction) -> str:
    """Two significant figures, or more where two would read 1 %.

    >>> _write_percent(Fraction("0.0134")), _write_percent(Fraction("0.01004"))
    ('1.3 %', '1.004 %')
    """
    places = (
        2 if abs(share - Fraction(1, 100)) >= Fraction(1, 2000) or share == Fraction(1, 100) else 4
    )
    return f"{float(100 * share):.{places}g} %"


def write_right(right: RightAnswer) -> str:
    """`exact = decimal unit`: the exact value where it is short, "≈" where the decimal is
    rounded.

    >>> write_right(RightAnswer(Fraction("1.154700538379"), "2*sqrt(3)/3", "m/s", Fraction(0)))
    '2√3/3 ≈ 1.1547\u202fm/s'
    """
    value = (
        Context(prec=6)
        .divide(Decimal(right.value.numerator), Decimal(right.value.denominator))
        .normalize()
    )
    decimal = f"{value:f}" if -6 < value.adjusted() < 9 else str(value)
    same = Fraction(decimal) == right.value
    exact = _write_exact(right.exact or "")
    whole = _write_with_unit(decimal.replace("-", "−"), right.unit)
    if same or not exact:
        return whole if same else f"≈ {whole}"
    return f"{exact} ≈ {whole}"


def _write_exact(expression: str) -> str:
    """A closed form as it is written by hand; "" if it is long.

    >>> _write_exact("-3*sqrt(2)/40 + 2*pi"), _write_exact("sqrt(2 - sqrt(3))")
    ('−3√2/40 + 2π', '√(2 − √3)')
    """
    if len(expression) > _LONGEST_EXACT or not _CLOSED_FORM.fullmatch(expression):
        return ""
    rooted = re.sub(r"sqrt\(([0-9]+)\)", r"√\1", expression).replace("sqrt", "√").replace("pi", "π")
    return re.sub(r"\*(?=[√π(])", "", rooted).replace("*", "·").replace("-", "−")


def _write_with_unit(number: str, unit: str) -> str:
    """A number and its unit.

    >>> _write_with_unit("30", "deg"), _write_with_unit("2", "m/s^2"), _write_with_unit("2", "1")
    ('30°', '2\u202fm/s²', '2')
    """
    shown = write_unit_text(unit)
    return f"{number}{shown}" if shown in ("", "°") else f"{number}\u202f{shown}"


def _write_share(points: Fraction, out_of: Fraction) -> str:
    """Points out of the maximum."""
    return f"{write_amount(points)} / {write_amount(out_of)}"
