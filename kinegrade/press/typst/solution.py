"""Worked solutions as Typst source: one call of the layout `solution.typ` with one string of data.

Prose and math become Typst code by their writers, pictures by the figures' back end. What must fit
the page (equations, tables of terms) goes to the layout in pieces, which it measures and breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from re import fullmatch
from typing import assert_never

from kinegrade.figure.back_ends.typst import write_typst_picture
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.tree import Row
from kinegrade.language.math.typst import write_typst_row
from kinegrade.language.message import Location
from kinegrade.language.prose.typst import write_line, write_prose
from kinegrade.press.equation_line import begins_with_sign, split_equation_line
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import PaperSize, SolutionSheet, WorkedQuestion
from kinegrade.press.solution_blocks import (
    FORMULA_ALONE,
    UNKNOWN,
    Chain,
    Passage,
    Placed,
    name_question,
    set_course,
)
from kinegrade.press.typst.layout_call import (
    Sheet,
    write_layout_call,
    write_signed,
)
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Picture,
    Pictures,
    Prose,
    Term,
    TermTable,
)


def write_solution_source(sheet: SolutionSheet, size: PaperSize = "a4") -> str:
    """Typst source of one student's worked solutions; raises TypesetError with all faults of their
    texts.
    """
    words = open_catalogue(sheet.language)
    data: Sheet = {
        "questions": convert_each(
            lambda question: _write_question(question, words), sheet.questions
        )
    }
    data |= {
        name: getattr(sheet, name)
        for name in ("course", "title", "date", "student", "name", "code")
    }
    data |= {"language": words.raw("language", "page.")}
    data |= {"size": size, "words": words.raw("solution", "layout.")}
    return write_layout_call("solution", data)


def _write_question(question: WorkedQuestion, words: Catalogue) -> Sheet:
    name, course, figure = question.identifier, set_course(question.blocks), question.figure
    where = locate_part(name, "solution")
    sheet = gather(
        title=lambda: write_line(question.title, locate_part(name, "title")),
        statement=lambda: write_prose(question.statement, locate_part(name, "statement")),
        leading=lambda: _write_chains(course.leading, where),
        blocks=lambda: convert_each(lambda part: _write_part(part, where), course.following),
    )
    return sheet | {
        "heading": words.write(name_question(question)),
        "figure": f"[{write_typst_picture(figure)}]" if figure else None,
        "figure_width": figure.width if figure else 0.0,
    }


def _write_chains(chains: Sequence[Chain], where: Location) -> list[list[Sheet]]:
    return convert_each(
        lambda chain: convert_each(lambda placed: _write_placed(placed, where), chain), chains
    )


def _write_part(part: Placed | Passage, where: Location) -> Sheet:
    """A block over the whole width, or drawings with the blocks that may stand beside them."""
    match part:
        case Placed():
            return _write_placed(part, where)
        case Passage():
            sheet = gather(
                pictures=lambda: convert_each(
                    lambda picture: _write_picture(picture, where), part.pictures.pictures
                ),
                beside=lambda: _write_chains(part.beside, where),
            )
            return sheet | {"kind": "passage"}
        case _:
            assert_never(part)


def _write_placed(placed: Placed, where: Location) -> Sheet:
    """One block, and whether it stays on the page of the next one."""
    return _write_content(placed.block, where) | {"stays": placed.stays}


def _write_content(block: Block, where: Location) -> Sheet:
    match block:
        case Heading():
            return {"kind": "heading", "level": block.level, "text": write_line(block.text, where)}
        case Prose():
            return {"kind": "prose", "text": write_prose(block.text, where)}
        case Display():
            return {
                "kind": "display",
                "lines": list(map(_write_line, block.lines)),
            }
        case TermTable():
            return {
                "kind": "terms",
                "terms": convert_each(lambda term: _write_term(term, where), block.terms),
            }
        case Pictures():
            return _write_part(Passage(block, ()), where)
        case _:
            assert_never(block)


def _write_line(line: Row) -> Sheet:
    parts = split_equation_line(line)
    return {
        "left": f"${write_typst_row(parts.left)}$",
        "pieces": [_write_piece(piece) for piece in parts.pieces],
    }


def _write_piece(piece: Row) -> Sheet:
    return {"code": f"${write_typst_row(piece)}$", "relation": not begins_with_sign(piece)}


def _write_term(term: Term, where: Location) -> Sheet:
    sheet = gather(
        symbol=lambda: f"${write_typst_row(term.symbol)}$",
        magnitude=lambda: _write_cell(term.magnitude, where),
        direction=lambda: _write_cell(term.direction, where),
    )
    return sheet | {"sign": write_signed(term.sign)}


def _write_cell(text: str, where: Location) -> Sheet:
    """A formula alone is made smaller where its column is narrow, other text is broken into
    lines.
    """
    return {
        "text": write_line(text, where),
        "formula": bool(fullmatch(FORMULA_ALONE, text)),
        "unknown": text == UNKNOWN,
    }


def _write_picture(picture: Picture, where: Location) -> Sheet:
    sheet = gather(
        figure=lambda: f"[{write_typst_picture(picture.scene)}]",
        caption=lambda: write_line(picture.caption, where),
    )
    return sheet | {"width": picture.scene.width}
