"""What a PDF breaks of PDF/UA-1, as an independent validator says it."""

from __future__ import annotations

import re
from io import BytesIO

import page
from pypdf import PdfReader
from pypdf.generic import IndirectObject

# The validator takes the widths of letters from the first of several dictionaries of a font: in the
# Chinese fonts, which have one for each script, it finds none. fontTools reads 1000 there, as the PDF says.
MISREAD = "PDFUA1-FONT-GLYPH-WIDTH-001"
CHINESE = "Noto"
FONT = re.compile(r"font object (\d+) (\d+)")


def list_failed_rules(pdf: bytes) -> list[str]:
    """A line for each rule that is broken."""
    report = page.validate_pdf_bytes(pdf, profile="ua1")
    return [
        f"{each.rule_id}: {each.message}"
        for each in report.failures
        if each.rule_id != MISREAD or CHINESE not in name_font(pdf, each.message)
    ]


def name_font(pdf: bytes, message: str) -> str:
    """The name of the font that a message is about."""
    found = FONT.search(message)
    assert found is not None, message
    number, generation = map(int, found.groups())
    font = IndirectObject(number, generation, PdfReader(BytesIO(pdf))).get_object()
    return str(font["/BaseFont"])
