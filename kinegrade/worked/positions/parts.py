"""The parts of the chapter on positions: what each says of a point, which of them a solution needs,
and how they are written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TypeAlias, assert_never

from msgspec import structs

from kinegrade.language.math.tree import Letter, Node, Row, Scripts, list_nodes
from kinegrade.language.message import Message, list_plainly
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.atoms import Symbol

COORDINATES = (Letter("x"), Letter("y"))


@dataclass(frozen=True)
class Derived:
    """A coordinate of a point or a named length by its symbol, and the lines that work it out;
    `reason` says before where an angle in them comes from; `is_zero` where it has none to work out.
    """

    symbol: Symbol
    lines: tuple[Row, ...]
    reason: Message | None = None
    is_zero: bool = False


@dataclass(frozen=True)
class Coordinates:
    """Points given by their coordinates alone."""

    letters: tuple[str, ...]
    found: tuple[Derived, ...]


@dataclass(frozen=True)
class Stated:
    """A point whose coordinates follow at once from where it lies, or lengths, as a sentence says;
    the origin has none to work out. `before` are the lengths that lead to the coordinates.
    """

    sentence: Message
    found: tuple[Derived, ...]
    before: tuple[Derived, ...] = ()


# Or the blocks of a longer construction
Part: TypeAlias = Coordinates | Stated | tuple[Block, ...]


def select_used(parts: Sequence[Part], later: Iterable[Row]) -> tuple[Part, ...]:
    """The parts without the coordinates and lengths that neither later formulas nor the parts left
    refer to, and without those of which nothing is left; without the origin where no coordinate
    is left.
    """
    kept: list[Part] = []
    met = find_symbols(later)
    for part in reversed(parts):
        match part:
            case Coordinates() | Stated():
                found = _select_met(part.found, met)
                before = part.before if isinstance(part, Stated) else ()
                if found or not part.found:
                    kept.append(replace(part, found=found))
                elif any(is_met(each.symbol, met) for each in before):
                    found, before = before, ()
                    kept.append(Stated(Message("solution.lengths"), found))
                else:
                    before = ()
                met |= find_symbols(_display((*before, *found)).lines)
            case tuple():
                kept.append(part)
                met |= find_symbols(list_lines(part))
            case _:
                assert_never(part)
    placed = _has_coordinates(met)
    return tuple(part for part in reversed(kept) if placed or not _is_origin(part))


def _is_origin(part: Part) -> bool:
    """Whether a part says where the origin is."""
    return isinstance(part, Stated) and not part.found


def _select_met(found: Sequence[Derived], met: Set[Node]) -> tuple[Derived, ...]:
    """Those to which later formulas refer, or the lines of those that follow them; with these a
    coordinate that is 0, of which formulas make no term.
    """
    kept, known = list[Derived](), set(met)
    for each in reversed(found):
        if is_met(each.symbol, known):
            kept.append(each)
            known |= find_symbols(each.lines)
    return tuple(each for each in found if each in kept or (kept and each.is_zero))


def _has_coordinates(met: Set[Node]) -> bool:
    """Whether formulas refer to a coordinate of a point."""
    indexed = (node for node in met if isinstance(node, Scripts) and node.lower)
    return any(node.base in COORDINATES for node in indexed)


def list_lines(blocks: Iterable[Block]) -> Iterator[Row]:
    """The lines of all equations that are displayed."""
    for block in blocks:
        if isinstance(block, Display):
            yield from block.lines


def is_met(symbol: Symbol, met: Set[Node]) -> bool:
    """Whether formulas refer to a symbol; one of several letters, where they have them all."""
    return all(node in met for node in symbol.row)


def find_symbols(rows: Iterable[Row]) -> set[Node]:
    """The letters, with an index or without one, that formulas refer to; exponents are left out."""
    return set().union(*map(_find_row_symbols, rows))


@lru_cache(maxsize=2048)  # solutions ask what is met further down, line after line
def _find_row_symbols(row: Row) -> frozenset[Node]:
    nodes = list(list_nodes(row))
    indexed = (structs.replace(node, upper=None) for node in nodes if isinstance(node, Scripts))
    return frozenset((*indexed, *(node for node in nodes if isinstance(node, Letter))))


def write_parts(parts: Iterable[Part], case: Case) -> tuple[Block, ...]:
    """The blocks of parts; neighbouring points that are given by their coordinates share a
    sentence.
    """
    blocks: list[Block] = []
    for part in _join_neighbours(parts):
        match part:
            case Coordinates():
                reasons = dict.fromkeys(one.reason for one in part.found if one.reason is not None)
                blocks += map(case.say, (*reasons, _announce(part.letters)))
                blocks.append(_display(part.found))
            case Stated():
                lines = _display((*part.before, *part.found))
                blocks += (case.say(part.sentence), *([lines] if lines.lines else []))
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


def _display(found: Iterable[Derived]) -> Display:
    return Display(tuple(line for coordinate in found for line in coordinate.lines))
