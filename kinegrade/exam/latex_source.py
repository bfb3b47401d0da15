r"""Papers as LaTeX source, put together with PyLaTeX: the style `kinegrade.sty` holds the look,
this the content.

A body is one student's sheet; a document is a preamble with one body or with those of a whole
class. Comment lines that begin with two percent signs say which paper and question follows: faults
are named by them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby

from pylatex import Command, Document, NoEscape, Package
from pylatex.base_classes import Arguments, Environment, Options

from kinegrade.exam.latex_math import write_math
from kinegrade.exam.latex_text import write_comment, write_plain, write_unit
from kinegrade.figure.scene import Scene
from kinegrade.figure.tikz import write_tikz
from kinegrade.language import Language
from kinegrade.language.catalogue import PLACE, Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.prose.latex import write_line, write_prose
from kinegrade.press.code_mark import make_code_mark
from kinegrade.press.paper_parts import (
    arrange_marks,
    fits_beside,
    write_other_number,
    write_points_in_words,
    write_points_text,
)
from kinegrade.press.sheet import AnswerRow, Paper, PaperSize, QuestionSheet

_BESIDE_STUDENT = (
    8  # columns of the marker's table that leave room for the student's name beside them
)

_PLACES = ("page", "pages")  # of the fixed words: what the style gives them, in this order
_SIZE_OPTIONS: Mapping[PaperSize, tuple[str, ...]] = {"a4": (), "letter": ("letter",)}


class Block(Environment):  # type: ignore[misc]  # pylatex has no types
    """An environment of the style, named like the class."""

    content_separator = "\n"


class Sheet(Block):
    """One student's pages, numbered separately."""


class Question(Block):
    """One question, kept on one page."""


class Answers(Block):
    """The table with the boxes to be filled."""


def write_document(
    bodies: Iterable[str],
    language: Language,
    size: PaperSize,
    words: Mapping[str, str],
    fonts: str,
) -> str:
    """A whole LaTeX source; `words` holds the fixed words, `fonts` is the folder of the Chinese
    fonts.
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
    chosen = [open_catalogue(language).text("language.page.script"), *_SIZE_OPTIONS[size]]
    whole.packages.append(Package("kinegrade", options=chosen))
    whole.preamble.extend(_write_word(name, text) for name, text in words.items())
    whole.preamble.append(Command("chinesefonts", NoEscape(fonts)))
    whole.extend(NoEscape(body) for body in bodies)
    return str(whole.dumps())


def write_paper_body(paper: Paper) -> str:
    """One student's paper; raises TypesetError with all faults of its texts."""
    words, where = open_catalogue(paper.language), f"paper {paper.code}"
    parts = gather(
        rules=lambda: convert_each(lambda rule: write_prose(rule, "rules"), paper.rules),
        questions=lambda: convert_each(
            lambda question: _write_question(question, words, where), paper.questions
        ),
    )
    sheet = Sheet()
    sheet.append(NoEscape(write_comment(where)))
    texts = (paper.title, paper.course, paper.date, paper.student, paper.name, paper.code)
    sheet.append(NoEscape(write_command("masthead", *map(write_plain, texts), _mark(paper.code))))
    sheet.append(NoEscape(_write_marks(paper)))
    if paper.rules:
        sheet.append(NoEscape(write_command("rules", *_write_rule_columns(parts["rules"]))))
    sheet.extend(NoEscape(question) for question in parts["questions"])
    return str(sheet.dumps()) + "\n"


def write_command(name: str, *arguments: str) -> str:
    r"""A LaTeX command with its arguments, which are LaTeX already.

    >>> print(write_command("ask", "v_B", "speed"))
    \ask{v_B}{speed}
    """
    return str(Command(name, Arguments(*map(NoEscape, arguments))).dumps())


def write_environment(kind: Environment, lines: Iterable[str]) -> str:
    """An environment around lines that are LaTeX already."""
    kind.extend(NoEscape(text) for text in lines)
    return str(kind.dumps())


def write_named(where: str, identifier: str, template: str) -> str:
    """How faults and comments name a question.

    >>> write_named("paper A-1", "q2", "slider-crank")
    'paper A-1, q2 (slider-crank)'
    """
    return f"{where}, {identifier}" + (f" ({template})" if template else "")


def _write_word(name: str, text: str) -> Command:
    """The fixed words as commands: `\\wordpage{1}{3}` where there are places for numbers."""
    pieces = PLACE.split(text)
    plain, places = pieces[::3], pieces[1::3]
    numbers = [_PLACES.index(place) + 1 for place in places]
    filled = [
        f"#{number}{write_plain(piece)}" for number, piece in zip(numbers, plain[1:], strict=True)
    ]
    return Command(
        "newcommand",
        NoEscape("\\word" + name.replace("-", "").replace("_", "")),
        Options(max(numbers)) if numbers else None,
        extra_arguments=NoEscape(write_plain(plain[0]) + "".join(filled)),
    )


def _mark(code: str) -> str:
    r"""The QR code: its size in modules, then \dark{column}{row}{length} for each run of dark ones,
    row by row.
    """
    mark = make_code_mark(code)
    rows = groupby(mark.runs, lambda run: run.y)
    drawn = (
        "".join(f"\\dark{{{run.x}}}{{{y}}}{{{run.length}}}" for run in runs) + "%\n"
        for y, runs in rows
    )
    return write_command("codemark", str(mark.size), "%\n" + "".join(drawn))


def _write_marks(paper: Paper) -> str:
    """The student, and the table of the marker's boxes; a long one stands below the student."""
    rows = arrange_marks(paper, r"\wordtotal")
    return write_command(
        "candidate",
        write_plain(paper.name),
        write_plain(paper.student),
        "".join(map(_mark_table, rows)),
        "beside" if len(rows[0]) <= _BESIDE_STUDENT else "below",
    )


def _mark_table(columns: Sequence[tuple[str, str]]) -> str:
    numbers, points = (" & ".join(entries) for entries in zip(*columns, strict=True))
    return write_command(
        "markboxes", str(len(columns)), numbers, points, " & " * (len(columns) - 1)
    )


def _write_rule_columns(rules: Sequence[str]) -> list[str]:
    """The rules in two columns of about the same length."""
    half, taken = sum(map(len, rules)) / 2, 0
    columns: tuple[list[str], list[str]] = ([], [])
    for rule in rules:
        columns[taken + len(rule) / 2 > half].append(f"\\item {rule}")
        taken += len(rule)
    return ["\n".join(column) for column in columns]


def _write_question(question: QuestionSheet, words: Catalogue, paper: str) -> str:
    where = write_named(paper, question.identifier, question.template)
    parts = gather(
        title=lambda: write_line(question.title, f"{where}, title"),
        statement=lambda: write_prose(question.statement, f"{where}, statement"),
        rows=lambda: convert_each(lambda row: _write_ask(row, words, where), question.rows),
        figure=lambda: write_tikz(question.figure) if question.figure else "",
    )
    head = (
        str(question.number),
        parts["title"],
        write_plain(write_other_number(question, words)),
        write_plain(write_points_in_words(question.points, words)),
    )
    block = Question(arguments=Arguments(*map(NoEscape, head)))
    block.append(NoEscape(_write_statement(parts["statement"], question.figure, parts["figure"])))
    block.append(NoEscape(write_environment(Answers(), parts["rows"])))
    if question.source:
        source = words.text("paper.source", source=question.source)
        block.append(NoEscape(write_command("source", write_plain(source))))
    return f"{write_comment(where)}\n{block.dumps()}"


def _write_statement(text: str, figure: Scene | None, drawn: str) -> str:
    if figure is None:
        return write_command("statement", text)
    if fits_beside(figure):
        return write_command("beside", f"{figure.width:.6g}mm", text, drawn)
    return write_command("statement", text) + "\n" + write_command("below", drawn)


def _write_ask(row: AnswerRow, words: Catalogue, where: str) -> str:
    parts = gather(
        symbol=lambda: write_math(row.symbol, f"{where}, symbol"),
        meaning=lambda: write_line(row.meaning, f"{where}, meaning"),
        sign=lambda: write_line(row.sign, f"{where}, sign"),
    )
    printed = write_plain(words.text("paper.unitless")) if row.unit == "1" else write_unit(row.unit)
    return write_command(
        "ask",
        parts["symbol"],
        parts["meaning"],
        parts["sign"],
        printed,
        write_points_text(row.points),
    )
