"""The XML of a worksheet, with the place of every cell in it, so that numbers can be written into
some cells while every other byte stays.

`workbook_parts` gives the XML, which it has inspected: it is UTF-8 and has no document type. A
spreadsheet library would write the whole sheet anew, and lose what it does not know.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape

TAG = re.compile(rb"<[^<>\"']*(?:(?:\"[^\"]*\"|'[^']*')[^<>\"']*)*>")
_NAME = re.compile(rb"<[^\s/>]+")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_TYPE = re.compile(rb"\st\s*=\s*(?:\"[^\"]*\"|'[^']*')")
_REFERENCE = re.compile(r"\$?([A-Z]{1,3})\$?([0-9]{1,7})")
_FIRST_LETTER = ord("A") - 1

Position = tuple[int, int]  # row and column, counted from 1


def read_position(reference: str) -> Position:
    """The row and the column of a cell. Raises ValueError.

    >>> read_position("AB12")
    (12, 28)
    """
    found = _REFERENCE.fullmatch(reference)
    if found is None:
        raise ValueError(reference)
    column = 0
    for letter in found[1]:
        column = 26 * column + ord(letter) - _FIRST_LETTER
    return int(found[2]), column


def write_position(position: Position) -> str:
    """The name of a cell.

    >>> write_position((12, 28))
    'AB12'
    """
    row, column = position
    letters = ""
    while column:
        column, letter = divmod(column - 1, 26)
        letters = chr(letter + 1 + _FIRST_LETTER) + letters
    return f"{letters}{row}"


@dataclass(frozen=True, slots=True)
class SheetCell:
    """What a cell holds, a number in its shortest digits, and the bytes from `start` to `end` that
    it takes; `is_computed` is whether a formula gives it.
    """

    text: str
    is_computed: bool
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Merged:
    """Cells that are shown as one: from the first to the last, both included."""

    first: Position
    last: Position

    def holds(self, position: Position) -> bool:
        """Whether a cell is one of them."""
        (top, left), (bottom, right) = self.first, self.last
        return top <= position[0] <= bottom and left <= position[1] <= right


@dataclass(frozen=True)
class SheetXml:
    """A worksheet: its cells, the bytes at which its rows end, the styles of new cells by row and
    by column, and which cells are merged.
    """

    content: bytes
    cells: Mapping[Position, SheetCell]
    row_ends: Mapping[int, int]
    row_styles: Mapping[int, str]
    column_styles: Mapping[int, str]
    merged: Sequence[Merged]

    def with_values(self, values: Mapping[Position, str]) -> bytes:
        """The XML with these numbers and texts in place of what the cells hold; every other byte
        stays.

        The rows have to be there.
        """
        pieces, done = [], 0
        for start, end, cell in sorted(self._list_changes(values)):
            pieces += [self.content[done:start], cell]
            done = end
        return b"".join([*pieces, self.content[done:]])

    def _list_changes(self, values: Mapping[Position, str]) -> Iterator[tuple[int, int, bytes]]:
        """From where to where there is something else; new cells of one place by their columns."""
        new: dict[int, list[bytes]] = {}
        for position, value in sorted(values.items()):
            old = self.cells.get(position)
            if old is None:
                new.setdefault(self._find_place(position), []).append(self._make(position, value))
            else:
                yield old.start, old.end, self._change(old, value)
        for place, cells in new.items():
            yield place, place, b"".join(cells)

    def _find_place(self, position: Position) -> int:
        """Where a new cell begins: before the next one of its row."""
        row, column = position
        later = [each for each in self.cells if each[0] == row and each[1] > column]
        return self.cells[min(later)].start if later else self.row_ends[row]

    def _change(self, old: SheetCell, value: str) -> bytes:
        """A cell with another content, and its attributes but for the type."""
        found = TAG.match(self.content, old.start)
        tag = found[0] if found else b"<c>"
        opening = _TYPE.sub(b"", tag).removesuffix(b">").removesuffix(b"/").rstrip()
        return _write_cell(opening, value)

    def _make(self, position: Position, value: str) -> bytes:
        """A new cell, in the style that its row or column gives to new cells."""
        row, column = position
        style = self.row_styles.get(row) or self.column_styles.get(column, "")
        neighbour = next(cell for each, cell in self.cells.items() if each[0] == row)
        name = _NAME.match(self.content, neighbour.start)
        styled = f' s="{style}"' if style else ""
        attributes = f' r="{write_position(position)}"{styled}'.encode()
        return _write_cell((name[0] if name else b"<c") + attributes, value)


def _write_cell(opening: bytes, value: str) -> bytes:
    """A cell from the beginning of its tag, with a number, or else a text of its own; its elements
    have the prefix of its own name.
    """
    name = opening[1:].split(maxsplit=1)[0]
    prefix = name[: name.rfind(b":") + 1]
    if _NUMBER.fullmatch(value):
        return b"%b><%bv>%b</%bv></%b>" % (opening, prefix, value.encode(), prefix, name)
    text = b"<%bt>%b</%bt>" % (prefix, escape(value).encode(), prefix)
    return b'%b t="inlineStr"><%bis>%b</%bis></%b>' % (opening, prefix, text, prefix, name)
