"""A workbook of half a megabyte that would take gigabytes or minutes is refused at once, in one
line.
"""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from openpyxl import Workbook

from kinegrade.errors import TableError
from kinegrade.files.workbooks.spreadsheet import read_workbook

MEMORY = 1 << 30  # bytes
SECONDS = 10  # the answer takes one; the machine may be busy
SHEET, STYLES = "xl/worksheets/sheet1.xml", "xl/styles.xml"
MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
TYPES = "[Content_Types].xml"
TEXTS_TYPE = (
    b'<Override PartName="/xl/sharedStrings.xml" '
    b'ContentType="application/vnd.openxmlformats-officedocument'
    b'.spreadsheetml.sharedStrings+xml"/>'
)
HEAD = f"<worksheet {MAIN}><sheetData>"
TAIL = "</sheetData></worksheet>"
READ = """
import resource, sys
from pathlib import Path
from kinegrade.errors import TableError
from kinegrade.files.workbooks.spreadsheet import read_workbook
try:
    read_workbook(Path(sys.argv[1]))
except TableError as refusal:
    print(refusal)
status = Path("/proc/self/status")
if status.exists():  # rusage of Linux counts the process that started this one too
    print(status.read_text().partition("VmHWM:")[2].split()[0])
else:
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def book(path: Path, parts: dict[str, bytes], sheets: int = 1) -> Path:
    """A workbook with some parts replaced or added."""
    written = Workbook()
    written.active.append(["student", "q1.v_B"])
    for _ in range(sheets - 1):
        written.create_sheet()
    written.save(path)
    with zipfile.ZipFile(path) as archive:
        kept = {name: archive.read(name) for name in archive.namelist()}
    kept[TYPES] = kept[TYPES].replace(b"</Types>", TEXTS_TYPE + b"</Types>")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in {"xl/sharedStrings.xml": shared(""), **kept, **parts}.items():
            archive.writestr(name, content)
    return path


def shared(text: str) -> bytes:
    return f"<sst {MAIN}><si><t>{text}</t></si></sst>".encode()


MANY_NAMES = '<row><c t="s"><v>0</v></c></row>' * 90_000
HOSTILE = {
    "cells": ({SHEET: f"{HEAD}<row>{'<c/>' * 3_000_000}</row>{TAIL}".encode()}, 1, "tags in its"),
    "formats": (
        {
            STYLES: "<styleSheet "
            f"{MAIN}><cellXfs>{'<xf/>' * 400_000}</cellXfs></styleSheet>".encode()
        },
        1,
        "tags in its styles",
    ),
    "bytes": ({SHEET: (HEAD + " " * 70_000_000 + TAIL).encode()}, 1, "unpacks to"),
    "one text named by many": (
        {SHEET: f"{HEAD}{MANY_NAMES}{TAIL}".encode(), "xl/sharedStrings.xml": shared("x" * 32_000)},
        1,
        "holds more text than",
    ),
    "a long text": (
        {
            SHEET: f"{HEAD}<row><c "
            f't="inlineStr"><is><t>{"x" * 40_000}</t></is></c></row>{TAIL}'.encode()
        },
        1,
        "(40000 characters in a cell)",
    ),
    "entities in UTF-16": (
        {
            SHEET: (
                '<?xml version="1.0" encoding="utf-16"?><!DOCTYPE a [<!ENTITY b "bbbbbbbb">]>'
                f"{HEAD}{TAIL}"
            ).encode("utf-16")
        },
        1,
        "is not in UTF-8",
    ),
    "entities in EBCDIC": (
        {SHEET: b'<?xml version="1.0" encoding="cp037"?>' + f"{HEAD}{TAIL}".encode("cp037")},
        1,
        "is not in UTF-8",
    ),
    "far rows of many sheets": (
        {
            f"xl/worksheets/sheet{number}.xml": f'{HEAD}<row r="90000"><c/></row>{TAIL}'.encode()
            for number in range(1, 41)
        },
        40,
        "reaches beyond",
    ),
    "nested deeply": (
        {SHEET: f"{HEAD}<row>{'<a>' * 500_000}{'</a>' * 500_000}</row>{TAIL}".encode()},
        1,
        "has no filled sheet",
    ),
    "nested deeply in styles": (
        {STYLES: f"<styleSheet {MAIN}>{'<a>' * 40_000}{'</a>' * 40_000}</styleSheet>".encode()},
        1,
        "",
    ),
}


@pytest.mark.skipif(os.name != "posix", reason="limits of memory are those of POSIX")
@pytest.mark.parametrize("kind", HOSTILE)
def test_a_hostile_workbook_is_refused_at_once_and_in_little_memory(
    tmp_path: Path, kind: str
) -> None:
    parts, sheets, message = HOSTILE[kind]
    path = book(tmp_path / "answers.xlsx", parts, sheets)
    assert path.stat().st_size < 600_000
    done = subprocess.run(
        [sys.executable, "-c", READ, str(path)],
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    *said, memory = done.stdout.splitlines()
    assert message in "".join(said)
    assert len(said) <= 1
    assert int(memory) * (1 if sys.platform == "darwin" else 1024) < MEMORY


def test_a_workbook_whose_packed_bytes_are_damaged_is_one_line(tmp_path: Path) -> None:
    path = book(tmp_path / "answers.xlsx", {})
    with zipfile.ZipFile(path) as archive:
        part = archive.getinfo(SHEET)
    content = bytearray(path.read_bytes())
    packed = part.header_offset + 30 + len(part.filename)
    content[packed : packed + part.compress_size] = b"\xff" * part.compress_size
    path.write_bytes(content)
    with pytest.raises(TableError, match="is not a workbook, or a damaged one - expected .xlsx"):
        read_workbook(path)
