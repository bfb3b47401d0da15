"""A worksheet read from its XML, cell by cell, with the bytes at which each stands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.parsers.expat import ParserCreate

from kinegrade.files.workbooks.sheet_xml import (
    TAG,
    Merged,
    Position,
    SheetCell,
    SheetXml,
    read_position,
)

_TEXTS = ("v", "t")  # elements whose text is what a cell holds
_LONGEST_NUMBER = 1e15  # spreadsheets keep fifteen digits


def read_sheet_xml(content: bytes, shared: Sequence[str]) -> SheetXml:
    """The worksheet; `shared` are the texts that its cells share with other sheets. Raises
    ExpatError, ValueError, IndexError, KeyError for a damaged one.
    """
    reader = _Reader(content, shared)
    reader.read()
    return SheetXml(
        content,
        reader.cells,
        reader.row_ends,
        reader.row_styles,
        reader.column_styles,
        reader.merged,
    )


@dataclass
class _Reader:
    """What has been read so far, and where."""

    content: bytes
    shared: Sequence[str]
    cells: dict[Position, SheetCell] = field(default_factory=dict)
    row_ends: dict[int, int] = field(default_factory=dict)
    row_styles: dict[int, str] = field(default_factory=dict)
    column_styles: dict[int, str] = field(default_factory=dict)
    merged: list[Merged] = field(default_factory=list)
    position: Position = (0, 0)
    kind: str = ""
    texts: list[str] = field(default_factory=list)
    open: list[str] = field(default_factory=list)
    begun: int = 0
    is_computed: bool = False

    def read(self) -> None:
        """Read the whole."""
        self.parser = ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._add_text
        self.parser.Parse(self.content, True)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        local = name.rpartition(":")[2]
        self.open.append(local)
        match local:
            case "row":
                self._begin_row(attributes)
            case "c":
                self._begin_cell(attributes)
            case "f":
                self.is_computed = True
            case "mergeCell":
                first, _, last = attributes["ref"].partition(":")
                self.merged.append(Merged(read_position(first), read_position(last or first)))
            case "col" if "style" in attributes:
                for column in range(int(attributes["min"]), int(attributes["max"]) + 1):
                    self.column_styles[column] = attributes["style"]

    def _begin_row(self, attributes: dict[str, str]) -> None:
        row = int(attributes.get("r", self.position[0] + 1))
        self.position = row, 0
        if attributes.get("customFormat") == "1":
            self.row_styles[row] = attributes.get("s", "")

    def _begin_cell(self, attributes: dict[str, str]) -> None:
        row, column = self.position
        stated = attributes.get("r")
        self.position = read_position(stated) if stated else (row, column + 1)
        self.kind, self.texts = attributes.get("t", "n"), []
        self.begun, self.is_computed = self.parser.CurrentByteIndex, False

    def _add_text(self, text: str) -> None:
        if self.open[-1] in _TEXTS and "c" in self.open and "rPh" not in self.open:
            self.texts.append(text)

    def _end(self, name: str) -> None:
        local = self.open.pop()
        if local == "row":
            self.row_ends[self.position[0]] = self.parser.CurrentByteIndex
        elif local == "c":
            end = self._find_end()
            self.cells[self.position] = SheetCell(
                self._read_text(), self.is_computed, self.begun, end
            )

    def _find_end(self) -> int:
        """Behind the end of the cell that ends here."""
        found = TAG.match(self.content, self.begun)
        if found and found[0].endswith(b"/>"):
            return found.end()
        return self.content.index(b">", self.parser.CurrentByteIndex) + 1

    def _read_text(self) -> str:
        text = "".join(self.texts)
        if self.kind == "s":
            return self.shared[int(text)] if text else ""
        if self.kind != "n" or not text:
            return text
        number = float(text)
        return str(int(number)) if number.is_integer() and abs(number) < _LONGEST_NUMBER else text
