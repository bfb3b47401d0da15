"""The blank answer sheet as a workbook, in which spreadsheets keep the leading zeros of ids and do
not read answers as dates.

`generate` writes answers.xlsx beside answers.csv. Every cell is text, including the empty ones of
the answer columns. The parts of the archive are written here directly, because a few plain tags are
enough for a class of any size.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from xml.sax.saxutils import escape
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

Cells = Sequence[str] | Sequence[str | None]
_SPACE = "http://schemas.openxmlformats.org"
_HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_TYPE = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_SHEET = "xl/worksheets/sheet1.xml"
_UNPRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
_PARTS = {
    "[Content_Types].xml": (
        f'<Types xmlns="{_SPACE}/package/2006/content-types"><Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default '
        'Extension="xml" ContentType="application/xml"/><Override PartName="/xl/workbook.xml" '
        f'ContentType="{_TYPE}.sheet.main+xml"/><Override PartName="/{_SHEET}" '
        f'ContentType="{_TYPE}.worksheet+xml"/><Override PartName="/xl/styles.xml" '
        f'ContentType="{_TYPE}.styles+xml"/></Types>'
    ),
    "_rels/.rels": (
        f'<Relationships xmlns="{_SPACE}/package/2006/relationships"><Relationship Id="rId1" '
        f'Type="{_SPACE}/officeDocument/2006/relationships/officeDocument" '
        'Target="xl/workbook.xml"/>'
        "</Relationships>"
    ),
    "xl/workbook.xml": (
        f'<workbook xmlns="{_SPACE}/spreadsheetml/2006/main" '
        f'xmlns:r="{_SPACE}/officeDocument/2006/relationships"><sheets>'
        '<sheet name="answers" sheetId="1" r:id="rId1"/></sheets></workbook>'
    ),
    "xl/_rels/workbook.xml.rels": (
        f'<Relationships xmlns="{_SPACE}/package/2006/relationships"><Relationship Id="rId1" '
        f'Type="{_SPACE}/officeDocument/2006/relationships/worksheet" '
        'Target="worksheets/sheet1.xml"/>'
        f'<Relationship Id="rId2" Type="{_SPACE}/officeDocument/2006/relationships/styles" '
        'Target="styles.xml"/></Relationships>'
    ),
    "xl/styles.xml": (  # styles 1 and 2 are of number format 49, text; 2 is grey
        f'<styleSheet xmlns="{_SPACE}/spreadsheetml/2006/main">'
        '<fonts count="1"><font><sz val="11"/><name val="Calibri"/></font></fonts>'
        '<fills count="3"><fill><patternFill patternType="none"/></fill>'
        '<fill><patternFill patternType="gray125"/></fill><fill><patternFill patternType="solid">'
        '<fgColor rgb="FFBFBFBF"/></patternFill></fill></fills><borders '
        'count="1"><border/></borders>'
        '<cellStyleXfs count="1"><xf numFmtId="0"/></cellStyleXfs><cellXfs count="3">'
        '<xf numFmtId="0" xfId="0"/><xf numFmtId="49" xfId="0" applyNumberFormat="1"/>'
        '<xf numFmtId="49" fillId="2" xfId="0" applyNumberFormat="1" applyFill="1"/></cellXfs>'
        '<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles>'
        "</styleSheet>"
    ),
}


def write_answer_workbook(path: Path, header: Sequence[str], rows: Iterable[Cells]) -> None:
    """Write the workbook; the same rows give the same bytes. Cells that are not written are
    formatted as text too; None makes one grey, into which nothing is to be typed.
    """
    with ZipFile(path, "w") as archive:
        for name, content in _PARTS.items():
            archive.writestr(_make_entry(name), f"{_HEAD}{content}")
        with archive.open(_make_entry(_SHEET), "w", force_zip64=True) as sheet:
            for piece in _write_sheet(header, rows):
                sheet.write(piece.encode())


def _make_entry(name: str) -> ZipInfo:
    entry = ZipInfo(name)  # dated 1980, so that nothing depends on the time
    entry.compress_type = ZIP_DEFLATED
    return entry


def _write_sheet(header: Sequence[str], rows: Iterable[Cells]) -> Iterator[str]:
    yield (
        f'{_HEAD}<worksheet xmlns="{_SPACE}/spreadsheetml/2006/main"><sheetViews><sheetView '
        'workbookViewId="0"><pane xSplit="2" ySplit="1" topLeftCell="C2" '
        'state="frozen"/></sheetView>'
        f'</sheetViews><cols><col min="1" max="{len(header)}" width="16" style="1" '
        'customWidth="1"/></cols>'
        "<sheetData>"
    )
    yield _write_row(header)
    for row in rows:
        yield _write_row(row)
    yield "</sheetData></worksheet>"


def _write_row(cells: Cells) -> str:
    return f"<row>{''.join(map(_write_cell, cells))}</row>"


def _write_cell(text: str | None) -> str:
    if text is None:
        return '<c s="2"/>'
    if not text:
        return '<c s="1"/>'
    shown = escape(_UNPRINTABLE.sub("·", text))
    return f'<c s="1" t="inlineStr"><is><t xml:space="preserve">{shown}</t></is></c>'
