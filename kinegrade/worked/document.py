"""The parts of a worked solution, independent of any typesetter: prose, equations, tables of terms,
pictures.

`kinegrade.worked.solution` derives these from a solved instance; a press lays them out. Prose is
Markdown with `$...$` LaTeX math, math is a math tree, LaTeX is LaTeX math without dollar signs,
plain is printed as it is. Decimals have the mark of the language. The formulas of a block can be
listed, wherever they stand in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal, assert_never

from kinegrade.errors import TypesetError
from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.worked.findings import Checked


@dataclass(frozen=True)
class Heading:
    """The title of a chapter ("Velocities") or of a step ("Step 2: the rod AB, base point A")."""

    text: str  # prose, one line
    level: Literal[1, 2]


@dataclass(frozen=True)
class Prose:
    """A paragraph; `formulas` are those in it that were written as trees; a `compact` one has the
    full width of the page rather than many lines beside a drawing; one `on_polygon` says something
    of the letters in a polygon alone; one `on_check` is a check, or says what it alone needs.
    """

    text: str  # prose
    formulas: tuple[Row, ...] = field(default=(), compare=False, repr=False)
    compact: bool = field(default=False, compare=False, repr=False)
    on_polygon: bool = field(default=False, compare=False, repr=False)
    on_check: bool = field(default=False, compare=False, repr=False)


def say(message: Message, language: Language) -> Prose:
    """A paragraph that says a message."""
    return Prose(write_sentence(message, language))


@dataclass(frozen=True)
class Display:
    """Equations, one below the other, aligned at the mark that each line may hold before its first
    relation sign. The value of an answer stands in a box.
    """

    lines: tuple[Row, ...]  # math


@dataclass(frozen=True)
class Term:
    """One column of the table under a vector equation; the sign stands before the term's symbol."""

    sign: Literal["", "+", "-", "="]
    symbol: Row  # math: v_BA in bold
    magnitude: str  # prose, short: "?", "$\\omega_{OA}\\cdot OA$"
    direction: str  # prose, short: "?", "$\\perp AB$"


@dataclass(frozen=True)
class TermTable:
    """A vector equation written term by term, with the magnitude and direction of each term below
    it.
    """

    terms: tuple[Term, ...]


@dataclass(frozen=True)
class Picture:
    """A drawing with a short caption. A long solution can spare polygons and further sketches of
    velocities.
    """

    scene: Scene
    caption: str  # prose, one line
    kind: Literal["velocities", "polygon", "other"] = "other"


@dataclass(frozen=True)
class Pictures:
    """Drawings side by side, or one below the other where the page is too narrow."""

    pictures: tuple[Picture, ...]


Block = Heading | Prose | Display | TermTable | Pictures


@dataclass(frozen=True)
class WorkedSolution:
    """The solution of one question, from how each body moves to the last answer."""

    blocks: tuple[Block, ...]
    checked: tuple[Checked, ...] = ()  # what the checks of rates say


@lru_cache(maxsize=4096)
def list_formulas(text: str) -> tuple[Row, ...]:
    """The formulas of a text; one that cannot be read is left out: its writer says where it is."""
    formulas = []
    for latex in text.split("$")[1::2]:
        with suppress(TypesetError):
            formulas.append(read_math(latex, ""))
    return tuple(formulas)


def list_block_formulas(block: Block) -> Iterator[Row]:
    """The formulas of a block, in their order."""
    match block:
        case Heading(text) | Prose(text):
            yield from list_formulas(text)
        case Display(lines):
            yield from lines
        case TermTable(terms):
            for term in terms:
                yield term.symbol
                yield from list_formulas(term.magnitude)
                yield from list_formulas(term.direction)
        case Pictures():
            return
        case _:
            assert_never(block)
