"""The equations of a worked solution, taken apart at their relation signs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache

from msgspec.structs import replace

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Lettering, Mark, Node, Row, Scripts, Sign, Space
from kinegrade.worked.case import write_row
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Term,
    TermTable,
)
from tests.worked.telling import unbox

RELATIONS = ("=", r"\approx", r"\propto", ":")


@dataclass(frozen=True)
class Side:
    """What stands to the right of a relation sign."""

    relation: str
    row: Row


@dataclass(frozen=True)
class Line:
    """An equation with all that it goes on to; `left` alone where there is no relation sign."""

    left: Row
    sides: tuple[Side, ...]

    @property
    def text(self) -> str:
        """The equation, to be looked at."""
        sides = (f" {side.relation} {write_row(side.row)}" for side in self.sides)
        return write_row(self.left) + "".join(sides)


@dataclass(frozen=True)
class Said:
    """A formula that names things without an equation: in a sentence or a table."""

    row: Row


def read_page(blocks: Iterable[Block]) -> Iterator[Line | Said]:
    """All formulas in the order of the page."""
    for block in blocks:
        match block:
            case Display(lines):
                yield from map(_part, _join_continued(map(unbox, lines)))
            case Prose(text) | Heading(text, _):
                yield from _read_prose(text)
            case TermTable(terms):
                for term in terms:
                    yield from _read_term(term)
            case Pictures():
                continue


def _read_term(term: Term) -> Iterator[Line | Said]:
    """The vector of a column, what its magnitude is worth, and its direction."""
    symbol = _drop_bold(term.symbol)
    yield Said(symbol)
    known = "?" not in term.magnitude
    for part in _read_prose(term.magnitude):
        match part:
            case Line(left, sides) if known:
                yield Line(symbol, (Side("=", left), *sides))
            case Said(row) if known:
                yield Line(symbol, (Side("=", row),))
            case Said((Sign("("), *product, Sign(")"))):  # an unknown vector's arm and rotation
                yield from (Said((factor,)) for factor in product)
            case _:
                yield part
    yield from _read_prose(term.direction)


def _drop_bold(row: Row) -> Row:
    """The magnitude of a vector: its letter in italics."""
    return tuple(
        replace(node, base=node.base.row[0])
        if isinstance(node, Scripts) and isinstance(node.base, Lettering)
        else node
        for node in row
    )


@cache
def _read(latex: str) -> Row:
    return read_math(latex, "test")


def _read_prose(text: str) -> Iterator[Line | Said]:
    """The formulas of a sentence."""
    for latex in re.findall(r"\$([^$]*)\$", text):
        line = _part(_read(latex))
        yield line if line.sides else Said(line.left)


def _join_continued(lines: Iterable[Row]) -> Iterator[Row]:
    """The lines of a display, each with those that continue it."""
    joined: Row = ()
    for line in lines:
        if joined and line[:1] != (Mark(),):
            yield joined
            joined = ()
        joined += tuple(node for node in line if not isinstance(node, Mark))
    if joined:
        yield joined


def _part(row: Row) -> Line:
    """An equation at its relation signs, without what is said beside it."""
    groups: list[tuple[str, list[Node]]] = [("", [])]
    for node in row:
        if isinstance(node, Space) and node.name in ("quad", "qquad"):
            break
        if isinstance(node, Sign) and node.latex in RELATIONS:
            groups.append((node.latex, []))
        else:
            groups[-1][1].append(node)
    (_, left), *others = groups
    return Line(_trim(left), tuple(Side(relation, _trim(nodes)) for relation, nodes in others))


def _trim(nodes: list[Node]) -> Row:
    """A row without a comma or spaces at its ends."""
    loose = (Sign(","), Space(","), Space(" "))
    while nodes and nodes[-1] in loose:
        nodes.pop()
    while nodes and isinstance(nodes[0], Space):
        nodes.pop(0)
    return tuple(nodes)
