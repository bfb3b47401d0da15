"""A student's paper as LaTeX source."""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from itertools import groupby

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.scene import Scene
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.latex import write_latex_math
from kinegrade.language.math.latex_text import write_comment, write_plain, write_unit
from kinegrade.language.message import Location
from kinegrade.language.prose.latex import write_line, write_prose
from kinegrade.press.code_mark import make_code_mark
from kinegrade.press.latex.document import write_command, write_environment, write_title
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.paper_parts import (
    arrange_marks,
    fits_beside,
    write_other_number,
    write_points_text,
    write_worth,
)
from kinegrade.press.places import RULES, locate_paper, locate_part, locate_question
from kinegrade.press.sheet import AnswerRow, Paper, QuestionSheet

# Columns of the marker's table that leave room for the student's name beside them
_BESIDE_STUDENT = 8


def write_paper_body(paper: Paper) -> str:
    """One student's paper; raises TypesetError with all faults of its texts."""
    words, where = open_catalogue(paper.language), locate_paper(paper.code)
    parts = gather(
        rules=lambda: convert_each(lambda rule: write_prose(rule, RULES), paper.rules),
        questions=lambda: convert_each(
            lambda question: _write_question(question, words, where), paper.questions
        ),
        conditions=lambda: _write_conditions(paper.head, words),
    )
    texts = (paper.title, paper.course, paper.date, paper.student, paper.name, paper.code)
    head = (write_plain(paper.head.institution), name_logo(paper.head))
    masthead = write_command("masthead", *map(write_plain, texts), _mark(paper.code), *head)
    rules = [write_command("rules", *_write_rule_columns(parts["rules"]))] if paper.rules else []
    lines = (
        write_comment(words.write(where)),
        write_title(paper.title),
        masthead,
        _write_marks(paper),
        *parts["conditions"],
        *rules,
        *parts["questions"],
    )
    return write_environment("sheet", lines, least=paper.pages) + "\n"


def name_logo(head: PaperHead) -> str:
    """The file of a paper's logo, by what it shows; "" for none."""
    return f"logo-{sha256(head.logo.encode()).hexdigest()[:8]}.pdf" if head.logo else ""


def _write_conditions(head: PaperHead, words: Catalogue) -> list[str]:
    """Duration, aids and instructions, and lines to write on, as far as there are any."""
    parts = gather(
        aids=lambda: write_line(head.aids, "header.aids"),
        instructions=lambda: write_prose(head.instructions, "header.instructions"),
    )
    times = [tuple(map(write_plain, each)) for each in head.list_times(words)]
    stated = (*times, *([(r"\wordaids", parts["aids"])] if head.aids else []))
    blanks = [
        write_command("blank", write_plain(label), write_plain(text))
        for label, text in head.list_blanks(words)
    ]
    return [
        *(write_command("condition", *each) for each in stated),
        *([write_command("instructions", parts["instructions"])] if head.instructions else []),
        *([write_command("blanks", str(len(blanks)), "".join(blanks))] if blanks else []),
    ]


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


def _write_question(question: QuestionSheet, words: Catalogue, paper: Location) -> str:
    where = locate_question(paper, question.identifier, question.template)
    parts = gather(
        title=lambda: write_line(question.title, locate_part(where, "title")),
        statement=lambda: write_prose(question.statement, locate_part(where, "statement")),
        rows=lambda: convert_each(lambda row: _write_ask(row, words, where), question.rows),
        figure=lambda: write_tikz(question.figure) if question.figure else "",
    )
    head = (
        str(question.number),
        parts["title"],
        write_plain(write_other_number(question, words)),
        write_plain(write_worth(question, words)),
    )
    source = words.text("paper.source", source=question.source) if question.source else ""
    lines = (
        _write_statement(parts["statement"], question.figure, parts["figure"]),
        write_command("working", f"{question.space:.6g}mm"),
        write_environment("answers", parts["rows"]) if question.rows else "",
        source and write_command("source", write_plain(source)),
    )
    block = write_environment("question", filter(None, lines), *head)
    return f"{write_comment(words.write(where))}\n{block}"


def _write_statement(text: str, figure: Scene | None, drawn: str) -> str:
    if figure is None:
        return write_command("statement", text)
    if fits_beside(figure):
        return write_command("beside", f"{figure.width:.6g}mm", text, drawn)
    return write_command("statement", text) + "\n" + write_command("below", drawn)


def _write_ask(row: AnswerRow, words: Catalogue, where: Location) -> str:
    parts = gather(
        symbol=lambda: write_latex_math(row.symbol, locate_part(where, "symbol")),
        meaning=lambda: write_line(row.meaning, locate_part(where, "meaning")),
        sign=lambda: write_line(row.sign, locate_part(where, "sign")),
        tolerance=lambda: convert_each(
            lambda line: write_line(line, locate_part(where, "tolerance")), row.tolerance
        ),
    )
    printed = write_plain(words.text("paper.unitless")) if row.unit == "1" else write_unit(row.unit)
    return write_command(
        "ask",
        parts["symbol"],
        parts["meaning"],
        parts["sign"],
        printed,
        r"\newline ".join(parts["tolerance"]),
        write_points_text(row.points, words.language),
    )
