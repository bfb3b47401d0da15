"""Digits of a cell that stand raised, as the 4 of 2·10⁴: a spreadsheet keeps them as digits like
any others, and only their look tells that they are a power.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

from kinegrade.files.workbooks.cells import Cell, Line
from kinegrade.files.workbooks.inspection import explain_damaged
from kinegrade.files.workbooks.parts import SHARED, holds, list_sheet_parts
from kinegrade.files.workbooks.sheet_xml import Position, read_position
from kinegrade.language.message import Message

_LOOK = b"superscript"
_POWER = re.compile(r"[+\-\u2212]?[0-9]+")
_SUPERSCRIPTS = str.maketrans("0123456789+-\u2212", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻")


def note_raised(path: Path, sheet: str, lines: list[Line]) -> list[Line]:
    """The lines with each raised number in superscripts, which are read, and a remark for its cell.
    Raises TableError for a damaged workbook.
    """
    raised = _find_raised(path, sheet)
    if not raised:
        return lines
    return [(line, [*_raise_cells(line, cells, raised)]) for line, cells in lines]


def _raise_cells(
    line: int, cells: Sequence[Cell], raised: Mapping[Position, str]
) -> Iterator[Cell]:
    for column, cell in enumerate(cells, 1):
        text = raised.get((line, column))
        yield cell if text is None else Cell(text, Message("files.cell-raised", text=text))


def _find_raised(path: Path, sheet: str) -> Mapping[Position, str]:
    """The texts with raised numbers, by row and column; none in most workbooks."""
    try:
        with ZipFile(path) as archive:
            if not holds(archive, _LOOK):
                return {}
            part = dict(list_sheet_parts(archive))[sheet]
            texts = archive.read(SHARED) if SHARED in archive.namelist() else b""
            cells = archive.read(part)
        shared = [*_read_texts(texts)] if texts else []
        return {at: text for at, text in _read_cells(cells, shared) if text is not None}
    except Exception as fault:  # a damaged part may raise any exception
        raise explain_damaged(path, fault) from fault


def _read_texts(texts: bytes) -> Iterator[str | None]:
    """Each of the texts that cells share, None for one without raised numbers."""
    for _, element in ElementTree.iterparse(io.BytesIO(texts)):
        if _name(element) == "si":
            yield _write_raised(element)
            element.clear()


def _read_cells(
    cells: bytes, shared: Sequence[str | None]
) -> Iterator[tuple[Position, str | None]]:
    for _, element in ElementTree.iterparse(io.BytesIO(cells)):
        if _name(element) == "c":
            at, kind = element.get("r"), element.get("t")
            if at and kind == "s":
                yield read_position(at), shared[int(element.findtext("{*}v", "0"))]
            elif at and kind == "inlineStr":
                yield read_position(at), _write_raised(element)
            element.clear()


def _write_raised(element: ElementTree.Element) -> str | None:
    """The text of runs, raised numbers in superscripts; None where there are none."""
    runs = [(_is_raised(run), run.findtext("{*}t", "")) for run in element.iterfind(".//{*}r")]
    plain = "".join(text for _, text in runs)
    written = "".join(_raise_number(text) if raised else text for raised, text in runs)
    return None if written == plain else written


def _raise_number(text: str) -> str:
    """A number in superscripts; what is none, as the letters of 4th, as it is."""
    return text.translate(_SUPERSCRIPTS) if _POWER.fullmatch(text.strip()) else text


def _is_raised(run: ElementTree.Element) -> bool:
    look = run.find("{*}rPr/{*}vertAlign")
    return look is not None and look.get("val") == _LOOK.decode()


def _name(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]
