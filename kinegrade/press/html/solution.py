r"""A worked solution as HTML: with math between `\(` and `\)` for a learning management system to
show after the quiz, with MathML for pages of our own.

It has the texts, equations and tables of the printed one; pictures stand inside a page of our own,
and are files beside what a learning management system shows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import assert_never

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.html_text import write_display_html, write_plain_html, write_row_html
from kinegrade.language.math.mathml.formula import write_mathml_row
from kinegrade.language.math.spoken.speaking import speak_row
from kinegrade.language.math.tree import Environment, Group, LineBreak, Mark, Row, Sign
from kinegrade.language.message import Location, Message
from kinegrade.language.prose import plain
from kinegrade.language.prose.html import write_line, write_page_line, write_page_prose, write_prose
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

_WHERE = Message("typesetting.place-worked-solution")
_PLACED = ' style="padding:0 .5em;text-align:center"'


@dataclass(frozen=True)
class MathSetting:
    """How formulas are written: over a column, with what is said of them; on lines of their own,
    in a line of prose, in prose; the elements of the titles of chapters and steps; and whether
    pictures are shown.
    """

    head: Callable[[Row, str], str]
    display: Callable[[Row], str]
    line: Callable[[str, Location], str]
    prose: Callable[[str, Location], str]
    titles: tuple[str, str] = ("h4", "h5")
    pictures: bool = False


def _write_for_mathjax(row: Row, _: str) -> str:
    """A formula, which MathJax puts into words itself."""
    return write_row_html(row)


FOR_MATHJAX = MathSetting(_write_for_mathjax, write_display_html, write_line, write_prose)
IN_MATHML = MathSetting(
    write_mathml_row, write_mathml_row, write_page_line, write_page_prose, ("h3", "h4")
)
WITH_PICTURES = replace(IN_MATHML, pictures=True)


@dataclass(frozen=True)
class Illustrated:
    """HTML whose pictures are files: the texts with the pictures between them, in order."""

    parts: tuple[str | Picture, ...] = ()

    @property
    def pictures(self) -> tuple[Picture, ...]:
        """The pictures, which are counted from 1."""
        return tuple(part for part in self.parts if isinstance(part, Picture))

    def write(self, address: Callable[[int], str]) -> str:
        """The HTML with the address of each picture by its number. Raises TypesetError."""
        numbers = count(1)
        return "".join(
            _show(part, address(next(numbers))) if isinstance(part, Picture) else part
            for part in self.parts
        )


NOT_SHOWN = Illustrated()


def illustrate(blocks: Sequence[Block], language: Language) -> Illustrated:
    """The blocks of a worked solution for a learning management system. Raises TypesetError."""
    words = open_catalogue(language)
    return Illustrated(tuple(_list_parts(blocks, words)))


def _list_parts(blocks: Sequence[Block], words: Catalogue) -> Iterator[str | Picture]:
    for block in blocks:
        match block:
            case Pictures():
                yield from block.pictures
            case Heading() | Prose() | Display() | TermTable():
                yield _write_block(block, words, FOR_MATHJAX)
            case _:
                assert_never(block)


def write_blocks(
    blocks: Sequence[Block], language: Language, setting: MathSetting = FOR_MATHJAX
) -> str:
    """The blocks of a worked solution one after the other. Raises TypesetError."""
    words = open_catalogue(language)
    return "".join(_write_block(block, words, setting) for block in blocks)


def _write_block(block: Block, words: Catalogue, setting: MathSetting) -> str:
    match block:
        case Heading():
            tag = setting.titles[block.level - 1]
            return f"<{tag}>{setting.line(block.text, _WHERE)}</{tag}>\n"
        case Prose():
            return setting.prose(block.text, _WHERE)
        case Display():
            return f"<p>{setting.display(_align_lines(block.lines))}</p>\n"
        case TermTable():
            return _write_terms(block.terms, words, setting)
        case Pictures():
            return "".join(map(_draw, block.pictures)) if setting.pictures else ""
        case _:
            assert_never(block)


def _align_lines(lines: Sequence[Row]) -> Row:
    """Equations one below another."""
    body = [node for line in lines for node in (LineBreak(), *_align(line))]
    return (Environment("aligned", tuple(body[1:])),)


def _align(row: Row) -> Row:
    """A line with its mark, which stands before one that has none."""
    return row if Mark() in row else (Mark(), *row)


def _write_terms(terms: Sequence[Term], words: Catalogue, setting: MathSetting) -> str:
    """The vector equation over the magnitudes and directions of its terms."""
    heads = (_write_head((*_print_sign(term), *term.symbol), words, setting) for term in terms)
    first = f'<th scope="col">{write_plain_html(words.text("solution.layout.vector"))}</th>'
    rows = {
        "solution.layout.magnitude": [setting.line(term.magnitude, _WHERE) for term in terms],
        "solution.layout.direction": [setting.line(term.direction, _WHERE) for term in terms],
    }
    written = "".join(_write_property(words.text(head), cells) for head, cells in rows.items())
    return (
        f"<table><thead>\n<tr>{first}{''.join(heads)}</tr>\n</thead><tbody>\n{written}"
        "</tbody></table>\n"
    )


def _print_sign(term: Term) -> Row:
    """The sign of a term, with the room that it has between two terms."""
    return (Sign(term.sign), Group(())) if term.sign else ()


def _write_head(symbol: Row, words: Catalogue, setting: MathSetting) -> str:
    """A symbol over a column."""
    shown = setting.head(symbol, speak_row(symbol, words.language))
    return f'<th scope="col"{_PLACED}>{shown}</th>'


def _write_property(head: str, cells: Sequence[str]) -> str:
    """What each of the terms has."""
    entries = "".join(f"<td{_PLACED}>{cell}</td>" for cell in cells)
    return f'<tr><th scope="row">{write_plain_html(head)}</th>{entries}</tr>\n'


def _show(picture: Picture, address: str) -> str:
    """A picture that is a file, over its caption."""
    caption = write_line(picture.caption, _WHERE)
    told = write_plain_html(plain.write_line(picture.caption, _WHERE))
    image = f'<img src="{write_plain_html(address)}" alt="{told}"/>'
    return f"<p>{image}</p>\n<p>{caption}</p>\n"


def _draw(picture: Picture) -> str:
    """A picture inside the page, over its caption."""
    caption = write_page_line(picture.caption, _WHERE)
    return f"<figure>{to_svg(picture.scene)}<figcaption>{caption}</figcaption></figure>\n"
