r"""The questions of a paper as Moodle's XML has them: categories, names, texts, figures, boxes,
answers.

A mechanism is one Cloze question with a box for every ask, or a numerical question for each. There
is a category for each paper, or for each question of the bank where variants are pooled, and for
each of its asks where every ask is a question: a random question then draws variants of one thing.
Marks in Cloze questions are whole numbers; where points are not, all marks of the quiz are the same
multiple of them. Figures are embedded, formulas are enclosed in `\(` and `\)`. `idnumber`s are the
same whenever the same exam is written, so questions that are in Moodle already can be recognised.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Literal, assert_never

from kinegrade.exam.quiz.document import QuizAsk, QuizPaper, QuizQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_plain_html
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.moodle.answers import MoodleAnswer, list_moodle_answers, write_cloze_field
from kinegrade.lms.quiz.question_html import (
    write_asked_html,
    write_rules_html,
)
from kinegrade.press.html.question import draw_picture, write_description, write_statement

Form = Literal["cloze", "numerical"]
_FIGURE = "figure.svg"
_BOX = "\x00"  # stands for a box while the text around it is escaped; no text contains it
_LONGEST_NAME, _LONGEST_IDENTIFIER = 200, 100  # characters
_FIELD = re.compile(r"\{(?=#|[0-9]*:)")  # what Moodle would take for a box or its place


@dataclass(frozen=True)
class Sheet:
    """What holds for all questions of a quiz."""

    language: Language
    form: Form
    scale: int  # marks for a point
    category: str  # the parent of those of the papers, or of the pools; in Moodle's mark-up


def make_sheet(
    language: Language, form: Form, title: str, identifier: str, first: QuizPaper
) -> Sheet:
    """What holds for a quiz with that first paper; points are the same on all papers.

    The exam's identifier separates exams with the same title; otherwise one random question would
    draw from all of them.
    """
    match form:
        case "cloze":
            points = (ask.row.points for question in first.questions for ask in question.asks)
            scale = lcm(*(each.denominator for each in points))
        case "numerical":
            scale = 1
        case _:
            assert_never(form)
    suffix = f" ({write_plain_html(identifier)})" if identifier else ""
    return Sheet(language, form, scale, f"{_write_level(title)}{suffix}")


def write_paper_questions(paper: QuizPaper, sheet: Sheet) -> Iterator[str]:
    """The categories and questions of a paper, one element after another."""
    owner = " · ".join(text for text in (paper.student, paper.name) if text)
    if owner:
        yield _write_category(sheet, [paper.code], owner)
    for question in paper.questions:
        yield from _write_questions(question, paper, sheet, pooled=not owner)


def list_pool_marks(question: QuizQuestion, sheet: Sheet) -> Iterator[tuple[str, Fraction]]:
    """The pools of a question, each with its name in the categories and the mark of one variant."""
    match sheet.form:
        case "cloze":
            yield question.sheet.identifier, question.sheet.points * sheet.scale
        case "numerical":
            for ask in question.asks:
                yield f"{question.sheet.identifier} {ask.identifier}", ask.row.points
        case _:
            assert_never(sheet.form)


def _write_category(sheet: Sheet, levels: Sequence[str], about: str) -> str:
    names = "/".join((sheet.category, *map(_write_level, levels)))
    return (
        f'<question type="category">\n<category><text>$course$/top/{names}</text></category>\n'
        '<info format="html"><text>'
        f"{_write_data(write_plain_html(about))}</text></info>\n</question>\n"
    )


def _write_level(name: str) -> str:
    """A name in the path of a category; a slash in it would begin a new level."""
    return _cut(name.replace("/", "∕"))


def _write_questions(
    question: QuizQuestion, paper: QuizPaper, sheet: Sheet, *, pooled: bool
) -> Iterator[str]:
    """The question of a mechanism, or one for each of its asks; each pool has its own category."""
    pool = f"{question.sheet.identifier} {_write_plain_title(question)}"
    name = f"{paper.code} {pool}"
    tags = ["kinegrade", question.sheet.identifier, *([paper.code] if paper.student else [])]
    match sheet.form:
        case "cloze":
            if pooled:
                yield _write_category(sheet, [pool], "")
            head = _write_head(name, _write_cloze_text(question, sheet), question)
            yield _write_element("cloze", head, question.identifier, tags)
        case "numerical":
            for ask in question.asks:
                if pooled:
                    yield _write_category(sheet, [pool, ask.identifier], "")
                yield _write_numerical(name, question, ask, sheet, tags)
        case _:
            assert_never(sheet.form)


def _write_numerical(
    name: str, question: QuizQuestion, ask: QuizAsk, sheet: Sheet, tags: Sequence[str]
) -> str:
    text = (
        _write_statement(question, sheet.language)
        + write_asked_html(ask, ask, sheet.language)
        + write_rules_html(question, "moodle", sheet.language)
    )
    answers = "".join(map(_write_answer, list_moodle_answers(ask)))
    return _write_element(
        "numerical",
        _write_head(f"{name}: {ask.identifier}", text, question),
        f"{question.identifier}-{ask.identifier}",
        tags,
        f"<defaultgrade>{write_decimal(ask.row.points)}</defaultgrade>\n{answers}",
    )


def _write_cloze_text(question: QuizQuestion, sheet: Sheet) -> str:
    """The text with its boxes; nothing else in it looks like a box."""
    asks = "".join(
        _write_guarded(write_asked_html(ask, ask, sheet.language, _BOX)).replace(
            _BOX, write_cloze_field(ask, int(ask.row.points * sheet.scale))
        )
        for ask in question.asks
    )
    multiplied = ""
    if sheet.scale > 1:
        note = open_catalogue(sheet.language).text("quiz.multiplied", scale=sheet.scale)
        multiplied = f"<p>{note}</p>\n"
    return (
        _write_guarded(_write_statement(question, sheet.language))
        + asks
        + _write_guarded(write_rules_html(question, "moodle", sheet.language))
        + multiplied
    )


def _write_head(name: str, text: str, question: QuizQuestion) -> str:
    """The beginning of questions of all kinds: name, text with the figure, worked solution."""
    return (
        f"<name><text>{_cut(name)}</text></name>\n"
        f'<questiontext format="html"><text>{_write_data(text)}</text>'
        f"{_write_file(question)}</questiontext>\n"
        f'<generalfeedback format="html">{_write_solution(question)}</generalfeedback>\n'
        "<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n"
    )


def _write_element(
    kind: Form, head: str, identifier: str, tags: Sequence[str], answers: str = ""
) -> str:
    marked = "".join(f"<tag><text>{write_plain_html(tag)}</text></tag>" for tag in tags)
    number = write_plain_html(identifier[-_LONGEST_IDENTIFIER:])
    return (
        f'<question type="{kind}">\n{head}<idnumber>{number}</idnumber>\n'
        f"{answers}<tags>{marked}</tags>\n</question>\n"
    )


def _write_statement(question: QuizQuestion, language: Language) -> str:
    statement = write_statement(question.sheet, f"@@PLUGINFILE@@/{_FIGURE}")
    return statement + write_description(question.sheet, language)


def _write_file(question: QuizQuestion) -> str:
    figure = question.sheet.figure
    return "" if figure is None else _embed(_FIGURE, draw_picture(figure))


def _write_solution(question: QuizQuestion) -> str:
    """The text of the worked solution, and its pictures."""
    solution = question.solution
    text = _write_data(solution.write(lambda number: f"@@PLUGINFILE@@/{_name_picture(number)}"))
    pictures = enumerate(solution.pictures, start=1)
    files = (
        _embed(_name_picture(number), draw_picture(picture.scene)) for number, picture in pictures
    )
    return f"<text>{text}</text>{''.join(files)}"


def _name_picture(number: int) -> str:
    return f"solution-{number}.svg"


def _embed(name: str, content: bytes) -> str:
    return f'<file name="{name}" path="/" encoding="base64">{b64encode(content).decode()}</file>'


def _write_answer(answer: MoodleAnswer) -> str:
    return (
        f'<answer fraction="{write_decimal(answer.share)}" format="moodle_auto_format">'
        f"<text>{write_decimal(answer.value)}</text>"
        f"<tolerance>{write_decimal(answer.room)}</tolerance>"
        f'<feedback format="html"><text>{_write_data(answer.feedback)}</text></feedback></answer>\n'
    )


def _write_guarded(html: str) -> str:
    """A text in which Moodle finds no box."""
    return _FIELD.sub("&#123;", html)


def _write_plain_title(question: QuizQuestion) -> str:
    return question.sheet.title.replace("$", "")


def _cut(name: str) -> str:
    """A name cut to the length that Moodle keeps."""
    return write_plain_html(name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 1] + "…")


def _write_data(html: str) -> str:
    return f"<![CDATA[{html.replace(']]>', ']]]]><![CDATA[>')}]]>" if html else ""
