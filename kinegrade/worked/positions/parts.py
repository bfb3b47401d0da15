"""The parts of the chapter on positions: what each says of a point, which of them a solution needs,
and how they are written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias, assert_never

from kinegrade.language.math.tree import Row, Scripts, list_nodes
from kinegrade.language.message import Message, list_plainly
from kinegrade.worked.case import Case
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    TermTable,
)
from kinegrade.worked.formulas.atoms import Symbol


@dataclass(frozen=True)
class Coordinate:
    """A coordinate of a point by its symbol, and the lines that work it out."""

    symbol: Symbol
    lines: tuple[Row, ...]


@dataclass(frozen=True)
class Coordinates:
    """Points given by their coordinates alone."""

    letters: tuple[str, ...]
    found: tuple[Coordinate, ...]


@dataclass(frozen=True)
class Placed:
    """A point whose coordinates follow at once from where it lies, as a sentence says; the origin
    has none to work out.
    """

    sentence: Message
    found: tuple[Coordinate, ...]


# Or the blocks of a longer construction
Part: TypeAlias = Coordinates | Placed | tuple[Block, ...]


def select_used(parts: Sequence[Part], later: Sequence[Block], case: Case) -> tuple[Part, ...]:
    """The parts without the coordinates that neither later blocks nor the parts left refer to, and
    without the points of which nothing is left; none where that is the origin alone.
    """
    kept: list[Part] = []
    readers = list(later)
    for part in reversed(parts):
        match part:
            case Coordinates() | Placed():
                found = tuple(_list_used(part.found, readers, case))
                if found or not part.found:
                    kept.append(replace(part, found=found))
                    readers.append(_display(found))
            case tuple():
                kept.append(part)
                readers += part
            case _:
                assert_never(part)
    worked_out = any(not isinstance(part, Placed) or part.found for part in kept)
    return tuple(reversed(kept)) if worked_out else ()


def _list_used(
    found: Iterable[Coordinate], readers: Sequence[Block], case: Case
) -> Iterator[Coordinate]:
    for coordinate in found:
        if any(_mentions(block, coordinate.symbol, case) for block in readers):
            yield coordinate


def _mentions(block: Block, symbol: Symbol, case: Case) -> bool:
    """Whether a block refers to a symbol, in its formulas or in a sentence."""
    text = case.text(symbol)
    match block:
        case Display():
            return any(_is_in(symbol, line) for line in block.lines)
        case Heading() | Prose():
            return text in block.text
        case TermTable():
            cells = (cell for term in block.terms for cell in (term.magnitude, term.direction))
            return any(text in cell for cell in cells)
        case Pictures():
            return any(text in picture.caption for picture in block.pictures)
        case _:
            assert_never(block)


def _is_in(symbol: Symbol, line: Row) -> bool:
    """Whether a symbol stands in a line, with an exponent or without."""
    nodes = (node for node in list_nodes(line) if isinstance(node, Scripts))
    return any((replace(node, upper=None),) == symbol.row for node in nodes)


def write_parts(parts: Iterable[Part], case: Case) -> tuple[Block, ...]:
    """The blocks of parts; neighbouring points that are given by their coordinates share a
    sentence.
    """
    blocks: list[Block] = []
    for part in _join_neighbours(parts):
        match part:
            case Coordinates():
                blocks += (case.say(_announce(part.letters)), _display(part.found))
            case Placed():
                blocks += (case.say(part.sentence), *([_display(part.found)] if part.found else []))
            case tuple():
                blocks += part
            case _:
                assert_never(part)
    return tuple(blocks)


def _join_neighbours(parts: Iterable[Part]) -> list[Part]:
    joined: list[Part] = []
    for part in parts:
        before = joined[-1] if joined else None
        if isinstance(part, Coordinates) and isinstance(before, Coordinates):
            joined[-1] = Coordinates(before.letters + part.letters, before.found + part.found)
        else:
            joined.append(part)
    return joined


def _announce(letters: Sequence[str]) -> Message:
    points = list_plainly(f"${letter}$" for letter in letters)
    if len(letters) == 1:
        return Message("solution.coordinates", points=points)
    return Message("solution.coordinates-of-several", points=points)


def _display(found: Iterable[Coordinate]) -> Display:
    return Display(tuple(line for coordinate in found for line in coordinate.lines))
