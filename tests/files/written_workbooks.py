"""Workbooks written for tests, with parts and cells as raw XML, and what is told of them."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from pathlib import Path

from openpyxl import Workbook

from kinegrade.files.tables import Table
from tests.said import said


def book(path: Path, *rows: list[object]) -> Path:
    written = Workbook()
    for row in rows:
        written.active.append(row)
    written.save(path)
    return path


def told(table: Table) -> list[tuple[int | None, str, str, str]]:
    return [(each.line, each.column, each.content, said(each.problem)) for each in table.complaints]


def with_part(path: Path, part: str, change: Callable[[str], str]) -> Path:
    """The workbook with one of its parts changed."""
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    parts[part] = change(parts[part].decode()).encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return path


SHEET = "xl/worksheets/sheet1.xml"


def with_cells(path: Path, cells: str) -> Path:
    """A workbook whose header is "student", with more rows as raw XML."""
    return with_part(
        book(path, ["student"]),
        SHEET,
        lambda xml: xml.replace("</sheetData>", f"{cells}</sheetData>"),
    )
