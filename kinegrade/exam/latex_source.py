r"""Papers as LaTeX source, put together with PyLaTeX: the style `kinegrade.sty` holds the look,
this the content.

A body is one student's sheet; a document is a preamble with one body or with those of a whole
class. Comment lines that begin with two percent signs say which paper and question follows: faults
are named by them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from itertools import groupby
from typing import Any

from pylatex import Command, Document, NoEscape, Package
from pylatex.base_classes import Arguments, Environment, Options

from kinegrade.exam.code_mark import code_mark
from kinegrade.exam.document import AnswerRow, Paper, PaperSize, QuestionSheet
from kinegrade.exam.latex_markup import line, prose
from kinegrade.exam.latex_math import math
from kinegrade.exam.latex_text import comment, plain, unit
from kinegrade.exam.layout_call import each, gathered
from kinegrade.exam.typst_source import BESIDE, COLUMNS_OF_MARKS, points_text
from kinegrade.exam.words import Words, words_of
from kinegrade.figure.scene import Scene
from kinegrade.figure.tikz import to_tikz
from kinegrade.language import Language
from kinegrade.question_numbers import other_number

BESIDE_STUDENT = (
    8  # columns of the marker's table that leave room for the student's name beside them
)

LANGUAGE_OPTIONS: Mapping[Language, tuple[str, ...]] = {"en": (), "zh": ("chinese",)}
SIZE_OPTIONS: Mapping[PaperSize, tuple[str, ...]] = {"a4": (), "letter": ("letter",)}


class Block(Environment):  # type: ignore[misc]  # pylatex has no types
    """An environment of the style, named like the class."""

    content_separator = "\n"


class Sheet(Block):
    """One student's pages, numbered separately."""


class Question(Block):
    """One question, kept on one page."""


class Answers(Block):
    """The table with the boxes to be filled."""


def document(
    bodies: Iterable[str], language: Language, size: PaperSize, words: Any, fonts: str
) -> str:
    """A whole LaTeX source; `words` is a dataclass of fixed words, `fonts` the folder of the
    Chinese fonts.
    """
    whole = Document(
        documentclass="article",
        fontenc=None,
        inputenc=None,
        lmodern=False,
        textcomp=False,
        page_numbers=False,
        indent=True,
        microtype=False,
    )
    chosen = [*LANGUAGE_OPTIONS[language], *SIZE_OPTIONS[size]]
    whole.packages.append(Package("kinegrade", options=chosen or None))
    whole.preamble.extend(_word(name, text) for name, text in asdict(words).items())
    whole.preamble.append(Command("chinesefonts", NoEscape(fonts)))
    whole.extend(NoEscape(body) for body in bodies)
    return str(whole.dumps())


def paper_body(paper: Paper) -> str:
    """One student's paper; raises TypesetError with all faults of its texts."""
    words, where = words_of(paper.language), f"paper {paper.code}"
    parts = gathered(
        rules=lambda: each(lambda rule: prose(rule, "rules"), paper.rules),
        questions=lambda: each(lambda question: _question(question, words, where), paper.questions),
    )
    sheet = Sheet()
    sheet.append(NoEscape(comment(where)))
    texts = (paper.title, paper.course, paper.date, paper.student, paper.name, paper.code)
    sheet.append(NoEscape(command("masthead", *map(plain, texts), _mark(paper.code))))
    sheet.append(NoEscape(_marks(paper)))
    if paper.rules:
        sheet.append(NoEscape(command("rules", *_rule_columns(parts["rules"]))))
    sheet.extend(NoEscape(question) for question in parts["questions"])
    return str(sheet.dumps()) + "\n"


def command(name: str, *arguments: str) -> str:
    r"""A LaTeX command with its arguments, which are LaTeX already.

    >>> print(command("ask", "v_B", "speed"))
    \ask{v_B}{speed}
    """
    return str(Command(name, Arguments(*map(NoEscape, arguments))).dumps())


def environment(kind: Environment, lines: Iterable[str]) -> str:
    """An environment around lines that are LaTeX already."""
    kind.extend(NoEscape(text) for text in lines)
    return str(kind.dumps())


def named(where: str, identifier: str, template: str) -> str:
    """How faults and comments name a question.

    >>> named("paper A-1", "q2", "slider-crank")
    'paper A-1, q2 (slider-crank)'
    """
    return f"{where}, {identifier}" + (f" ({template})" if template else "")


def _word(name: str, text: str) -> Command:
    """The fixed words as commands: `\\wordpage{1}{3}` where there are places for numbers."""
    places = text.count("{}")
    pieces = [plain(piece) for piece in text.split("{}")]
    filled = "".join(
        piece + (f"#{index}" if index <= places else "")
        for index, piece in enumerate(pieces, start=1)
    )
    options = Options(places) if places else None
    return Command(
        "newcommand",
        NoEscape("\\word" + name.replace("_", "")),
        options,
        extra_arguments=NoEscape(filled),
    )


def _mark(code: str) -> str:
    r"""The QR code: its size in modules, then \dark{column}{row}{length} for each run of dark ones,
    row by row.
    """
    mark = code_mark(code)
    rows = groupby(mark.runs, lambda run: run.y)
    drawn = (
        "".join(f"\\dark{{{run.x}}}{{{y}}}{{{run.length}}}" for run in runs) + "%\n"
        for y, runs in rows
    )
    return command("codemark", str(mark.size), "%\n" + "".join(drawn))


def _marks(paper: Paper) -> str:
    """The student, and the table of the marker's boxes; a long one stands below the student."""
    columns = [(str(question.number), points_text(question.points)) for question in paper.questions]
    columns.append((r"\wordtotal", points_text(paper.points)))
    rows = [
        columns[start : start + COLUMNS_OF_MARKS]
        for start in range(0, len(columns), COLUMNS_OF_MARKS)
    ]
    return command(
        "candidate",
        plain(paper.name),
        plain(paper.student),
        "".join(map(_mark_table, rows)),
        "beside" if len(columns) <= BESIDE_STUDENT else "below",
    )


def _mark_table(columns: Sequence[tuple[str, str]]) -> str:
    numbers, points = (" & ".join(entries) for entries in zip(*columns, strict=True))
    return command("markboxes", str(len(columns)), numbers, points, " & " * (len(columns) - 1))


def _rule_columns(rules: Sequence[str]) -> list[str]:
    """The rules in two columns of about the same length."""
    half, taken = sum(map(len, rules)) / 2, 0
    columns: tuple[list[str], list[str]] = ([], [])
    for rule in rules:
        columns[taken + len(rule) / 2 > half].append(f"\\item {rule}")
        taken += len(rule)
    return ["\n".join(column) for column in columns]


def _question(question: QuestionSheet, words: Words, paper: str) -> str:
    where = named(paper, question.identifier, question.template)
    points = words.point if question.points == 1 else words.points
    other = other_number(question.identifier, question.number)
    known = "" if other is None else words.known.format(other)
    parts = gathered(
        title=lambda: line(question.title, f"{where}, title"),
        statement=lambda: prose(question.statement, f"{where}, statement"),
        rows=lambda: each(lambda row: _ask(row, words, where), question.rows),
        figure=lambda: to_tikz(question.figure) if question.figure else "",
    )
    head = (
        str(question.number),
        parts["title"],
        plain(known),
        plain(points.format(points_text(question.points))),
    )
    block = Question(arguments=Arguments(*map(NoEscape, head)))
    block.append(NoEscape(_statement(parts["statement"], question.figure, parts["figure"])))
    block.append(NoEscape(environment(Answers(), parts["rows"])))
    if question.source:
        block.append(NoEscape(command("source", plain(words.source.format(question.source)))))
    return f"{comment(where)}\n{block.dumps()}"


def _statement(text: str, figure: Scene | None, drawn: str) -> str:
    if figure is None:
        return command("statement", text)
    # A flat one stands better below the text
    if figure.width <= BESIDE and figure.height >= figure.width / 4:
        return command("beside", f"{figure.width:.6g}mm", text, drawn)
    return command("statement", text) + "\n" + command("below", drawn)


def _ask(row: AnswerRow, words: Words, where: str) -> str:
    parts = gathered(
        symbol=lambda: math(row.symbol, f"{where}, symbol"),
        meaning=lambda: line(row.meaning, f"{where}, meaning"),
        sign=lambda: line(row.sign, f"{where}, sign"),
    )
    printed = plain(words.unitless) if row.unit == "1" else unit(row.unit)
    return command(
        "ask", parts["symbol"], parts["meaning"], parts["sign"], printed, points_text(row.points)
    )
