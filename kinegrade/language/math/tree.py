"""The tree of a formula: what `reading` makes of LaTeX math and what every writer writes.

A row is what stands side by side. The nodes are a closed union: a writer's `match` over them ends
in `assert_never`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias, assert_never

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


@dataclass(frozen=True, slots=True)
class Letter:
    """A Latin letter, or a Greek one by its LaTeX name."""

    name: str


@dataclass(frozen=True, slots=True)
class Number:
    """Digits, with a decimal point among them or none."""

    digits: str


@dataclass(frozen=True, slots=True)
class Sign:
    r"""A sign by its LaTeX: `+`, `\cdot`, or `{,}`, which is LaTeX's decimal comma."""

    latex: str


@dataclass(frozen=True, slots=True)
class Function:
    """A function by its name, such as sin."""

    name: str


@dataclass(frozen=True, slots=True)
class Text:
    """Words inside a formula, printed as they are with exponents raised."""

    text: str


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit as templates write it, such as m/s^2."""

    text: str


@dataclass(frozen=True, slots=True)
class Space:
    """Extra room, by its LaTeX without the backslash."""

    name: SpaceName


@dataclass(frozen=True, slots=True)
class Group:
    """What braces hold together."""

    row: Row


@dataclass(frozen=True, slots=True)
class Scripts:
    """What stands below and above a base, which may be empty; None where nothing stands."""

    base: Node | None
    lower: Row | None
    primes: int
    upper: Row | None


@dataclass(frozen=True, slots=True)
class Quotient:
    """One row above another."""

    name: FractionName
    above: Row
    below: Row


@dataclass(frozen=True, slots=True)
class Root:
    """A root; `degree` is None for a square root."""

    radicand: Row
    degree: Row | None


@dataclass(frozen=True, slots=True)
class Lettering:
    """A row in other letters: upright, bold or italic."""

    style: Style
    row: Row


@dataclass(frozen=True, slots=True)
class Accent:
    """A row with a mark over or under it, or in a frame."""

    name: AccentName
    row: Row


@dataclass(frozen=True, slots=True)
class Fenced:
    """A row between brackets of its height; a bracket is LaTeX, `.` for none."""

    left: str
    row: Row
    right: str


@dataclass(frozen=True, slots=True)
class Environment:
    """Lines below each other, which `LineBreak` and `Mark` divide."""

    name: EnvironmentName
    row: Row


@dataclass(frozen=True, slots=True)
class LineBreak:
    """The end of a line."""


@dataclass(frozen=True, slots=True)
class Mark:
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
