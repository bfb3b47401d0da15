"""What a PDF breaks of PDF/UA-1, as an independent validator says it."""

from __future__ import annotations

import page

# The validator takes the widths of letters from the first of several dictionaries of a font: in the
# Chinese fonts, which have one for each script, it finds none. fontTools reads 1000 there, as the PDF says.
MISREAD = {"PDFUA1-FONT-GLYPH-WIDTH-001"}


def list_failed_rules(pdf: bytes) -> list[str]:
    """A line for each rule that is broken."""
    report = page.validate_pdf_bytes(pdf, profile="ua1")
    failed = {each.rule_id: each.message for each in report.failures}
    return [f"{rule}: {said}" for rule, said in failed.items() if rule not in MISREAD]
