"""Worked solutions as LaTeX source. What must fit the page (equations, tables of terms) goes to the
style in pieces, which TeX measures and breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from re import fullmatch

from kinegrade.exam.document import SolutionSheet, WorkedQuestion
from kinegrade.exam.equation_line import equation_line
from kinegrade.exam.latex_markup import line, prose
from kinegrade.exam.latex_math import math
from kinegrade.exam.latex_source import Sheet, command, environment, named
from kinegrade.exam.latex_text import comment, plain, signed, unit
from kinegrade.exam.layout_call import each, gathered
from kinegrade.exam.solution_blocks import FORMULA_ALONE, UNKNOWN, has_exact_decimal, stays
from kinegrade.exam.solution_words import SolutionWords, solution_words_of
from kinegrade.figure.tikz import to_tikz
from kinegrade.question_numbers import other_number
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Picture,
    Pictures,
    Prose,
    Result,
    Results,
    Term,
    TermTable,
)

BANDS = (
    (4, "34mm"),
    (6, "26mm"),
    (8, "20mm"),
)  # terms side by side, and the width that this leaves each for a column of words


def solution_body(sheet: SolutionSheet) -> str:
    """One student's worked solutions; raises TypesetError with all faults of its texts."""
    words, where = solution_words_of(sheet.language), f"solutions of paper {sheet.code}"
    texts = (sheet.title, sheet.course, sheet.date, sheet.student, sheet.name, sheet.code)
    head = command("solutionhead", *map(plain, texts))
    questions = each(lambda question: _question(question, words, where), sheet.questions)
    return environment(Sheet(), [comment(where), head, *questions]) + "\n"


def _question(question: WorkedQuestion, words: SolutionWords, sheet: str) -> str:
    where = named(sheet, question.identifier, question.template)
    other = other_number(question.identifier, question.number)
    known = words.question if other is None else words.question_known
    parts = gathered(
        title=lambda: line(question.title, f"{where}, title"),
        statement=lambda: prose(question.statement, f"{where}, statement"),
        blocks=lambda: each(
            lambda place: _block(question.blocks, place, where), range(len(question.blocks))
        ),
    )
    heading = plain(known.format(question.number, other))
    return "\n".join(
        (
            comment(where),
            command("worked", heading, parts["title"], parts["statement"]),
            *parts["blocks"],
        )
    )


def _block(blocks: Sequence[Block], place: int, where: str) -> str:
    """One block, and whether it stays on the page of the next one."""
    return _content(blocks[place], where) + (r"\stays" if stays(*blocks[place : place + 3]) else "")


def _content(block: Block, where: str) -> str:
    match block:
        case Heading():
            return command("chapter" if block.level == 1 else "step", line(block.text, where))
        case Prose():
            return command("reasoning", prose(block.text, where))
        case Display():
            return command(
                "equations", "".join(each(lambda latex: _line(latex, where), block.lines))
            )
        case TermTable():
            return "\n".join(_bands(block.terms, where))
        case Pictures():
            return command(
                "pictures",
                "%\n".join(each(lambda picture: _picture(picture, where), block.pictures)),
            )
        case Results():
            return command(
                "results", "".join(each(lambda result: _result(result, where), block.results))
            )


def _line(latex: str, where: str) -> str:
    r"""`\equationline{left}{\relation{= a}\summand{+ b}}`: a line may be broken before each
    piece.
    """
    parts = equation_line(latex)
    pieces = each(lambda piece: command(_kind(piece), math(piece, where)), parts.pieces)
    return command("equationline", math(parts.left, where), "".join(pieces))


def _kind(piece: str) -> str:
    return "summand" if piece[0] in "+-" else "relation"


def _bands(terms: Sequence[Term], where: str) -> list[str]:
    """The table of a vector equation; a very long one goes on in a second band of columns."""
    widest = BANDS[-1][0]
    count = -(-len(terms) // widest)
    size = -(-len(terms) // count)
    return [_band(terms[start : start + size], where) for start in range(0, len(terms), size)]


def _band(terms: Sequence[Term], where: str) -> str:
    width = next(width for most, width in BANDS if len(terms) <= most)
    cells = each(lambda term: _term(term, width, where), terms)
    rows = ("".join(parts) for parts in zip(*cells, strict=True))
    return command("terms", str(len(terms)), *rows)


def _term(term: Term, width: str, where: str) -> tuple[str, str, str]:
    """The entries of a term in the rows of the equation, the magnitudes and the directions."""
    parts = gathered(
        symbol=lambda: math(term.symbol, where),
        magnitude=lambda: _cell(term.magnitude, width, where),
        direction=lambda: _cell(term.direction, width, where),
    )
    return (
        f"&${term.sign}$&\\normalsize${parts['symbol']}$",
        f"&&{parts['magnitude']}",
        f"&&{parts['direction']}",
    )


def _cell(text: str, width: str, where: str) -> str:
    """A formula alone stays on its line, words are broken into lines."""
    written = line(text, where)
    if text == UNKNOWN:
        return rf"\textbf{{{written}}}"
    return written if fullmatch(FORMULA_ALONE, text) else command("cell", width, written)


def _picture(picture: Picture, where: str) -> str:
    parts = gathered(
        caption=lambda: line(picture.caption, where), figure=lambda: to_tikz(picture.scene)
    )
    return command(
        "drawing", f"{max(picture.scene.width, 40):.6g}mm", parts["figure"], parts["caption"]
    )


def _result(result: Result, where: str) -> str:
    parts = gathered(
        symbol=lambda: math(result.symbol, where),
        exact=lambda: (
            "" if result.exact in (None, result.decimal) else f"= {math(result.exact or '', where)}"
        ),
        sense=lambda: line(result.sense, where),
    )
    shown = "" if result.unit == "1" else unit(result.unit)
    space = "" if shown in ("", "°") else r"\,"
    relation = "=" if has_exact_decimal(result) else r"\approx"
    value = rf"{{}}{parts['exact']} {relation} {{}}"
    return command(
        "result",
        parts["symbol"],
        f"${value}${signed(result.decimal)}{space}{shown}",
        parts["sense"],
    )
