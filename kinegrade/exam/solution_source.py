"""Worked solutions as Typst source: one call of the layout `solution.typ` with one string of data.

Prose and math become Typst code by `kinegrade.exam.markup` and `formula`, pictures by the figures'
back end. What must fit the page (equations, tables of terms) goes to the layout in pieces, which it
measures and breaks.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from re import fullmatch

from kinegrade.exam.document import PaperSize, SolutionSheet, WorkedQuestion
from kinegrade.exam.equation_line import equation_line
from kinegrade.exam.formula import formula, unit_text
from kinegrade.exam.layout_call import Sheet, each, gathered, layout_call
from kinegrade.exam.markup import line, prose
from kinegrade.exam.solution_blocks import has_exact_decimal, stays
from kinegrade.exam.solution_words import SolutionWords, solution_words_of
from kinegrade.figure.typst import to_typst
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

TEXT_WIDTH = {"a4": 170.0, "letter": 175.9}  # millimetres between the margins
GAP = 6.0  # millimetres between pictures
FORMULA_ALONE = r"\$[^$]+\$"
UNKNOWN = "?"


def solution_source(sheet: SolutionSheet, size: PaperSize = "a4") -> str:
    """Typst source of one student's worked solutions; raises TypesetError with all faults of their
    texts.
    """
    words = solution_words_of(sheet.language)
    data: Sheet = {
        "questions": each(lambda question: _question(question, words, size), sheet.questions)
    }
    data |= {
        name: getattr(sheet, name)
        for name in ("language", "course", "title", "date", "student", "name", "code")
    }
    data |= {"size": size, "words": asdict(words) | {"page": words.page.split("{}")}}
    return layout_call("solution", data)


def _question(question: WorkedQuestion, words: SolutionWords, size: PaperSize) -> Sheet:
    where = f"{question.identifier}, solution"
    sheet = gathered(
        title=lambda: line(question.title, f"{question.identifier}, title"),
        statement=lambda: prose(question.statement, f"{question.identifier}, statement"),
        blocks=lambda: each(
            lambda place: _block(question.blocks, place, where, size), range(len(question.blocks))
        ),
    )
    other = other_number(question.identifier, question.number)
    known = words.question if other is None else words.question_known
    return sheet | {"heading": known.format(question.number, other)}


def _block(blocks: Sequence[Block], place: int, where: str, size: PaperSize) -> Sheet:
    """One block, and whether it stays on the page of the next one."""
    return _content(blocks[place], where, size) | {"stays": stays(*blocks[place : place + 3])}


def _content(block: Block, where: str, size: PaperSize) -> Sheet:
    match block:
        case Heading():
            return {"kind": "heading", "level": block.level, "text": line(block.text, where)}
        case Prose():
            return {"kind": "prose", "text": prose(block.text, where)}
        case Display():
            return {
                "kind": "display",
                "lines": each(lambda latex: _line(latex, where), block.lines),
            }
        case TermTable():
            return {"kind": "terms", "terms": each(lambda term: _term(term, where), block.terms)}
        case Pictures():
            rows = _rows(block.pictures, TEXT_WIDTH[size])
            return {"kind": "pictures", "rows": each(lambda row: _picture_row(row, where), rows)}
        case Results():
            return {
                "kind": "results",
                "results": each(lambda result: _result(result, where), block.results),
            }


def _line(latex: str, where: str) -> Sheet:
    parts = equation_line(latex)
    return gathered(
        left=lambda: _math(parts.left, where),
        pieces=lambda: each(lambda piece: _piece(piece, where), parts.pieces),
    )


def _piece(latex: str, where: str) -> Sheet:
    return {"code": _math(latex, where), "relation": latex[0] not in "+-"}


def _term(term: Term, where: str) -> Sheet:
    sheet = gathered(
        symbol=lambda: _math(term.symbol, where),
        magnitude=lambda: _cell(term.magnitude, where),
        direction=lambda: _cell(term.direction, where),
    )
    return sheet | {"sign": {"-": "\u2212"}.get(term.sign, term.sign)}


def _cell(text: str, where: str) -> Sheet:
    """A formula alone is made smaller where its column is narrow, other text is broken into
    lines.
    """
    return {
        "text": line(text, where),
        "formula": bool(fullmatch(FORMULA_ALONE, text)),
        "unknown": text == UNKNOWN,
    }


def _rows(pictures: Iterable[Picture], width: float) -> list[list[Picture]]:
    """As many pictures side by side as the page is wide."""
    rows: list[list[Picture]] = []
    for picture in pictures:
        taken = sum(other.scene.width + GAP for other in rows[-1]) if rows else width
        if rows and taken + picture.scene.width <= width:
            rows[-1].append(picture)
        else:
            rows.append([picture])
    return rows


def _picture_row(row: Sequence[Picture], where: str) -> list[Sheet]:
    return each(lambda picture: _picture(picture, where), row)


def _picture(picture: Picture, where: str) -> Sheet:
    sheet = gathered(
        figure=lambda: f"[{to_typst(picture.scene)}]", caption=lambda: line(picture.caption, where)
    )
    return sheet | {"width": picture.scene.width, "height": picture.scene.height}


def _result(result: Result, where: str) -> Sheet:
    sheet = gathered(
        symbol=lambda: _math(result.symbol, where),
        exact=lambda: None if _same_as_decimal(result) else _math(result.exact or "", where),
        sense=lambda: line(result.sense, where),
    )
    unit = "" if result.unit == "1" else unit_text(result.unit)
    space = "" if unit in ("", "°") else "\u202f"
    value = result.decimal.replace("-", "\u2212") + space + unit
    return sheet | {"relation": "=" if has_exact_decimal(result) else "≈", "decimal": value}


def _same_as_decimal(result: Result) -> bool:
    return result.exact is None or result.exact == result.decimal


def _math(latex: str, where: str) -> str:
    return f"${formula(latex, where)}$" if latex else "$$"
