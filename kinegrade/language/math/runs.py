r"""Formulas as runs of text, for figures whose back end has fonts but no formula typesetter.

Letters are italic, digits and `\mathrm` upright, scripts small and shifted, as in print. Lengths
are in em at the formula's size.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.language.math.label_size import measure_advance
from kinegrade.language.math.letters import SIGNS, find_letter
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spacing import SPACE_WIDTHS
from kinegrade.language.math.tree import (
    DEGREE,
    Accent,
    AccentName,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Style,
    Text,
    Unit,
)
from kinegrade.language.math.units import raise_exponents, write_unit
from kinegrade.language.message import Location

_SCRIPT = 0.72  # relative to the size of the script's base
# Of the measured width of a lower script, over which the upper one begins: letters are narrower,
# and it may not stand on the base
_STACKED = 0.75
_RAISED, _LOWERED = 0.38, -0.2  # the baseline of a script, in em of its base
_ACCENTS: dict[AccentName, str] = {
    "vec": "\u20d7",
    "bar": "\u0304",
    "hat": "\u0302",
    "widehat": "\u0302",
    "tilde": "\u0303",
    "dot": "\u0307",
    "ddot": "\u0308",
    "overline": "\u0305",
    "overrightarrow": "\u20d7",
    "underbrace": "",
    "boxed": "",
}
_LOW, _DEEP, _BOTH = (
    frozenset("acemnorsuvwxzαγεικνοπστυωϵ"),
    frozenset("gpqyηχμ"),
    frozenset("Qjβζξρφϕψϱ,;()"),
)


class Run(Struct, frozen=True):
    """Letters in one style; `shift` is the height of their baseline, `back` how far to move back
    before them.
    """

    text: str
    italic: bool = False
    bold: bool = False
    size: float = 1.0
    shift: float = 0.0
    back: float = 0.0

    @property
    def top(self) -> float:
        """How high above the formula's baseline the letters reach."""
        low = all(letter in _LOW | _DEEP for letter in self.text)
        return self.shift + self.size * (0.46 if low else 0.68)

    @property
    def bottom(self) -> float:
        """How far above the formula's baseline the letters begin; negative below it."""
        deep = any(letter in _DEEP | _BOTH for letter in self.text)
        return self.shift - self.size * (0.21 if deep else 0.0)


def split_symbol(symbol: str, where: Location) -> tuple[Run, ...]:
    """The runs of a symbol, given as LaTeX math.

    Raises TypesetError with every fault of the symbol, each naming `where`.

    >>> [run.text for run in split_symbol("O_1'", "label")]
    ['O', '1', '′']
    """
    return tuple(_merge(_write_row(read_math(symbol, where), Run(""))))


def _write_row(row: Row, style: Run) -> list[Run]:
    """The runs of what stands side by side, in the style of a run."""
    return [run for node in row for run in _write_node(node, style)]


def _write_node(node: Node, style: Run) -> list[Run]:
    match node:
        case Letter(name):
            letter = find_letter(name)
            return [replace(style, text=letter, italic=_leans(name))]
        case Group(row) | Environment(_, row):
            return _write_row(row, style)
        case Scripts():
            return _write_scripts(node, style)
        case Quotient(_, above, below):
            return [*_write_row(above, style), replace(style, text="/"), *_write_row(below, style)]
        case Root(radicand, degree):
            return _write_root(radicand, degree, style)
        case Lettering(name, row):
            return [_change(run, name) for run in _write_row(row, style)]
        case Accent(name, row):
            mark = _ACCENTS[name]
            return [replace(run, text=run.text + mark) for run in _write_row(row, style)]
        case Fenced(left, row, right):
            opening = replace(style, text=_write_fence(left))
            closing = replace(style, text=_write_fence(right))
            return [opening, *_write_row(row, style), closing]
        case Number() | Sign() | Function() | Text() | Unit() | Space() | LineBreak() | Mark():
            text = _write_text(node)
            return [replace(style, text=text)] if text else []
        case _:
            assert_never(node)


def _write_scripts(node: Scripts, style: Run) -> list[Run]:
    """A base with its scripts; the upper one stands above the lower one."""
    runs = [] if node.base is None else _write_node(node.base, style)
    below = _write_script(node.lower or (), style, _LOWERED)
    primes = [replace(style, text="′" * node.primes)] if node.primes else []
    if node.upper == DEGREE:
        return [*runs, *below, *primes, replace(style, text="°")]
    above = _write_script(node.upper or (), style, _RAISED)
    if below and above and not primes:
        back = _STACKED * measure_advance(node.lower or ()) * _SCRIPT * style.size
        above[0] = replace(above[0], back=back)
    return [*runs, *below, *primes, *above]


def _write_script(row: Row, style: Run, height: float) -> list[Run]:
    shifted = style.shift + style.size * height
    return _write_row(row, replace(style, size=style.size * _SCRIPT, shift=shifted))


def _write_root(radicand: Row, degree: Row | None, style: Run) -> list[Run]:
    """A root sign before one letter or digit, or before brackets."""
    index = _write_script(degree or (), style, _RAISED)
    inner = _write_row(radicand, style)
    if len("".join(run.text for run in inner)) == 1:
        return [*index, replace(style, text="√"), *inner]
    return [*index, replace(style, text="√("), *inner, replace(style, text=")")]


def _leans(name: str) -> bool:
    """Whether a letter is italic: capital Greek ones are upright."""
    return len(name) == 1 or name.islower()


def _change(run: Run, style: Style) -> Run:
    match style:
        case "mathrm":
            return replace(run, italic=False)
        case "mathit":
            return replace(run, italic=True)
        case "mathbf":
            return replace(run, italic=False, bold=True)
        case "boldsymbol":
            return replace(run, bold=True)
        case _:
            assert_never(style)


def _write_fence(bracket: str) -> str:
    return "" if bracket == "." else SIGNS[bracket].character


def _write_text(
    node: Number | Sign | Function | Text | Unit | Space | LineBreak | Mark,
) -> str:
    """What is upright and has no parts."""
    match node:
        case Number(text) | Function(text):
            return text
        case Sign(latex):
            return SIGNS[latex].character
        case Text(text):
            return raise_exponents(text)
        case Unit(text):
            return write_unit(text)
        case Space(name):
            return "\u2009" if SPACE_WIDTHS[name] > 0 else ""
        case LineBreak() | Mark():
            return " "
        case _:
            assert_never(node)


def _merge(runs: Iterable[Run]) -> list[Run]:
    """Adjacent runs of one style as one run."""
    merged: list[Run] = []
    for run in runs:
        if merged and replace(run, text="") == replace(merged[-1], text="", back=0.0):
            merged[-1] = replace(merged[-1], text=merged[-1].text + run.text)
        else:
            merged.append(run)
    return merged
