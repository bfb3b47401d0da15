"""Worked solutions as LaTeX source. What must fit the page (equations, tables of terms) goes to the
style in pieces, which TeX measures and breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from re import fullmatch

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.latex import TEX, write_latex_math, write_latex_row
from kinegrade.language.math.latex_text import write_comment, write_plain
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Location
from kinegrade.language.prose.latex import write_line, write_prose
from kinegrade.press.equation_line import begins_with_sign, split_equation_line
from kinegrade.press.latex.document import (
    write_command,
    write_environment,
    write_value,
)
from kinegrade.press.places import locate_part, locate_question, locate_solutions
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.press.solution_blocks import (
    FORMULA_ALONE,
    UNKNOWN,
    name_question,
    stays,
)
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

_BANDS = (
    (4, "34mm"),
    (6, "26mm"),
    (8, "20mm"),
)  # terms side by side, and the width that this leaves each for a column of words


def write_solution_body(sheet: SolutionSheet) -> str:
    """One student's worked solutions; raises TypesetError with all faults of its texts."""
    words, where = open_catalogue(sheet.language), locate_solutions(sheet.code)
    texts = (sheet.title, sheet.course, sheet.date, sheet.student, sheet.name, sheet.code)
    head = write_command("solutionhead", *map(write_plain, texts))
    questions = convert_each(
        lambda question: _write_question(question, words, where), sheet.questions
    )
    return write_environment("sheet", [write_comment(words.write(where)), head, *questions]) + "\n"


def _write_question(question: WorkedQuestion, words: Catalogue, sheet: Location) -> str:
    where = locate_question(sheet, question.identifier, question.template)
    parts = gather(
        title=lambda: write_line(question.title, locate_part(where, "title")),
        statement=lambda: write_prose(question.statement, locate_part(where, "statement")),
        blocks=lambda: convert_each(
            lambda place: _write_block(question.blocks, place, where), range(len(question.blocks))
        ),
    )
    heading = write_plain(words.write(name_question(question)))
    return "\n".join(
        (
            write_comment(words.write(where)),
            write_command("worked", heading, parts["title"], parts["statement"]),
            *parts["blocks"],
        )
    )


def _write_block(blocks: Sequence[Block], place: int, where: Location) -> str:
    """One block, and whether it stays on the page of the next one."""
    return _write_content(blocks[place], where) + (
        r"\stays" if stays(*blocks[place : place + 3]) else ""
    )


def _write_content(block: Block, where: Location) -> str:
    match block:
        case Heading():
            return write_command(
                "chapter" if block.level == 1 else "step", write_line(block.text, where)
            )
        case Prose():
            return write_command("reasoning", write_prose(block.text, where))
        case Display():
            return write_command(
                "equations",
                "".join(map(_write_line, block.lines)),
            )
        case TermTable():
            return "\n".join(_write_bands(block.terms, where))
        case Pictures():
            return write_command(
                "pictures",
                "%\n".join(
                    convert_each(lambda picture: _write_picture(picture, where), block.pictures)
                ),
            )
        case Results():
            return write_command(
                "results",
                "".join(convert_each(lambda result: _write_result(result, where), block.results)),
            )


def _write_line(line: Row) -> str:
    r"""`\equationline{left}{\relation{= a}\summand{+ b}}`: a line may be broken before each
    piece.
    """
    parts = split_equation_line(line)
    pieces = "".join(map(_write_piece, parts.pieces))
    return write_command("equationline", write_latex_row(parts.left, TEX), pieces)


def _write_piece(piece: Row) -> str:
    kind = "summand" if begins_with_sign(piece) else "relation"
    return write_command(kind, write_latex_row(piece, TEX))


def _write_bands(terms: Sequence[Term], where: Location) -> list[str]:
    """The table of a vector equation; a very long one goes on in a second band of columns."""
    widest = _BANDS[-1][0]
    count = -(-len(terms) // widest)
    size = -(-len(terms) // count)
    return [_write_band(terms[start : start + size], where) for start in range(0, len(terms), size)]


def _write_band(terms: Sequence[Term], where: Location) -> str:
    width = next(width for most, width in _BANDS if len(terms) <= most)
    cells = convert_each(lambda term: _write_term(term, width, where), terms)
    rows = ("".join(parts) for parts in zip(*cells, strict=True))
    return write_command("terms", str(len(terms)), *rows)


def _write_term(term: Term, width: str, where: Location) -> tuple[str, str, str]:
    """The entries of a term in the rows of the equation, the magnitudes and the directions."""
    parts = gather(
        symbol=lambda: write_latex_row(term.symbol, TEX),
        magnitude=lambda: _write_cell(term.magnitude, width, where),
        direction=lambda: _write_cell(term.direction, width, where),
    )
    return (
        f"&${term.sign}$&\\normalsize${parts['symbol']}$",
        f"&&{parts['magnitude']}",
        f"&&{parts['direction']}",
    )


def _write_cell(text: str, width: str, where: Location) -> str:
    """A formula alone stays on its line, words are broken into lines."""
    written = write_line(text, where)
    if text == UNKNOWN:
        return rf"\textbf{{{written}}}"
    return written if fullmatch(FORMULA_ALONE, text) else write_command("cell", width, written)


def _write_picture(picture: Picture, where: Location) -> str:
    parts = gather(
        caption=lambda: write_line(picture.caption, where), figure=lambda: write_tikz(picture.scene)
    )
    return write_command(
        "drawing", f"{max(picture.scene.width, 40):.6g}mm", parts["figure"], parts["caption"]
    )


def _write_result(result: Result, where: Location) -> str:
    parts = gather(
        symbol=lambda: write_latex_math(result.symbol, where),
        exact=lambda: f"= {write_latex_math(result.exact, where)}" if result.exact else "",
        sense=lambda: write_line(result.sense, where),
    )
    relation = "=" if result.is_settled else r"\approx"
    value = rf"${{}}{parts['exact']}$"
    if result.decimal:
        rounded = write_value(result.decimal, result.unit)
        value = rf"${{}}{parts['exact']} {relation} {{}}${rounded}"
    return write_command("result", parts["symbol"], value, parts["sense"])
