"""A finished solution without the coordinates that nothing takes up: of a pole, of a point that a
triangle or a length has placed; nor a component along an axis that is not asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.math.tree import (
    Accent,
    Letter,
    Mark,
    Node,
    Number,
    Row,
    Scripts,
    Sign,
    list_nodes,
)
from kinegrade.worked.answers.boxes import find_value
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable
from kinegrade.worked.positions.parts import find_symbols

_COORDINATES = (Letter("x"), Letter("y"))
_VECTORS = (Letter("v"), Letter("a"))


def leave_out_unused(blocks: Sequence[Block], told: Sequence[Row]) -> tuple[Block, ...]:
    """The blocks without coordinates, and components of vectors along an axis, that are neither
    zero nor answers, and that neither a formula further down nor one of sentences, `told`, takes up
    by letter or by number; an equation or a sentence that led to these alone is left out with them.
    """
    page = _Page(find_symbols(told), [], set())
    kept = list[Block]()
    below = list[bool]()  # whether anything is left of each display that a sentence leads to
    for block in reversed(blocks):
        match block:
            case Display(lines):
                left = page.select(lines)
                below.append(bool(left))
                kept += [Display(left)] if left else []
            case Prose(text, formulas):
                page.said.extend(map(_flatten, formulas))
                if not below or any(below) or not text.endswith((":", "：")):
                    kept.append(block)
                below.clear()
            case Heading() | TermTable() | Pictures():
                kept.append(block)
                below.clear()
            case _:
                assert_never(block)
    return tuple(reversed(kept))


@dataclass(frozen=True)
class _Page:
    """What stands further down: the letters met, and the formulas of sentences, node by node; and
    the coordinates left out there.
    """

    met: set[Node]
    said: list[Row]
    dropped: set[Node]

    def select(self, lines: Sequence[Row]) -> tuple[Row, ...]:
        """The lines of the equations that are taken up; their letters count as met from then on."""
        kept, going_on = list[Row](), list[Row]()
        for line in reversed(lines):
            going_on.append(line)
            left = line[: line.index(Mark())] if Mark() in line else line
            if left and self._keeps(left, going_on):
                kept += going_on
                self.met.update(find_symbols(going_on))
            elif left and _is_coordinate(left):
                self.dropped.add(left[0])
            going_on = [] if left else going_on
        return tuple(reversed((*kept, *going_on)))

    def _keeps(self, left: Row, lines: Sequence[Row]) -> bool:
        if _is_coordinate(left) or _is_component(left):
            return self._needs(left, lines)
        return not self.dropped & find_symbols([left])  # else nobody solves it

    def _needs(self, left: Row, lines: Sequence[Row]) -> bool:
        start, end = find_value(lines[0])
        value = _flatten(lines[0][start:end])
        size = value[1:] if value[:1] == (Sign("-"),) else value
        boxed = any(
            isinstance(node, Accent) and node.name == "boxed" for line in lines for node in line
        )
        told = any(_holds(formula, size) for formula in self.said) and not _is_another(lines[0])
        said = size == (Number("0"),) or told
        return boxed or said or left[0] in self.met


def _flatten(formula: Row) -> Row:
    """The nodes of a formula in the order in which they are written, those of parts among them."""
    return tuple(list_nodes(formula))


def _holds(formula: Row, size: Row) -> bool:
    """Whether a number with its unit stands in a formula."""
    places = range(len(formula) - len(size) + 1)
    return any(formula[place : place + len(size)] == size for place in places)


def _is_another(line: Row) -> bool:
    """Whether an equation says that a coordinate is another one, whose number it repeats."""
    links = line[line.index(Mark()) + 1 :] if Mark() in line else ()
    return links[2:3] == (Sign("="),) and _is_coordinate(links[1:2])


def _is_coordinate(left: Row) -> bool:
    only = left[0]
    return len(left) == 1 and isinstance(only, Scripts) and only.base in _COORDINATES


def _is_component(left: Row) -> bool:
    """Whether a line is about one component of a vector along an axis."""
    only = left[0]
    if len(left) > 1 or not isinstance(only, Scripts) or only.base not in _VECTORS:
        return False
    *_, comma, axis = (None, None, *(only.lower or ()))
    return comma == Sign(",") and axis in _COORDINATES
