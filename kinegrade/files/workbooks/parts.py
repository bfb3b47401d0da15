"""The parts of an .xlsx workbook as they stand in its archive, of which one can be replaced while
all others keep their bytes.

`lms.grades.office` fills grades into workbooks that other people made; `spreadsheet` reads answers.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass
from pathlib import Path
from posixpath import join, normpath
from xml.etree import ElementTree
from zipfile import ZipFile

from kinegrade.files.workbooks.inspection import explain_damaged, inspect_workbook
from kinegrade.files.workbooks.sheet_reading import read_sheet_xml
from kinegrade.files.workbooks.sheet_xml import SheetXml

_BOOK, SHARED = "xl/workbook.xml", "xl/sharedStrings.xml"
_SHEETS = "xl/worksheets/"
_LINKS = "xl/_rels/workbook.xml.rels"
_LINK = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"
_STRICT_LINK = "{http://purl.oclc.org/ooxml/officeDocument/relationships}id"


@dataclass(frozen=True)
class WorkbookSheet:
    """A visible sheet: its name, the part of the archive that holds it, and its cells."""

    name: str
    part: str
    xml: SheetXml


@dataclass(frozen=True)
class WorkbookParts:
    """A workbook that was inspected; `has_formulas` is whether any of its cells is computed."""

    file: str
    content: bytes
    sheets: tuple[WorkbookSheet, ...]
    has_formulas: bool

    def with_part(self, part: str, replaced: bytes) -> bytes:
        """The workbook with another content of one part; every other part keeps its bytes, its
        place and its date.
        """
        stream = io.BytesIO()
        with ZipFile(io.BytesIO(self.content)) as old, ZipFile(stream, "w") as new:
            new.comment = old.comment
            for entry in old.infolist():
                content = replaced if entry.filename == part else old.read(entry)
                new.writestr(copy(entry), content)
        return stream.getvalue()


def read_workbook_parts(path: Path) -> WorkbookParts:
    """The workbook there. Raises TableError for one that is missing, damaged, too large or
    hostile.
    """
    has_formulas = inspect_workbook(path)
    content = path.read_bytes()
    try:
        with ZipFile(io.BytesIO(content)) as archive:
            sheets = _read_sheets(archive)
    except Exception as fault:  # a damaged part may raise any exception
        raise explain_damaged(path, fault) from fault
    return WorkbookParts(path.name, content, sheets, has_formulas)


def _read_sheets(archive: ZipFile) -> tuple[WorkbookSheet, ...]:
    shared = _read_shared(archive)
    return tuple(
        WorkbookSheet(name, part, read_sheet_xml(archive.read(part), shared))
        for name, part in list_sheet_parts(archive)
    )


def holds(archive: ZipFile, sign: bytes) -> bool:
    """Whether any sheet, or a text that cells share, has that in its XML; looked for before it is
    parsed, as most workbooks have none of what is rare.
    """
    names = [name for name in archive.namelist() if name == SHARED or name.startswith(_SHEETS)]
    return any(sign in archive.read(name) for name in names)


def list_sheet_parts(archive: ZipFile) -> Iterator[tuple[str, str]]:
    """The names of the visible sheets, each with the part that holds it, but for sheets of charts.
    Raises KeyError and ParseError for a damaged workbook.
    """
    links = {
        each.attrib["Id"]: normpath(join("xl", each.attrib["Target"])).lstrip("/")
        for each in ElementTree.fromstring(archive.read(_LINKS))
    }
    for each in ElementTree.fromstring(archive.read(_BOOK)).iter():
        if each.tag.endswith("}sheet") and each.attrib.get("state", "visible") == "visible":
            part = links[each.attrib.get(_LINK) or each.attrib[_STRICT_LINK]]
            if part.startswith(_SHEETS):
                yield each.attrib["name"], part


def _read_shared(archive: ZipFile) -> list[str]:
    """The texts that cells share, without the readings of Chinese and Japanese letters."""
    if SHARED not in archive.namelist():
        return []
    found = []
    for each in ElementTree.fromstring(archive.read(SHARED)):
        pieces = [child for child in each if not child.tag.endswith("}rPh")]
        texts = (text for piece in pieces for text in piece.iter() if text.tag.endswith("}t"))
        found.append("".join(text.text or "" for text in texts))
    return found
