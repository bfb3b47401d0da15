"""How wide and how high a formula is when it is set as a display, in em of its text.

The widths are those of Computer Modern, with which Typst and TeX set formulas alike. What stands
beside what on a page follows from it, without asking a typesetter.
"""

from __future__ import annotations

from functools import lru_cache
from typing import assert_never

from msgspec import Struct

from kinegrade.language.math.letters import SIGNS
from kinegrade.language.math.spacing import SPACE_WIDTHS, is_function, is_sign_of, is_spaced
from kinegrade.language.math.tree import (
    Accent,
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
    Text,
    Unit,
    split_row,
)
from kinegrade.language.math.units import raise_exponents, write_unit

_CAPITALS = {"H": 0.91, "I": 0.53, "J": 0.66, "K": 0.92, "L": 0.68, "M": 1.08, "N": 0.91}
_CAPITALS |= {"S": 0.67, "W": 1.08, "X": 0.88}
_SMALL_LETTERS = {
    "i": 0.35,
    "j": 0.43,
    "k": 0.54,
    "l": 0.3,
    "m": 0.88,
    "n": 0.6,
    "t": 0.37,
    "w": 0.72,
}
_GREEK = 0.66  # the widest of the small ones
_GREEK_CAPITAL = 0.84
_CAPITAL, _SMALL = 0.84, 0.58
_DIGIT = 0.5
_WORDS = dict.fromkeys("frst ()", 0.4) | {
    "m": 0.84,
    "w": 0.73,
    "i": 0.28,
    "l": 0.28,
    "j": 0.31,
    ".": 0.28,
    ",": 0.28,
}
_WORD_LETTER = 0.56
_CHINESE = 1.0
FIRST_CHINESE = "\u2e80"
_ORDINARY_SIGN, _BRACKET, _RELATION, _BINARY = 0.5, 0.4, 0.78, 0.78
_DOT = 0.28
_AROUND_SIGN, _BESIDE_FUNCTION = 0.56, 0.17
_PRIME, _SCRIPT = 0.32, 0.72
_BOLD = 1.16
_BAR_SIDES = 0.2  # by which the bar of a fraction is longer than its parts
_ROOT, _HIGH_ROOT = 0.84, 1.0
_FENCE, _BAR = 0.75, 0.3
_WIDE_SIGNS = {r"\angle": 0.75, r"\curvearrowleft": 1.0, r"\curvearrowright": 1.0}
_FRAME = 0.5

_PLAIN_HEIGHT = 0.75
_OVER_BAR = 0.4
_RAISED, _LOWERED = 0.15, 0.2


class PrintedSize(Struct, frozen=True):
    """What a formula takes of a page, in em."""

    width: float
    height: float


@lru_cache(maxsize=4096)  # a page is laid out in many ways, with the same formulas
def measure_printed(row: Row) -> PrintedSize:
    r"""The size of a formula; its width is not smaller than what is printed.

    >>> from kinegrade.language.math.reading import read_math
    >>> measure_printed(read_math(r"v_B = \frac{2\sqrt{3}}{3}\,\mathrm{m/s}", "")).height > 1.5
    True
    """
    return PrintedSize(_find_width(row), _find_height(row))


def _find_width(row: Row) -> float:
    nodes = sum(map(_measure, row))
    return nodes + sum(_find_room(row, place) for place in range(len(row)))


def _find_room(row: Row, place: int) -> float:
    """The room around a node that comes from its neighbours."""
    node = row[place]
    if is_function(node):
        return 2 * _BESIDE_FUNCTION
    if is_sign_of(node, "punctuation"):
        return _BESIDE_FUNCTION
    return _AROUND_SIGN if is_spaced(row, place) else 0.0


def _measure(node: Node) -> float:
    match node:
        case Scripts(base, lower, primes, upper):
            carried = 0.0 if base is None else _measure(base)
            scripts = max(_find_width(lower or ()), _find_width(upper or ()))
            return carried + _PRIME * primes + _SCRIPT * scripts + 0.06
        case Quotient(_, above, below):
            return max(_find_width(above), _find_width(below)) + _BAR_SIDES
        case Root(radicand, degree):
            hook = _ROOT if _find_height(radicand) < 1 else _HIGH_ROOT
            return hook + _find_width(radicand) + 0.5 * _find_width(degree or ())
        case Fenced(left, row, right):
            return _measure_fence(left) + _find_width(row) + _measure_fence(right)
        case Lettering(_, row):
            return _BOLD * _find_width(row)
        case Accent("boxed", row):
            return _FRAME + _find_width(row)
        case Group(row) | Accent(_, row):
            return _find_width(row)
        case Environment(_, row):
            return max(map(_find_width, split_row(row, LineBreak)))
        case Letter() | Number() | Sign() | Function() | Text() | Unit():
            return _measure_alone(node)
        case Space() | LineBreak() | Mark():
            return _measure_alone(node)
        case _:
            assert_never(node)


def _measure_fence(bracket: str) -> float:
    """The width of a bracket as high as what it holds; `.` is none."""
    match bracket:
        case ".":
            return 0.0
        case "|":
            return _BAR
        case _:
            return _FENCE


def _measure_alone(
    node: Letter | Number | Sign | Function | Text | Unit | Space | LineBreak | Mark,
) -> float:
    match node:
        case Letter(name):
            return _measure_letter(name)
        case Number(digits):
            return _DIGIT * len(digits) + 0.02
        case Sign(latex):
            return _measure_sign(latex)
        case Function(text):
            return measure_words(text)
        case Text(text):
            return measure_words(raise_exponents(text))
        case Unit(text):
            return measure_words(write_unit(text))
        case Space(name):
            return SPACE_WIDTHS[name]
        case LineBreak() | Mark():
            return 0.0
        case _:
            assert_never(node)


def _measure_letter(name: str) -> float:
    if len(name) > 1:
        return _GREEK_CAPITAL if name[0].isupper() else _GREEK
    return _CAPITALS.get(name, _CAPITAL) if name.isupper() else _SMALL_LETTERS.get(name, _SMALL)


def _measure_sign(latex: str) -> float:
    if latex in (r"\cdot", ".", ",", "{,}", "|"):
        return _DOT
    if latex in _WIDE_SIGNS:
        return _WIDE_SIGNS[latex]
    match SIGNS[latex].kind:
        case "relation":
            return _RELATION
        case "binary":
            return _BINARY
        case "opening" | "closing":
            return _BRACKET
        case "large":
            return 1.5
        case "ordinary" | "punctuation":
            return _ORDINARY_SIGN
        case _ as kind:
            assert_never(kind)


def measure_words(text: str) -> float:
    """The width of words within a formula, or of plain text, in em; never too small.

    >>> round(measure_words("rad/s"), 2) >= 2.26
    True
    """
    return sum(map(_measure_character, text))


def _measure_character(character: str) -> float:
    if character >= FIRST_CHINESE:
        return _CHINESE
    if character.isupper():
        return _CAPITALS.get(character, 0.8)
    return _WORDS.get(character, _WORD_LETTER)


def _find_height(row: Row) -> float:
    """How high a row is, as if all stood on one line."""
    return max(map(_find_node_height, row), default=_PLAIN_HEIGHT)


def _find_node_height(node: Node) -> float:
    match node:
        case Quotient(_, above, below):
            return _find_height(above) + _find_height(below) + _OVER_BAR
        case Scripts(base, lower, _, upper):
            carried = _PLAIN_HEIGHT if base is None else _find_node_height(base)
            return carried + _LOWERED * (lower is not None) + _RAISED * (upper is not None)
        case Root(row, _) | Accent(_, row) | Fenced(_, row, _):
            return _find_height(row) + _RAISED
        case Group(row) | Lettering(_, row):
            return _find_height(row)
        case Environment(_, row):
            return (1 + row.count(LineBreak())) * (_find_height(row) + 0.6)
        case Letter() | Number() | Sign() | Function() | Text() | Unit():
            return _PLAIN_HEIGHT
        case Space() | LineBreak() | Mark():
            return _PLAIN_HEIGHT
        case _:
            assert_never(node)
