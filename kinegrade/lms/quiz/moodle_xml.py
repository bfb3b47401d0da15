r"""Questions for Moodle (Question bank > Import > Moodle XML format), one paper after the other.

A mechanism is one Cloze question with a box for every ask, or a numerical question for each. There is a category for
each paper, or for each question of the bank where variants are pooled, to be drawn from by a random question. Marks in
Cloze questions are whole numbers; where points are not, all marks of the quiz are the same multiple of them. Figures
are embedded, formulas stand between `\(` and `\)`. Moodle's import adds questions and never replaces any; `idnumber`s
are the same whenever the same exam is written, so that what is there already can be told.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from math import lcm
from pathlib import Path
from typing import Literal, TextIO

from kinegrade.errors import ExportError
from kinegrade.exam.quiz_document import Language, Quiz, QuizPaper, QuizQuestion
from kinegrade.files import output_file
from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.html import ask_html, figure_html, plain_html, prose_html
from kinegrade.lms.quiz.moodle_xml_answers import MoodleAnswer, cloze_field, moodle_answers

Form = Literal["cloze", "numerical"]
FIGURE = "figure.svg"
BOX = "\x00"  # stands for a box while the text around it is guarded; no text holds it
LONGEST_NAME, LONGEST_IDENTIFIER = 200, 100  # characters
MULTIPLIED = {
    "en": "The marks of this question are {} times its points.",
    "zh": "本题分值为所示分数的 {} 倍。",
}
_FIELD = re.compile(r"\{(?=#|[0-9]*:)")  # what Moodle would take for a box, or for the place of one


@dataclass(frozen=True)
class _Sheet:
    """What holds for all questions of a quiz."""

    language: Language
    form: Form
    scale: int  # marks for a point


def write(quiz: Quiz, target: Path, *, form: Form = "cloze", force: bool = False) -> list[str]:
    """Write the questions of a quiz, with `force` over an existing plain file, and give what a person should know.

    Raises ExportError for a quiz without papers and for credits that Moodle has no share for, TypesetError for texts
    that cannot be shown, OutputError; then `target` is as it was.
    """
    with (
        output_file(target, force=force) as partial,
        partial.open("x", encoding="utf-8", newline="\n") as stream,
    ):
        papers = iter(quiz.papers)
        first = next(papers, None)
        if first is None:
            raise ExportError(
                "quiz: no paper - expected at least one - choose an exam that somebody sits"
            )
        sheet = _Sheet(quiz.language, form, _scale(first) if form == "cloze" else 1)
        stream.write('<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n')
        for paper in chain([first], papers):
            _write_paper(paper, quiz.title, sheet, stream)
        stream.write("</quiz>\n")
    return (
        []
        if sheet.scale == 1
        else [
            f"marks in Moodle are {sheet.scale} times the points, because a Cloze question "
            "has whole marks only; the maximum grade of the quiz sets that right"
        ]
    )


def _scale(paper: QuizPaper) -> int:
    """The least multiple that makes whole numbers of all points, which are the same on all papers."""
    return lcm(*(ask.points.denominator for question in paper.questions for ask in question.asks))


def _write_paper(paper: QuizPaper, title: str, sheet: _Sheet, stream: TextIO) -> None:
    owner = " · ".join(text for text in (paper.student, paper.name) if text)
    if owner:
        stream.write(_category([title, paper.code], owner))
    for question in paper.questions:
        if not owner:
            stream.write(_category([title, f"{question.question} {_plain_title(question)}"], ""))
        stream.writelines(_questions(question, paper, sheet))


def _category(path: list[str], about: str) -> str:
    names = "/".join(
        _cut(name.replace("/", "∕")) for name in path
    )  # a slash would begin a new level
    return (
        f'<question type="category">\n<category><text>$course$/top/{names}</text></category>\n'
        f'<info format="html"><text>{_data(plain_html(about))}</text></info>\n</question>\n'
    )


def _questions(question: QuizQuestion, paper: QuizPaper, sheet: _Sheet) -> Iterator[str]:
    """The question of a mechanism, or one for each of its asks."""
    name = f"{paper.code} {question.question} {_plain_title(question)}"
    tags = ["kinegrade", question.question, *([paper.code] if paper.student else [])]
    if sheet.form == "cloze":
        yield _element(
            "cloze", _head(name, _cloze_text(question, sheet), question), question.identifier, tags
        )
        return
    for ask in question.asks:
        text = _statement(question) + ask_html(ask, sheet.language) + _rule(question)
        answers = "".join(map(_answer, moodle_answers(ask)))
        yield _element(
            "numerical",
            _head(f"{name}: {ask.identifier}", text, question),
            f"{question.identifier}-{ask.identifier}",
            tags,
            f"<defaultgrade>{decimal_text(ask.points)}</defaultgrade>\n{answers}",
        )


def _cloze_text(question: QuizQuestion, sheet: _Sheet) -> str:
    """The text with its boxes; nothing else in it looks like one."""
    asks = "".join(
        _guarded(ask_html(ask, sheet.language, BOX)).replace(
            BOX, cloze_field(ask, int(ask.points * sheet.scale))
        )
        for ask in question.asks
    )
    multiplied = (
        f"<p>{MULTIPLIED[sheet.language].format(sheet.scale)}</p>\n" if sheet.scale > 1 else ""
    )
    return _guarded(_statement(question)) + asks + _guarded(_rule(question)) + multiplied


def _head(name: str, text: str, question: QuizQuestion) -> str:
    """What all kinds of questions begin with: name, text with the figure, worked solution."""
    return (
        f"<name><text>{_cut(name)}</text></name>\n"
        f'<questiontext format="html"><text>{_data(text)}</text>{_file(question)}</questiontext>\n'
        f'<generalfeedback format="html"><text>{_data(question.solution)}</text></generalfeedback>\n'
        "<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n"
    )


def _element(kind: Form, head: str, identifier: str, tags: Sequence[str], answers: str = "") -> str:
    marked = "".join(f"<tag><text>{plain_html(tag)}</text></tag>" for tag in tags)
    return (
        f'<question type="{kind}">\n{head}<idnumber>{plain_html(identifier[-LONGEST_IDENTIFIER:])}</idnumber>\n'
        f"{answers}<tags>{marked}</tags>\n</question>\n"
    )


def _rule(question: QuizQuestion) -> str:
    return prose_html(question.rule, f"{question.question}, rule")


def _statement(question: QuizQuestion) -> str:
    figure = figure_html(question.figure, f"@@PLUGINFILE@@/{FIGURE}") if question.figure else ""
    return prose_html(question.statement, f"{question.question}, statement") + figure


def _file(question: QuizQuestion) -> str:
    if question.figure is None:
        return ""
    return f'<file name="{FIGURE}" path="/" encoding="base64">{b64encode(question.figure.svg).decode()}</file>'


def _answer(answer: MoodleAnswer) -> str:
    return (
        f'<answer fraction="{decimal_text(answer.share)}" format="moodle_auto_format">'
        f"<text>{decimal_text(answer.value)}</text><tolerance>{decimal_text(answer.room)}</tolerance>"
        f'<feedback format="html"><text>{_data(answer.feedback)}</text></feedback></answer>\n'
    )


def _guarded(html: str) -> str:
    """A text in which Moodle finds no box."""
    return _FIELD.sub("&#123;", html)


def _plain_title(question: QuizQuestion) -> str:
    return question.title.replace("$", "")


def _cut(name: str) -> str:
    """A name of a length that Moodle keeps whole."""
    return plain_html(name if len(name) <= LONGEST_NAME else name[: LONGEST_NAME - 1] + "…")


def _data(html: str) -> str:
    return f"<![CDATA[{html.replace(']]>', ']]]]><![CDATA[>')}]]>" if html else ""
