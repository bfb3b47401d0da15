"""Workbooks inspected before they are read: what is no workbook, and what would unpack to too much
or be parsed into too much, is refused before it takes memory or time.

`kinegrade.files.workbooks.spreadsheet` reads what has passed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from lzma import LZMAError
from pathlib import Path
from zipfile import BadZipFile, ZipFile
from zlib import error as DeflateError

from kinegrade.errors import TableError
from kinegrade.files.opening.regular import explain_unopened, open_regular
from kinegrade.language.message import Fault, Message

_LARGEST = (
    64_000_000  # bytes of XML, unpacked: a class of 10,000 with 40 answers each has 25 million
)
_MOST_TAGS = 2_000_000  # of sheets and their texts, four for a number: read in some seconds
_MOST_STYLE_TAGS = 100_000  # of all else: a parser makes a large thing of each
_MOST_PARTS = 5_000
_CHUNK = 1 << 20
_OVERLAP = 16
_ZIP = b"PK\x03\x04"
_COMPOUND = b"\xd0\xcf\x11\xe0"
_FORMULA = re.compile(rb"<(?:\w+:)?f[ />]")
_DOCUMENT_TYPE = b"<!DOCTYPE"
_ENCODING = re.compile(rb"""^(?:\xef\xbb\xbf)?\s*<\?xml[^>]*\bencoding\s*=\s*["']([^"']*)""")
_UTF_8 = (b"utf-8", b"utf8", b"us-ascii")
_CELL_PART = re.compile(r"sheet|sharedstrings", re.IGNORECASE)
XLSX = Message("files.xlsx")
SAVE_AS_XLSX = Message("files.save-as-xlsx")
SEND_ALONE = Message("files.send-sheet-alone")


def is_workbook(path: Path) -> bool:
    """Whether a file begins like a workbook, new or old, whatever its name."""
    try:
        with open_regular(path) as stream:
            return stream.read(4) in (_ZIP, _COMPOUND)
    except OSError:
        return False


def inspect_workbook(path: Path) -> bool:
    """Whether the workbook has formulas. Raises TableError if the file is not a workbook, or
    unpacks to too much.
    """
    try:
        with open_regular(path) as stream:
            beginning = stream.read(4)
        if beginning == _COMPOUND:
            raise TableError(Fault(path.name, Message("files.old-workbook"), XLSX, SAVE_AS_XLSX))
        with ZipFile(path) as archive:
            return _inspect_parts(path, archive)
    except OSError as fault:
        raise TableError(explain_unopened(path, fault, Message("files.a-workbook"))) from fault
    except (BadZipFile, DeflateError, LZMAError) as fault:
        raise TableError(
            Fault(path.name, Message("files.no-workbook"), XLSX, SAVE_AS_XLSX)
        ) from fault
    except (EOFError, NotImplementedError, RuntimeError, ValueError, ArithmeticError) as fault:
        raise explain_damaged(path, fault) from fault


def _inspect_parts(path: Path, archive: ZipFile) -> bool:
    parts = archive.infolist()
    if not any(part.filename.endswith("workbook.xml") for part in parts):
        raise TableError(Fault(path.name, Message("files.archive")))
    size = sum(part.file_size for part in parts if _is_parsed(part.filename))
    if size > _LARGEST or len(parts) > _MOST_PARTS:
        what = Message("files.unpacks-to", size=size, parts=len(parts))
        expected = Message("files.less-than", most=_LARGEST)
        raise TableError(Fault(path.name, what, expected, SEND_ALONE))
    return _has_formulas(path, archive, [each.filename for each in parts])


def _is_parsed(part: str) -> bool:
    return part.endswith((".xml", ".rels"))


def _has_formulas(path: Path, archive: ZipFile, parts: Sequence[str]) -> bool:
    """Whether any part has formulas; counts what a parser would have to build before it does."""
    has_formulas = False
    room = {True: _MOST_TAGS, False: _MOST_STYLE_TAGS}
    for part in filter(_is_parsed, parts):
        cells = _CELL_PART.search(part) is not None
        before = b""
        for chunk in _read_chunks(archive, part):
            piece = before + chunk
            _refuse_foreign(path, part, piece, first=not before)
            room[cells] -= chunk.count(b"<")
            if room[cells] < 0:
                raise _explain_too_many_tags(path, cells=cells)
            has_formulas |= "sheet" in part and _FORMULA.search(piece) is not None
            before = piece[-_OVERLAP:]
    return has_formulas


def _read_chunks(archive: ZipFile, part: str) -> Iterator[bytes]:
    with archive.open(part) as stream:
        while chunk := stream.read(_CHUNK):
            yield chunk


def _refuse_foreign(path: Path, part: str, piece: bytes, *, first: bool) -> None:
    """Raises TableError for what no spreadsheet program writes and what could exhaust a parser."""
    if _DOCUMENT_TYPE in piece:
        what, expected = Message("files.document-type", part=part), Message("files.none-as-usual")
        raise TableError(Fault(path.name, what, expected, SAVE_AS_XLSX))
    declared = _ENCODING.match(piece) if first else None
    if b"\0" in piece or (declared and declared[1].lower() not in _UTF_8):
        what = Message("files.part-not-utf-8", part=part)
        raise TableError(Fault(path.name, what, Message("files.utf-8-as-usual"), SAVE_AS_XLSX))


def _explain_too_many_tags(path: Path, *, cells: bool) -> TableError:
    if cells:
        what = Message("files.too-many-tags", most=_MOST_TAGS)
        return TableError(Fault(path.name, what, Message("files.a-class"), SEND_ALONE))
    return TableError(Fault(path.name, Message("files.too-many-styles", most=_MOST_STYLE_TAGS)))


def explain_damaged(path: Path, fault: Exception) -> TableError:
    """The error for a workbook whose parts cannot be read."""
    reason = " ".join(str(fault).split())[:200] or type(fault).__name__
    return TableError(Fault(path.name, Message("files.damaged", reason=reason), XLSX, SAVE_AS_XLSX))
