"""The blank answer sheet as a workbook, in which spreadsheets keep the leading zeros of ids and do
not read answers as dates.

`generate` writes answers.xlsx beside answers.csv. Every cell is text, including the empty ones of
the answer columns. Above the header stands a cell that finds a row. The parts of the archive are
written here directly, because a few plain tags are enough for a class of any size.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import escape
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.contents import FINDER
from kinegrade.exam.generating.answer_sheets.typing_aids import (
    HEADER_ROW,
    find_row_formula,
    name_column,
    write_highlight,
    write_validations,
)
from kinegrade.language.catalogue import Catalogue

Cells = Sequence[str] | Sequence[str | None]
_SPACE = "http://schemas.openxmlformats.org"
_HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_TYPE = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_TEXT, _GREY, _BOLD, _TYPED, _LINK = range(1, 6)  # the styles
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
        '<sheet name="answers" sheetId="1" r:id="rId1"/></sheets><calcPr fullCalcOnLoad="1"/>'
        "</workbook>"
    ),
    "xl/_rels/workbook.xml.rels": (
        f'<Relationships xmlns="{_SPACE}/package/2006/relationships"><Relationship Id="rId1" '
        f'Type="{_SPACE}/officeDocument/2006/relationships/worksheet" '
        'Target="worksheets/sheet1.xml"/>'
        f'<Relationship Id="rId2" Type="{_SPACE}/officeDocument/2006/relationships/styles" '
        'Target="styles.xml"/></Relationships>'
    ),
    "xl/styles.xml": (
        # Styles 1 to 4 are of number format 49, text: 2 grey, 3 bold, 4 to be typed into; 5 a link
        f'<styleSheet xmlns="{_SPACE}/spreadsheetml/2006/main">'
        '<fonts count="3"><font><sz val="11"/><name val="Calibri"/></font>'
        '<font><b/><sz val="11"/><name val="Calibri"/></font>'
        '<font><u/><sz val="11"/><color rgb="FF0563C1"/><name val="Calibri"/></font></fonts>'
        '<fills count="4"><fill><patternFill patternType="none"/></fill>'
        '<fill><patternFill patternType="gray125"/></fill><fill><patternFill patternType="solid">'
        '<fgColor rgb="FFBFBFBF"/></patternFill></fill><fill><patternFill patternType="solid">'
        '<fgColor rgb="FFFFF2CC"/></patternFill></fill></fills><borders '
        'count="1"><border/></borders>'
        '<cellStyleXfs count="1"><xf numFmtId="0"/></cellStyleXfs><cellXfs count="6">'
        '<xf numFmtId="0" xfId="0"/><xf numFmtId="49" xfId="0" applyNumberFormat="1"/>'
        '<xf numFmtId="49" fillId="2" xfId="0" applyNumberFormat="1" applyFill="1"/>'
        '<xf numFmtId="49" fontId="1" xfId="0" applyNumberFormat="1" applyFont="1"/>'
        '<xf numFmtId="49" fillId="3" xfId="0" applyNumberFormat="1" applyFill="1"/>'
        '<xf numFmtId="0" fontId="2" xfId="0" applyFont="1"/></cellXfs>'
        '<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles>'
        '<dxfs count="1"><dxf><fill><patternFill patternType="solid"><bgColor rgb="FFFFF2CC"/>'
        "</patternFill></fill></dxf></dxfs>"
        "</styleSheet>"
    ),
}


class Rows(NamedTuple):
    """The columns that say whose a row is, the asks, and the rows: None is a cell into which
    nothing is to be typed, which becomes grey.
    """

    own: Sequence[str]
    asks: Sequence[Ask]
    cells: Sequence[Cells]


def write_answer_workbook(path: Path, rows: Rows, words: Catalogue) -> None:
    """Write the workbook, with words of a language; the same rows give the same bytes. Cells that
    are not written are formatted as text too.
    """
    with ZipFile(path, "w") as archive:
        for name, content in _PARTS.items():
            archive.writestr(_make_entry(name), f"{_HEAD}{content}")
        with archive.open(_make_entry(_SHEET), "w", force_zip64=True) as sheet:
            for piece in _write_sheet(rows, words):
                sheet.write(piece.encode())


def _make_entry(name: str) -> ZipInfo:
    entry = ZipInfo(name)  # dated 1980, so that nothing depends on the time
    entry.compress_type = ZIP_DEFLATED
    return entry


def _write_sheet(rows: Rows, words: Catalogue) -> Iterator[str]:
    own, width = len(rows.own), len(rows.own) + len(rows.asks)
    first_answer = name_column(own + 1)
    yield (
        f'{_HEAD}<worksheet xmlns="{_SPACE}/spreadsheetml/2006/main"><sheetViews><sheetView '
        f'workbookViewId="0"><pane xSplit="{own}" ySplit="{HEADER_ROW}" '
        f'topLeftCell="{first_answer}{HEADER_ROW + 1}" state="frozen"/></sheetView>'
        f'</sheetViews><cols><col min="1" max="{width}" width="16" style="1" '
        'customWidth="1"/></cols>'
        "<sheetData>"
    )
    label = _write_text(words.write(FINDER), _BOLD)
    link = f'<c s="{_LINK}" t="str"><f>{escape(find_row_formula(first_answer))}</f><v/></c>'
    yield f'<row>{label}<c s="{_TYPED}"/>{link}</row>'
    header = (*rows.own, *map(_head_ask, rows.asks))
    yield f"<row>{''.join(_write_text(name, _BOLD) for name in header)}</row>"
    for cells in rows.cells:
        yield f"<row>{''.join(map(_write_cell, cells))}</row>"
    count = len(rows.cells)
    yield "</sheetData>" + write_highlight(count, width)
    yield write_validations(rows.asks, own + 1, count, words)
    area = f"A1:{name_column(width)}{HEADER_ROW + count}"
    yield (
        f'<ignoredErrors><ignoredError sqref="{area}" numberStoredAsText="1"/></ignoredErrors>'
        "</worksheet>"
    )


def _head_ask(ask: Ask) -> str:
    """The column of an ask, with its unit."""
    return ask.column if ask.unit == "1" else f"{ask.column} ({ask.unit})"


def _write_cell(text: str | None) -> str:
    if text is None:
        return f'<c s="{_GREY}"/>'
    if not text:
        return f'<c s="{_TEXT}"/>'
    return _write_text(text, _TEXT)


def _write_text(text: str, style: int) -> str:
    shown = escape(_UNPRINTABLE.sub("·", text))
    return f'<c s="{style}" t="inlineStr"><is><t xml:space="preserve">{shown}</t></is></c>'
