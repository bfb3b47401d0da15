"""The tree of a formula: what `reading` makes of LaTeX math and what every writer writes.

A row is what stands side by side. The nodes are a closed union: a writer's `match` over them ends
in `assert_never`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, TypeAlias, assert_never

from msgspec import Struct

Style: TypeAlias = Literal["mathrm", "mathbf", "mathit", "boldsymbol"]
AccentName: TypeAlias = Literal[
    "vec",
    "bar",
    "hat",
    "widehat",
    "tilde",
    "dot",
    "ddot",
    "overline",
    "overrightarrow",
    "underbrace",
    "boxed",
]
FractionName: TypeAlias = Literal["frac", "dfrac", "tfrac"]
SpaceName: TypeAlias = Literal[",", ";", ":", "!", " ", "quad", "qquad"]
EnvironmentName: TypeAlias = Literal["cases", "aligned"]


class Letter(Struct, frozen=True):
    """A Latin letter, or a Greek one by its LaTeX name."""

    name: str


class Number(Struct, frozen=True):
    """Digits, with a decimal point among them or none."""

    digits: str


class Sign(Struct, frozen=True):
    r"""A sign by its LaTeX: `+`, `\cdot`, or `{,}`, which is LaTeX's decimal comma."""

    latex: str


class Function(Struct, frozen=True):
    """A function by its name, such as sin."""

    name: str


class Text(Struct, frozen=True):
    """Words inside a formula, printed as they are with exponents raised."""

    text: str


class Unit(Struct, frozen=True):
    """A unit as templates write it, such as m/s^2."""

    text: str


class Space(Struct, frozen=True):
    """Extra room, by its LaTeX without the backslash."""

    name: SpaceName


class Group(Struct, frozen=True):
    """What braces hold together."""

    row: Row


class Scripts(Struct, frozen=True):
    """What stands below and above a base, which may be empty; None where nothing stands."""

    base: Node | None
    lower: Row | None
    primes: int
    upper: Row | None


class Quotient(Struct, frozen=True):
    """One row above another."""

    name: FractionName
    above: Row
    below: Row


class Root(Struct, frozen=True):
    """A root; `degree` is None for a square root."""

    radicand: Row
    degree: Row | None


class Lettering(Struct, frozen=True):
    """A row in other letters: upright, bold or italic."""

    style: Style
    row: Row


class Accent(Struct, frozen=True):
    """A row with a mark over or under it, or in a frame."""

    name: AccentName
    row: Row


class Fenced(Struct, frozen=True):
    """A row between brackets of its height; a bracket is LaTeX, `.` for none."""

    left: str
    row: Row
    right: str


class Environment(Struct, frozen=True):
    """Lines below each other, which `LineBreak` and `Mark` divide."""

    name: EnvironmentName
    row: Row


class LineBreak(Struct, frozen=True):
    """The end of a line."""


class Mark(Struct, frozen=True):
    """Where the lines of a display are aligned."""


Node: TypeAlias = (
    Letter
    | Number
    | Sign
    | Function
    | Text
    | Unit
    | Space
    | Group
    | Scripts
    | Quotient
    | Root
    | Lettering
    | Accent
    | Fenced
    | Environment
    | LineBreak
    | Mark
)
Row: TypeAlias = tuple[Node, ...]
PRIME = Sign(r"\prime")
DEGREE = (Sign(r"\circ"),)  # raised after a number, it is the degree sign


def split_row(row: Row, divider: type[LineBreak | Mark]) -> Iterator[Row]:
    """The parts of a row between its line breaks, or between its marks.

    >>> list(split_row((Letter("a"), Mark(), Letter("b")), Mark))
    [(Letter(name='a'),), (Letter(name='b'),)]
    """
    begin = 0
    for place, node in enumerate(row):
        if isinstance(node, divider):
            yield row[begin:place]
            begin = place + 1
    yield row[begin:]


def carries_scripts(node: Node) -> bool:
    """Whether an index or a power after a node is its own; after the others it stands alone."""
    match node:
        case Letter() | Number() | Sign() | Function() | Text() | Unit() | Scripts():
            return True
        case Group() | Quotient() | Root() | Lettering() | Accent() | Fenced() | Environment():
            return True
        case Space() | LineBreak() | Mark():
            return False
        case _:
            assert_never(node)


def list_nodes(row: Row) -> Iterator[Node]:
    """Every node of a row and of its parts."""
    for node in row:
        yield node
        for part in list_parts(node):
            yield from list_nodes(part)


def list_parts(node: Node) -> tuple[Row, ...]:
    """The rows that a node holds, in the order in which they are written."""
    match node:
        case Group(row) | Lettering(_, row) | Accent(_, row) | Environment(_, row):
            return (row,)
        case Fenced(_, row, _):
            return (row,)
        case Quotient(_, above, below):
            return above, below
        case Root(radicand, degree):
            return degree or (), radicand
        case Scripts(base, lower, _, upper):
            return () if base is None else (base,), lower or (), upper or ()
        case Letter() | Number() | Sign() | Function() | Text() | Unit():
            return ()
        case Space() | LineBreak() | Mark():
            return ()
        case _:
            assert_never(node)
