"""From a set paper to what stands on its pages and in the instructor's key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from msgspec import Struct

from kinegrade.deadlines.moment import write_moment
from kinegrade.description.said import Description
from kinegrade.description.short import describe_briefly
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.bank.by_hand import HandQuestion
from kinegrade.exam.printing.row_tolerance import write_row_tolerance
from kinegrade.exam.printing.rules import write_rules
from kinegrade.exam.roster.cell_values import say_extra_time
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.setting import SetAsk, SetPaper, SetQuestion
from kinegrade.figure.scene import Scene
from kinegrade.figure.sketch import Sketcher, sketch
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.sheet import AnswerRow, Paper, QuestionSheet
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.template import Ask, Template


class QuestionPlace(Struct, frozen=True):
    """Where a question stands: its number on the paper, and its name in the answer sheet."""

    number: int
    identifier: str


class ShownInstance(Struct, frozen=True):
    """What a question shows of an instance of its template, and what it asks; the mechanism is in
    doubles.
    """

    template: Template
    parameters: Mapping[str, Quantity]
    mechanism: Mechanism
    asks: tuple[str, ...]


def lay_out_paper(
    bank: Bank, paper: SetPaper, language: Language, figure: Sketcher = sketch
) -> Paper:
    """The pages of one student, in a language unless the student has another; `figure` draws as
    `sketch` does.
    """
    language = find_own_language(paper, language)
    sheets = [
        _lay_out_set_question(number, question, language, figure)
        for number, question in paper.numbered
    ]
    sheets += [_lay_out_hand_question(question, language) for question in bank.by_hand]
    sheets.sort(key=lambda sheet: sheet.number)
    return Paper(
        language,
        bank.course.in_language(language),
        write_title(bank, paper, language),
        bank.date,
        "" if paper.student.spare else paper.student.student,
        paper.student.name,
        paper.code,
        write_rules(bank, language),
        tuple(sheets),
        head=_fill_head(bank, paper.student, language),
        large=paper.student.reads_large_print,
    )


def find_own_language(paper: SetPaper, language: Language) -> Language:
    """The language of a student's paper, in an exam of that language."""
    own = paper.student.language
    return Language(own) if own else language


def _fill_head(bank: Bank, student: Student, language: Language) -> PaperHead:
    """The head of the papers with what the roster says of the student."""
    head, extra, due = bank.header.in_language(language), student.extra_time, bank.homework.due
    return replace(
        head,
        group=student.group or head.group,
        room=student.room or head.room,
        seat=student.seat or head.seat,
        extra_time=open_catalogue(language).write(say_extra_time(extra)) if extra else "",
        due="" if due is None else write_moment(due),
    )


def write_title(bank: Bank, paper: SetPaper, language: Language) -> str:
    """The exam's title, with the version where there are versions."""
    title = bank.title.in_language(language)
    return f"{title} · {write_version_name(paper.version, language)}" if paper.version else title


def write_version_name(letter: str, language: Language) -> str:
    """A version as it is printed."""
    return open_catalogue(language).text("paper.version", letter=letter)


def _lay_out_set_question(
    number: int, question: SetQuestion, language: Language, figure: Sketcher
) -> QuestionSheet:
    template, solution = question.question.template, question.drawn.solution
    mechanism = solution.assembly.mechanism.map(float)
    rows = tuple(
        _make_paper_row(entry, template.asks[entry.ask.name], language) for entry in question.asks
    )
    asks = tuple(entry.ask.name for entry in question.asks)
    shown = ShownInstance(template, solution.parameters, mechanism, asks)
    place = QuestionPlace(number, question.question.identifier)
    sheet = lay_out_question(place, shown, rows, language, figure)
    return replace(sheet, space=question.question.space, bonus=question.question.bonus)


def _lay_out_hand_question(question: HandQuestion, language: Language) -> QuestionSheet:
    """A question without a figure, and without boxes: the answer is written into its room."""
    return QuestionSheet(
        question.number,
        question.identifier,
        question.title.in_language(language),
        question.points,
        question.text.in_language(language),
        None,
        (),
        space=question.space,
        bonus=question.bonus,
    )


def lay_out_question(
    place: QuestionPlace,
    shown: ShownInstance,
    rows: tuple[AnswerRow, ...],
    language: Language,
    figure: Sketcher = sketch,
) -> QuestionSheet:
    """A question with its statement, figure to scale and answer table, for a paper or a quiz; the
    figure is described in one line.
    """
    template = shown.template
    short = describe_briefly(template, shown.parameters, language)
    return QuestionSheet(
        place.number,
        place.identifier,
        template.about.title.in_language(language),
        sum((row.points for row in rows), Fraction(0)),
        write_statement(template, shown.parameters, language, shown.asks),
        draw_figure(template, shown.mechanism, mark_question(template, shown.asks), figure),
        rows,
        template=template.name,
        described=Description(short, ()) if template.scheme.has_mechanism else None,
    )


def draw_figure(
    template: Template, mechanism: Mechanism, hints: FigureHints, figure: Sketcher = sketch
) -> Scene | None:
    """The figure of an instance with these marks; None where a question has steps alone."""
    return figure(mechanism, hints) if template.scheme.has_mechanism else None


def make_answer_row(ask: Ask, points: Fraction, language: Language) -> AnswerRow:
    """The box of one answer."""
    sign = write_sign(ask.sign, language)
    return AnswerRow(ask.symbol, ask.means.in_language(language), ask.unit.text, sign, points)


def _make_paper_row(entry: SetAsk, ask: Ask, language: Language) -> AnswerRow:
    """The row as a paper has it, which states its tolerance, and on which any number of turns may
    be written.
    """
    tolerance = write_row_tolerance(entry, language)
    row = replace(make_answer_row(ask, entry.ask.points, language), tolerance=tolerance)
    if not ask.cyclic:
        return row
    words = open_catalogue(language)
    return replace(row, sign=words.text("paper.sign-with-full-turns", sign=row.sign))
