r"""Formulas as LaTeX math, in the dialect of whoever sets it: TeX, MathJax in a browser, pandoc.

Commands come from the tables. What differs between dialects is how words and units are written;
each escapes them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import assert_never

from kinegrade.language.math.latex_text import write_raised
from kinegrade.language.math.latex_text import write_unit as write_tex_unit
from kinegrade.language.math.letters import GREEK
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spacing import is_spaced
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
from kinegrade.language.math.units import raise_exponents, write_unit
from kinegrade.language.message import Location

_CONTROL_WORD = re.compile(r"\\[A-Za-z]+\Z")
_DEGREES, _RING = re.compile(r"\bdeg\b"), r"{}^{\\circ}"
_PLAIN_UNIT = re.compile(r"[A-Za-z0-9/*^{}\-]+")
_AFTER_LINE_BREAK = frozenset("[*")  # these would be taken for its options
_OBEYED = re.compile(r"([\\$%])")
_OUTSIDE = {"\\": r"\backslash", "$": r"\$", "%": r"\%"}


_DOT = r"{\cdot}"


@dataclass(frozen=True)
class LatexDialect:
    """How words, units and the decimal comma are written inside a formula."""

    write_text: Callable[[str], str]
    write_unit: Callable[[str], str]
    comma: str = "{,}"


def _write_unread_text(text: str) -> str:
    r"""`\text{...}` for programs that take it as it is, but for three signs, written beside it.

    >>> print(_write_unread_text("5 % of m/s^2"))
    \text{5 }\%\text{ of m/s²}
    """
    parts = _OBEYED.split(raise_exponents(text))
    return "".join(_OUTSIDE.get(part) or rf"\text{{{part}}}" for part in parts if part) or "{}"


def _write_upright_unit(unit: str) -> str:
    if unit == "deg":
        return r"{}^{\circ}"
    if not _PLAIN_UNIT.fullmatch(unit):
        return _write_unread_text(write_unit(unit))
    raised = raise_exponents(unit, write_raised=lambda exponent: f"^{{{exponent}}}")
    return rf"\mathrm{{{_DEGREES.sub(_RING, raised).replace('·', _DOT)}}}"


TEX = LatexDialect(
    lambda text: rf"\text{{{write_raised(text)}}}",
    lambda unit: rf"\text{{{write_tex_unit(unit)}}}",
)
MATHJAX = LatexDialect(_write_unread_text, _write_upright_unit)
# What `reading` reads back: formulas within prose
SOURCE = LatexDialect(lambda text: rf"\text{{{text}}}", lambda unit: rf"\unit{{{unit}}}")
# Pandoc would write a space after the comma of {,}
PANDOC = LatexDialect(
    _write_unread_text, lambda unit: _write_unread_text(write_unit(unit)), r"\text{,}"
)


def write_latex_math(latex: str, where: Location, dialect: LatexDialect = TEX) -> str:
    r"""LaTeX math without dollar signs, on one line, for `latex` as authors write it.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> print(write_latex_math(r"v = 2\,\unit{m/s^2}", "q1"))
    v = 2\,\text{m/s\textsuperscript{2}}
    >>> print(write_latex_math(r"v = 2\,\unit{m/s^2}", "q1", MATHJAX))
    v = 2\,\mathrm{m/s^{2}}
    """
    read_math(latex, where)
    return _write_once(latex, dialect)


@lru_cache(maxsize=8192)
def _write_once(latex: str, dialect: LatexDialect) -> str:
    """The same wherever it is used, so that the papers of a class share it."""
    return write_latex_row(read_math(latex, ""), dialect)


def write_latex_row(row: Row, dialect: LatexDialect) -> str:
    """The LaTeX of a tree, with blanks where a person would put them."""
    written, blank = "", False
    for place, node in enumerate(row):
        piece = _write_node(node, dialect)
        spaced = is_spaced(row, place) or isinstance(node, Mark | LineBreak)
        ends_command = piece[:1].isalnum() and _CONTROL_WORD.search(written)
        if written.endswith(r"\\") and piece[:1] in _AFTER_LINE_BREAK:
            written += "{}"
        if written and (blank or spaced or ends_command) and not written.endswith("&"):
            written += " "
        written += piece
        blank = spaced
    return written


def _write_node(node: Node, dialect: LatexDialect) -> str:
    match node:
        case Letter(name):
            return rf"\{name}" if name in GREEK else name
        case Number(digits):
            return digits
        case Sign(latex):
            return dialect.comma if latex == "{,}" else latex
        case Function(name) | Space(name):
            return rf"\{name}"
        case Text(text):
            return dialect.write_text(text)
        case Unit(text):
            return dialect.write_unit(text)
        case LineBreak():
            return r"\\"
        case Mark():
            return "&"
        case Group(row):
            return _write_braced(row, dialect)
        case Scripts():
            return _write_scripts(node, dialect)
        case _:
            return _write_command(node, dialect)


def _write_command(
    node: Quotient | Root | Lettering | Accent | Fenced | Environment, dialect: LatexDialect
) -> str:
    """What LaTeX writes as a command with its arguments."""
    match node:
        case Quotient(name, above, below):
            return rf"\{name}{_write_braced(above, dialect)}{_write_braced(below, dialect)}"
        case Root(radicand, degree):
            index = "" if degree is None else f"[{write_latex_row(degree, dialect)}]"
            return rf"\sqrt{index}{_write_braced(radicand, dialect)}"
        case Lettering(name, row) | Accent(name, row):
            return rf"\{name}{_write_braced(row, dialect)}"
        case Fenced(left, row, right):
            return rf"\left{left}{write_latex_row(row, dialect)}\right{right}"
        case Environment(name, row):
            return rf"\begin{{{name}}} {write_latex_row(row, dialect)} \end{{{name}}}"
        case _:
            assert_never(node)


def _write_braced(row: Row, dialect: LatexDialect) -> str:
    return f"{{{write_latex_row(row, dialect)}}}"


def _write_scripts(node: Scripts, dialect: LatexDialect) -> str:
    written = "{}" if node.base is None else _write_node(node.base, dialect)
    written += "'" * node.primes
    if node.lower is not None:
        written += f"_{_write_script(node.lower, dialect)}"
    if node.upper is not None:
        written += f"^{_write_script(node.upper, dialect)}"
    return written


def _write_script(row: Row, dialect: LatexDialect) -> str:
    """A script: a degree sign, or braces."""
    inside = write_latex_row(row, dialect)
    return inside if row == DEGREE else f"{{{inside}}}"
