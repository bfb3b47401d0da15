"""Worked solutions as LaTeX source. What must fit the page (equations, tables of terms) goes to the
style in pieces, which TeX measures and breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from re import fullmatch
from typing import assert_never

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.scene import Scene
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.latex import TEX, write_latex_row
from kinegrade.language.math.latex_text import write_comment, write_plain
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Location
from kinegrade.language.prose.latex import write_line, write_prose
from kinegrade.press.equation_line import begins_with_sign, split_equation_line
from kinegrade.press.latex.document import (
    write_command,
    write_environment,
)
from kinegrade.press.places import locate_part, locate_question, locate_solutions
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.press.solution_blocks import (
    FORMULA_ALONE,
    UNKNOWN,
    Chain,
    Passage,
    Placed,
    name_question,
    set_course,
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
    where, course = (
        locate_question(sheet, question.identifier, question.template),
        set_course(question.blocks),
    )
    parts = gather(
        title=lambda: write_line(question.title, locate_part(where, "title")),
        statement=lambda: write_prose(question.statement, locate_part(where, "statement")),
        leading=lambda: convert_each(lambda chain: _write_chain(chain, where), course.leading),
        blocks=lambda: convert_each(lambda part: _write_part(part, where), course.following),
    )
    heading = write_plain(words.write(name_question(question)))
    statement = write_command("given", parts["statement"])
    chains = [write_command("chain", chain) for chain in (statement, *parts["leading"])]
    return "\n".join(
        (
            write_comment(words.write(where)),
            write_command("worked", heading, parts["title"]),
            _write_beside_figure(question.figure, chains),
            *parts["blocks"],
        )
    )


def _write_beside_figure(figure: Scene | None, chains: Sequence[str]) -> str:
    """The figure of the question with text beside it."""
    joined = "%\n".join(chains)
    if figure is None:
        return joined
    return write_command("passage", f"{figure.width:.6g}mm", write_tikz(figure), joined)


def _write_chain(chain: Chain, where: Location) -> str:
    return "%\n".join(convert_each(lambda placed: _write_placed(placed, where), chain))


def _write_part(part: Placed | Passage, where: Location) -> str:
    """A block over the whole width, or drawings with the blocks that may stand beside them."""
    match part:
        case Placed():
            return _write_placed(part, where)
        case Passage():
            return _write_passage(part, where)
        case _:
            assert_never(part)


def _write_passage(passage: Passage, where: Location) -> str:
    pictures = passage.pictures.pictures
    parts = gather(
        column=lambda: convert_each(lambda picture: _write_picture(picture, where), pictures),
        beside=lambda: convert_each(lambda chain: _write_chain(chain, where), passage.beside),
    )
    column = "%\n".join(parts["column"])
    if not parts["beside"]:
        return write_command("pictures", column)
    width = max(_find_width(picture) for picture in pictures)
    chains = [write_command("chain", chain) for chain in parts["beside"]]
    return write_command("passage", f"{width:.6g}mm", column, "%\n".join(chains))


def _write_placed(placed: Placed, where: Location) -> str:
    """One block, and whether it stays on the page of the next one."""
    return _write_content(placed.block, where) + (r"\stays" if placed.stays else "")


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
            return _write_passage(Passage(block, ()), where)
        case _:
            assert_never(block)


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
        "drawing", f"{_find_width(picture):.6g}mm", parts["figure"], parts["caption"]
    )


def _find_width(picture: Picture) -> float:
    """Millimetres that a drawing takes with its caption."""
    return max(picture.scene.width, 50.0)
