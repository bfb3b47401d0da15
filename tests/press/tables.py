"""Tables as those have them who cannot see them: each cell with the header cells that are said with
it. A file is read by its own rules alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html.parser import HTMLParser
from io import BytesIO
from xml.etree import ElementTree
from zipfile import ZipFile

import pikepdf

from tests.press.heard import Texts, list_kids, read_texts, say_element

_W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"


@dataclass(frozen=True)
class Cell:
    """A cell, whether it is a header, and how many columns it takes; `named` says whether the file
    names its headers.
    """

    text: str
    is_header: bool
    columns: int = 1
    named: bool = False


Table = Sequence[Sequence[Cell]]


def find_table_faults(tables: Sequence[Table]) -> Iterator[str]:
    """A line for each header cell without words, and each cell without a header."""
    for number, table in enumerate(tables, start=1):
        above: set[int] = set()
        for row in table:
            beside = any(cell.is_header for cell in row)
            place = 0
            for cell in row:
                taken = set(range(place, place + cell.columns))
                place += cell.columns
                if cell.is_header:
                    above |= taken
                    if not cell.text.strip():
                        yield f"table {number}: a header cell without words"
                elif cell.text.strip() and not (cell.named or beside or taken & above):
                    yield f"table {number}: no header of {cell.text!r}"


def read_pdf_tables(pdf: bytes) -> list[Table]:
    """The tables of a tagged PDF; its cells name their headers."""
    with pikepdf.open(BytesIO(pdf)) as document:
        texts = read_texts(document)
        return [
            [[_read_cell(cell, texts) for cell in _find(row, "TH", "TD")] for row in rows]
            for table in _find(document.Root.StructTreeRoot, "Table")
            for rows in [list(_find(table, "TR"))]
        ]


def _find(element: pikepdf.Object, *kinds: str) -> Iterator[pikepdf.Object]:
    for kid in list_kids(element):
        if not isinstance(kid, pikepdf.Dictionary) or "/S" not in kid:
            continue
        if str(kid.S)[1:] in kinds:
            yield kid
        else:
            yield from _find(kid, *kinds)


def _read_cell(cell: pikepdf.Object, texts: Texts) -> Cell:
    attributes = cell.get("/A", ())
    listed = list(attributes) if isinstance(attributes, pikepdf.Array) else [attributes]
    columns = sum(int(each.get("/ColSpan", 0)) for each in listed) or 1
    named = any(len(each.get("/Headers", ())) > 0 for each in listed)
    said = say_element(cell, texts).removeprefix("|").strip()
    return Cell(said, cell.S == "/TH", columns, named)


def read_html_tables(html: str) -> list[Table]:
    """The tables of a page."""
    return _TableReader(html).tables


class _TableReader(HTMLParser):
    def __init__(self, html: str) -> None:
        super().__init__()
        self.tables: list[list[list[Cell]]] = []
        self._is_open = False
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        match tag:
            case "table":
                self.tables.append([])
            case "tr":
                self.tables[-1].append([])
            case "th" | "td":
                columns = int(dict(attrs).get("colspan") or 1)
                self.tables[-1][-1].append(Cell("", tag == "th", columns))
                self._is_open = True
            case "img" | "svg" if self._is_open:
                self.handle_data(dict(attrs).get("alt") or dict(attrs).get("aria-label") or "")
            case _:
                pass

    def handle_endtag(self, tag: str) -> None:
        if tag in ("th", "td"):
            self._is_open = False

    def handle_data(self, data: str) -> None:
        if self._is_open:
            row = self.tables[-1][-1]
            row[-1] = Cell(row[-1].text + data, row[-1].is_header, row[-1].columns)


def read_word_tables(docx: bytes) -> list[Table]:
    """The tables of a document for Word, where a row may be one of headers."""
    with ZipFile(BytesIO(docx)) as package:
        document = ElementTree.fromstring(package.read("word/document.xml"))
    return [
        [
            [
                Cell("".join(cell.itertext()), row.find(f".//{_W}tblHeader") is not None)
                for cell in row.iter(f"{_W}tc")
            ]
            for row in table.iter(f"{_W}tr")
        ]
        for table in document.iter(f"{_W}tbl")
    ]
