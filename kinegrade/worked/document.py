"""The parts of a worked solution, independent of any typesetter: prose, equations, tables of terms,
pictures.

`kinegrade.worked.solution` derives these from a solved instance; a press lays them out. Prose is
Markdown with `$...$` LaTeX math, math is a math tree, LaTeX is LaTeX math without dollar signs,
plain is printed as it is. Decimals have the mark of the language.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message

_CHINESE_START = re.compile(r"^([\u4e00-\u9fff])")
_LATIN_CHINESE = re.compile(
    r"(?<=[0-9A-Za-z])(?=[\u4e00-\u9fff])|(?<=[\u4e00-\u9fff])(?=[0-9A-Za-z])"
)
_CHINESE_END = re.compile(r"([\u4e00-\u9fff])$")


@dataclass(frozen=True)
class Heading:
    """The title of a chapter ("Velocities") or of a step ("Step 2: the rod AB, base point A")."""

    text: str  # prose, one line
    level: Literal[1, 2]


@dataclass(frozen=True)
class Prose:
    """A paragraph; `formulas` are those in it that were written as trees; a `compact` one has the
    full width of the page rather than many lines beside a drawing.
    """

    text: str  # prose
    formulas: tuple[Row, ...] = field(default=(), compare=False, repr=False)
    compact: bool = field(default=False, compare=False, repr=False)


def say(message: Message, language: Language) -> Prose:
    """A paragraph that says a message."""
    return Prose(write_sentence(message, language))


def write_sentence(message: Message, language: Language) -> str:
    """What a message says, with spaces between Chinese words and formulas."""
    return _space_formulas(open_catalogue(language).write(message))


def _space_formulas(text: str) -> str:
    """A space wherever a Chinese character stands next to a formula, a Latin letter or a digit.

    >>> _space_formulas("投影到$x$轴（$y$ 轴除外），齿轮 II在第2步")
    '投影到 $x$ 轴（$y$ 轴除外），齿轮 II 在第 2 步'
    """
    words = text.split("$")[::2]
    formulas = text.split("$")[1::2]
    spaced = [_CHINESE_END.sub(r"\1 ", one) for one in words[:-1]] + words[-1:]
    spaced[1:] = [_CHINESE_START.sub(r" \1", one) for one in spaced[1:]]
    spaced = [_LATIN_CHINESE.sub(" ", one) for one in spaced]
    joined = (f"{before}${formula}$" for before, formula in zip(spaced, formulas, strict=False))
    return "".join(joined) + spaced[-1]


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
    """A drawing with a short caption."""

    scene: Scene
    caption: str  # prose, one line


@dataclass(frozen=True)
class Pictures:
    """Drawings side by side, or one below the other where the page is too narrow."""

    pictures: tuple[Picture, ...]


Block = Heading | Prose | Display | TermTable | Pictures


@dataclass(frozen=True)
class WorkedSolution:
    """The solution of one question, from how each body moves to the last answer."""

    blocks: tuple[Block, ...]
