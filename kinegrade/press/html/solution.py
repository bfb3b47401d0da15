r"""A worked solution as HTML with math between `\(` and `\)`, for a learning management system to
show after the quiz.

It has the texts, equations and tables of the printed one, which alone has the pictures.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.html_text import (
    write_display_html,
    write_plain_html,
    write_row_html,
)
from kinegrade.language.math.tree import Environment, Group, LineBreak, Mark, Row, Sign
from kinegrade.language.message import Message
from kinegrade.language.prose.html import write_line, write_prose
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Term,
    TermTable,
)

_WHERE = Message("typesetting.place-worked-solution")


def write_blocks(blocks: Sequence[Block], language: Language) -> str:
    """The blocks of a worked solution one after the other; pictures are left out. Raises
    TypesetError.
    """
    words = open_catalogue(language)
    return "".join(_write_block(block, words) for block in blocks)


def _write_block(block: Block, words: Catalogue) -> str:
    match block:
        case Heading():
            tag = "h4" if block.level == 1 else "h5"
            return f"<{tag}>{write_line(block.text, _WHERE)}</{tag}>\n"
        case Prose():
            return write_prose(block.text, _WHERE)
        case Display():
            return f"<p>{_write_aligned(block.lines)}</p>\n"
        case TermTable():
            return _write_terms(block.terms, words)
        case Pictures():
            return ""
        case _:
            assert_never(block)


def _write_aligned(lines: Sequence[Row]) -> str:
    """Equations one below another."""
    body = [node for line in lines for node in (LineBreak(), *_align(line))]
    return write_display_html((Environment("aligned", tuple(body[1:])),))


def _align(row: Row) -> Row:
    """A line with its mark, which stands before one that has none."""
    return row if Mark() in row else (Mark(), *row)


def _write_terms(terms: Sequence[Term], words: Catalogue) -> str:
    """The vector equation over the magnitudes and directions of its terms."""
    symbols = [write_row_html((*_print_sign(term), *term.symbol)) for term in terms]
    rows = [
        ("", symbols),
        (words.text("solution.layout.magnitude"), [_write_cell(term.magnitude) for term in terms]),
        (words.text("solution.layout.direction"), [_write_cell(term.direction) for term in terms]),
    ]
    written = "".join(
        (
            f'<tr><th scope="row">{write_plain_html(head)}</th>'
            f"{''.join(map(_write_entry, cells))}</tr>\n"
        )
        for head, cells in rows
    )
    return f"<table><tbody>\n{written}</tbody></table>\n"


def _print_sign(term: Term) -> Row:
    """The sign of a term, with the room that it has between two terms."""
    return (Sign(term.sign), Group(())) if term.sign else ()


def _write_cell(text: str) -> str:
    return write_line(text, _WHERE)


def _write_entry(cell: str) -> str:
    return f'<td style="padding:0 .5em;text-align:center">{cell}</td>'
