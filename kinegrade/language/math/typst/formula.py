"""Formulas as Typst math, for between dollar signs.

Letters and signs come from the table, text leaves as string literals: nothing in a formula can
become Typst code.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import assert_never

from kinegrade.language.math.letters import GREEK, SIGNS
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import (
    DEGREE,
    Accent,
    AccentName,
    Environment,
    EnvironmentName,
    Fenced,
    FractionName,
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
    SpaceName,
    Style,
    Text,
    Unit,
    split_row,
)
from kinegrade.language.math.typst.brackets import TYPED, find_bracket, find_matched
from kinegrade.language.math.units import raise_exponents, write_unit
from kinegrade.language.message import Location
from kinegrade.language.typst_text import write_literal

_ACCENTS: dict[AccentName, str] = {
    "vec": "arrow",
    "bar": "overline",
    "hat": "hat",
    "widehat": "hat",
    "tilde": "tilde",
    "dot": "dot",
    "ddot": "dot.double",
    "overline": "overline",
    "overrightarrow": "arrow",
    "underbrace": "underbrace",
    "boxed": "#box",
}
_FRAME = "stroke:0.5pt,inset:(x:2.4pt),outset:(y:2.6pt)"
_SAID_AROUND = 'alt:"□"'  # the words of the formula around the frame say what is in it
_STYLES: dict[Style, str] = {
    "mathrm": "upright({})",
    "mathbf": "upright(bold({}))",
    "mathit": "italic({})",
    "boldsymbol": "bold({})",
}
_FRACTIONS: dict[FractionName, str] = {
    "frac": "frac({}, {})",
    "dfrac": "display(frac({}, {}))",
    "tfrac": "inline(frac({}, {}))",
}
_SPACES: dict[SpaceName, str] = {
    ",": "thin",
    ";": "thick",
    ":": "med",
    "!": "",  # Typst has no name for a negative space
    " ": "thick",
    "quad": "quad",
    "qquad": "wide",
}
_EMPTY = '""'
_LINE_BREAK = "\\ "
_NO_BLANK = frozenset('"| ')  # beside these a blank would be printed


def write_typst_math(latex: str, where: Location) -> str:
    r"""Typst math (to stand between dollar signs) for `latex`, LaTeX math without dollar signs.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> write_typst_math(r"v_B = \frac{2\sqrt{3}}{3}\,\mathrm{m/s}", "q1")
    'v_(B) = frac(2 sqrt(3), 3) thin upright(m slash s)'
    """
    read_math(latex, where)
    return _write_once(latex)


@lru_cache(maxsize=8192)
def _write_once(latex: str) -> str:
    """The same wherever it is used, so that the papers of a class share it."""
    return write_typst_row(read_math(latex, ""))


def write_typst_row(row: Row) -> str:
    """The Typst math of a tree.

    >>> write_typst_row((Letter("omega"), Sign("("), Letter("t"), Sign(")")))
    'omega ( t )'
    """
    while row and isinstance(row[-1], LineBreak):
        row = row[:-1]  # before what follows, its backslash would be an escape
    typed = set(find_matched(row))
    return _join(_write_node(node, place in typed) for place, node in enumerate(row))


def _join(pieces: Iterable[str]) -> str:
    """Pieces with blanks between them, except where a blank would be printed."""
    joined = ""
    for piece in filter(None, pieces):
        blank = joined and joined[-1] not in _NO_BLANK and piece[0] not in _NO_BLANK
        joined += f" {piece}" if blank else piece
    return joined


def _write_node(node: Node, matched: bool = False) -> str:
    match node:
        case Letter(name):
            return GREEK[name].typst if name in GREEK else name
        case Number(digits):
            return digits
        case Sign(latex):
            return TYPED[latex] if matched else SIGNS[latex].typst
        case Function(name):
            return name
        case Text(text):
            return write_literal(raise_exponents(text))
        case Unit(text):
            return write_literal(write_unit(text))
        case Space(name):
            return _SPACES[name]
        case Group(row):
            return write_typst_row(row)
        case Scripts():
            return _write_scripts(node, matched)
        case LineBreak():
            return _LINE_BREAK
        case Mark():
            return "&"
        case _:
            return _write_call(node)


def _write_call(node: Quotient | Root | Lettering | Accent | Fenced | Environment) -> str:
    """What Typst writes as a function of its parts."""
    match node:
        case Quotient(name, above, below):
            return _FRACTIONS[name].format(_write_argument(above), _write_argument(below))
        case Root(radicand, degree):
            inside = _write_argument(radicand)
            return f"root({_write_argument(degree)}, {inside})" if degree else f"sqrt({inside})"
        case Lettering(style, row):
            return _STYLES[style].format(_write_argument(row))
        case Accent("boxed", row):
            inside = f"math.equation({_SAID_AROUND},${_write_argument(row)}$.body)"
            return f"{_ACCENTS['boxed']}({_FRAME},{inside}) "
        case Accent(name, row):
            return f"{_ACCENTS[name]}({_write_argument(row)})"
        case Fenced(left, row, right):
            return _write_fenced(left, write_typst_row(row), right)
        case Environment(name, row):
            return _write_lines(name, row)
        case _:
            assert_never(node)


def _write_argument(row: Row) -> str:
    return write_typst_row(row) or _EMPTY


def _write_fenced(left: str, inside: str, right: str) -> str:
    """A row between brackets of its height, which those are that Typst itself matches."""
    match find_bracket(Sign(left)), find_bracket(Sign(right)):
        case "opening", "closing":
            return f"{TYPED[left]}{inside}{TYPED[right]}"
        case _:
            return f"lr({_join((_write_fence(left), inside, _write_fence(right)))})"


def _write_fence(bracket: str) -> str:
    return "" if bracket == "." else SIGNS[bracket].typst


def _write_lines(name: EnvironmentName, row: Row) -> str:
    match name:
        case "cases":
            lines = ", ".join(_write_argument(line) for line in split_row(row, LineBreak))
            return f"cases({lines})"
        case "aligned":
            return write_typst_row(row)
        case _:
            assert_never(name)


@lru_cache(maxsize=2048)  # symbols with their indices, which formulas have again and again
def _write_scripts(node: Scripts, matched: bool) -> str:
    written = _write_base(node.base, matched) + "'" * node.primes
    if node.lower is not None:
        written += f"_({_write_argument(node.lower)})"
    if node.upper == DEGREE:
        return f"{written} degree"
    if node.upper is not None:
        written += f"^({_write_argument(node.upper)})"
    return written


def _write_base(base: Node | None, matched: bool) -> str:
    """What carries scripts: one thing to Typst too, and no brackets that would be printed."""
    match base:
        case None:
            return _EMPTY
        case Group(row) | Environment("aligned", row):
            return f"attach({_write_argument(row)})"
        case Letter() | Number() | Sign() | Function() | Text() | Unit() | Scripts():
            return _write_node(base, matched)
        case Space() | LineBreak() | Mark():
            return _write_node(base)
        case _:
            return _write_call(base)
