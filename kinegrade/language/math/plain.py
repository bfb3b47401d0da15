r"""Formulas as one line of plain text, for titles and for systems that show no math: `\omega_{AB}`
becomes ω_AB.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import assert_never

from kinegrade.language.math.letters import SIGNS, find_letter
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spacing import SPACE_WIDTHS, is_function, is_spaced
from kinegrade.language.math.tree import (
    DEGREE,
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
)
from kinegrade.language.math.units import raise_digits, raise_exponents, write_unit
from kinegrade.language.message import Location

_TYPED = frozenset("-*")  # as on a keyboard, which every system shows
_ATOM = re.compile(r"[^\W_]+(?:_[^\W_]+)?|[0-9.]+")
_DIGITS = re.compile(r"-?[0-9]+")
_BLANKS = re.compile(r"\s+")


def write_plain_math(latex: str, where: Location = "text") -> str:
    r"""A formula in one line of plain text.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> write_plain_math(r"v_B = \frac{2\sqrt{3}}{3}\,\unit{m/s^2}"), write_plain_math(r"30^\circ")
    ('v_B = (2√3)/3 m/s²', '30°')
    """
    read_math(latex, where)
    return _write_once(latex)


@lru_cache(maxsize=4096)
def _write_once(latex: str) -> str:
    return write_plain_row(read_math(latex, ""))


def write_plain_row(row: Row) -> str:
    """The text of a tree."""
    written = ""
    for place, node in enumerate(row):
        piece = _write_node(node)
        function_before = place > 0 and is_function(row[place - 1])
        if is_spaced(row, place):
            piece = f" {piece} "
        elif _meet(written, piece) and (function_before or is_function(node)):
            piece = f" {piece}"
        written += piece
    return _BLANKS.sub(" ", written).strip()


def _meet(before: str, after: str) -> bool:
    """Whether a letter or a digit would touch another."""
    return before[-1:].isalnum() and after[:1].isalnum()


def _write_node(node: Node) -> str:
    match node:
        case Letter(name):
            return find_letter(name)
        case Number(digits):
            return digits
        case Sign(latex):
            return _write_sign(latex)
        case Function(name):
            return name
        case Text(text):
            return raise_exponents(text)
        case Unit(text):
            return write_unit(text)
        case Space(name):
            return " " if SPACE_WIDTHS[name] > 0 else ""
        case Mark():
            return " "
        case LineBreak():
            return "; "
        case Scripts():
            return _write_scripts(node)
        case _:
            return _write_rows(node)


def _write_sign(latex: str) -> str:
    character = latex if latex in _TYPED else SIGNS[latex].character
    kind = SIGNS[latex].kind
    match kind:
        case "punctuation":
            return f"{character} "
        case "ordinary" | "relation" | "binary" | "opening" | "closing" | "large":
            return character
        case _:
            assert_never(kind)


def _write_rows(node: Group | Quotient | Root | Lettering | Accent | Fenced | Environment) -> str:
    match node:
        case Group(row) | Lettering(_, row) | Accent(_, row) | Environment(_, row):
            return write_plain_row(row)
        case Quotient(_, above, below):
            return f"{_write_bracketed(above)}/{_write_bracketed(below)}"
        case Root(radicand, degree):
            index = "" if degree is None else _write_raised(degree)
            return f"{index}√{_write_bracketed(radicand)}"
        case Fenced(left, row, right):
            return f"{_write_fence(left)}{write_plain_row(row)}{_write_fence(right)}"
        case _:
            assert_never(node)


def _write_fence(bracket: str) -> str:
    return "" if bracket == "." else SIGNS[bracket].character


def _write_bracketed(row: Row) -> str:
    text = write_plain_row(row)
    return text if not text or _ATOM.fullmatch(text) else f"({text})"


def _write_scripts(node: Scripts) -> str:
    written = "" if node.base is None else _write_node(node.base)
    if node.lower is not None:
        index = write_plain_row(node.lower)
        written += f"_{index}" if index.isalnum() else f"_({index})"
    written += "'" * node.primes
    return written if node.upper is None else written + _write_raised(node.upper)


def _write_raised(row: Row) -> str:
    if row == DEGREE:
        return "°"
    text = write_plain_row(row)
    return raise_digits(text) if _DIGITS.fullmatch(text) else f"^{_write_bracketed(row)}"
