"""Digits that stand raised in a cell are a power, and told; whatever else is raised is not."""

from __future__ import annotations

import zipfile
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.files.workbooks.spreadsheet import read_workbook
from kinegrade.grading.typed.answers import read
from tests.files.written_workbooks import told, with_cells, with_part

RICH = """<row r="2"><c r="A2" t="inlineStr"><is><r><t>2×10</t></r><r><rPr><vertAlign \
val="superscript"/></rPr><t>%s</t></r><r><t xml:space="preserve">%s</t></r></is></c></row>"""


@pytest.mark.parametrize(
    ("raised", "behind", "text", "value"),
    [
        ("4", "", "2×10⁴", 20000),
        ("-3", " m/s", "2×10⁻³ m/s", Fraction(1, 500)),
        ("4", "5", "2×10⁴5", None),
    ],
)
def test_raised_digits_are_a_power_and_told(
    tmp_path: Path, raised: str, behind: str, text: str, value: Fraction | None
) -> None:
    table = read_workbook(with_cells(tmp_path / "a.xlsx", RICH % (raised, behind)))
    assert [row.cells for row in table.rows] == [(text,)]
    assert told(table) == [(2, "student", text, f"raised digits: read as a power, {text}")]
    assert read(text, "m/s").value == value


@pytest.mark.parametrize(
    ("text", "look", "read"),
    [("th", "superscript", "2×10th"), ("4", "subscript", "2×104")],
)
def test_raised_letters_and_lowered_digits_stay_as_they_are(
    tmp_path: Path, text: str, look: str, read: str
) -> None:
    rich = (RICH % (text, "")).replace("superscript", look)
    table = read_workbook(with_cells(tmp_path / "a.xlsx", rich))
    assert [row.cells for row in table.rows] == [(read,)]
    assert table.complaints == ()


SHARED = "xl/sharedStrings.xml"
SHARED_TEXTS = """<sst xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><si><r>\
<t>5</t></r><r><rPr><vertAlign val="superscript"/></rPr><t>2</t></r></si></sst>"""
SHARED_TYPE = """<Override PartName="/xl/sharedStrings.xml" ContentType="application/vnd.openxml\
formats-officedocument.spreadsheetml.sharedStrings+xml"/></Types>"""


def test_raised_digits_of_shared_texts_are_a_power(tmp_path: Path) -> None:
    """As spreadsheet programs keep them."""
    path = with_cells(tmp_path / "a.xlsx", '<row r="2"><c r="A2" t="s"><v>0</v></c></row>')
    with_part(path, "[Content_Types].xml", lambda xml: xml.replace("</Types>", SHARED_TYPE))
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(SHARED, SHARED_TEXTS)
    assert [row.cells for row in read_workbook(path).rows] == [("5²",)]
