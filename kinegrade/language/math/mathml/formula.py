"""Formulas as MathML Core, which browsers set themselves.

Every character of a formula is escaped; the only tags are those made here.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from html import escape
from itertools import groupby
from typing import assert_never

from kinegrade.language.math.letters import SIGNS, find_letter
from kinegrade.language.math.mathml.elements import (
    ACCENTS,
    FRACTIONS,
    Face,
    write_attached,
    write_fence,
    write_letters,
    write_sign,
    write_space,
    write_text,
    write_weight,
)
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spacing import is_function, is_spaced
from kinegrade.language.math.tree import (
    DEGREE,
    PRIME,
    Accent,
    Environment,
    EnvironmentName,
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
from kinegrade.language.message import Location


def write_mathml(latex: str, where: Location) -> str:
    r"""A formula as a `math` element, which is well-formed XML too.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> print(write_mathml(r"\omega_{1}", "q1"))
    <math><msub><mi>ω</mi><mn>1</mn></msub></math>
    """
    read_math(latex, where)
    return _write_once(latex)


@lru_cache(maxsize=4096)
def _write_once(latex: str) -> str:
    """The same wherever it is used, so that the pages of a class share it."""
    return write_mathml_row(read_math(latex, ""))


def write_mathml_row(row: Row, said: str = "") -> str:
    """The `math` element of a tree, with what is said of it where a cell or a button has its name
    from the formula alone: not all that read pages aloud look into one for it.
    """
    label = f' aria-label="{escape(said)}"' if said else ""
    return f"<math{label}>{_write_row(row, Face())}</math>"


def _write_row(row: Row, face: Face) -> str:
    if any(isinstance(node, LineBreak | Mark) for node in row):
        return _write_table(row, face)
    return "".join(_write_pieces(row, face))


def _write_pieces(row: Row, face: Face) -> Iterator[str]:
    """The elements of a row; upright letters side by side are one word."""
    place = 0
    for are_letters, run in groupby(row, lambda node: face.upright and isinstance(node, Letter)):
        nodes = tuple(run)
        if are_letters:
            names = [node.name for node in nodes if isinstance(node, Letter)]
            yield write_letters("".join(map(find_letter, names)), face)
        else:
            for shift, node in enumerate(nodes):
                yield _write_piece(row, place + shift, node, face)
        place += len(nodes)


def _write_piece(row: Row, place: int, node: Node, face: Face) -> str:
    if isinstance(node, Sign) and SIGNS[node.latex].kind == "binary" and not is_spaced(row, place):
        return f'<mo form="prefix">{SIGNS[node.latex].character}</mo>'
    written = _write_node(node, face)
    if is_function(node) and not _closes_up(row[place + 1 : place + 2]):
        written += write_space(",")
    return written


def _closes_up(following: Row) -> bool:
    """Whether no room is left between a function and what follows: a bracket, or nothing."""
    return not following or isinstance(following[0], Fenced) or following[0] == Sign("(")


def _write_node(node: Node, face: Face) -> str:
    match node:
        case Letter(name):
            return write_letters(find_letter(name), face)
        case Number(digits):
            return f"<mn{write_weight(face)}>{digits}</mn>"
        case Sign(latex):
            return write_sign(latex)
        case Function(name):
            return f"<mi>{name}</mi>"
        case Text(text):
            return write_text(raise_exponents(text))
        case Unit(text):
            return write_text(write_unit(text))
        case Space(name):
            return write_space(name)
        case LineBreak() | Mark():
            return ""
        case Lettering(style, row):
            return _write_grouped(row, face.change(style))
        case Group(row):
            return _write_grouped(row, face)
        case Scripts():
            return _write_scripts(node, face)
        case _:
            return _write_structure(node, face)


def _write_grouped(row: Row, face: Face) -> str:
    """A row as one element, whatever it holds."""
    inside = _write_row(row, face)
    return inside if len(row) == 1 and not _is_many(row[0]) else f"<mrow>{inside}</mrow>"


def _is_many(node: Node) -> bool:
    """Whether a node that stands alone may be written as several elements, or as none."""
    return isinstance(node, Scripts | LineBreak | Mark)


def _write_structure(node: Quotient | Root | Accent | Fenced | Environment, face: Face) -> str:
    match node:
        case Quotient(name, above, below):
            parts = _write_grouped(above, face) + _write_grouped(below, face)
            return f"<mfrac{FRACTIONS[name]}>{parts}</mfrac>"
        case Root(radicand, degree):
            inside = _write_grouped(radicand, face)
            if degree is None:
                return f"<msqrt>{inside}</msqrt>"
            return f"<mroot>{inside}{_write_grouped(degree, face)}</mroot>"
        case Accent("underbrace", row):
            return f"<munder>{_write_grouped(row, face)}{ACCENTS['underbrace']}</munder>"
        case Accent("boxed", row):
            return f"<mrow{ACCENTS['boxed']}>{_write_row(row, face)}</mrow>"
        case Accent(name, row):
            mark = ACCENTS[name]
            return f'<mover accent="true">{_write_grouped(row, face)}{mark}</mover>'
        case Fenced(left, row, right):
            inside = _write_row(row, face)
            return f"<mrow>{write_fence(left)}{inside}{write_fence(right)}</mrow>"
        case Environment(name, row):
            return _write_environment(name, row, face)
        case _:
            assert_never(node)


def _write_environment(name: EnvironmentName, row: Row, face: Face) -> str:
    match name:
        case "aligned":
            return _write_table(row, face)
        case "cases":
            return f"<mrow>{write_fence(chr(92) + '{')}{_write_table(row, face, 'left')}</mrow>"
        case _:
            assert_never(name)


def _write_table(row: Row, face: Face, first: str = "right") -> str:
    """Lines below each other; columns are aligned right and left in turn."""
    lines = "".join(
        f"<mtr>{_write_cells(line, face, first)}</mtr>" for line in split_row(row, LineBreak)
    )
    style = ' displaystyle="true"' if first == "right" else ""  # fractions as tall as in print
    return f"<mtable{style}>{lines}</mtable>"


def _write_cells(line: Row, face: Face, first: str) -> str:
    return "".join(
        f'<mtd style="text-align: {"left" if index % 2 else first}">{_write_row(cell, face)}</mtd>'
        for index, cell in enumerate(split_row(line, Mark))
    )


def _write_scripts(node: Scripts, face: Face) -> str:
    base = "<mrow></mrow>" if node.base is None else _write_grouped((node.base,), face)
    below = None if node.lower is None else _write_grouped(node.lower, face)
    if node.upper == DEGREE:
        return write_attached(base, below, _write_raised((PRIME,) * node.primes, face)) + (
            "<mi>°</mi>"
        )
    raised = (*(PRIME,) * node.primes, *(node.upper or ()))
    return write_attached(base, below, _write_raised(raised, face))


def _write_raised(row: Row, face: Face) -> str | None:
    return _write_grouped(row, face) if row else None
