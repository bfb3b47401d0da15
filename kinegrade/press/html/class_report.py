"""The report on a class as one self-contained HTML page, without scripts and links."""

from __future__ import annotations

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.class_sheet import ClassSheet
from kinegrade.press.html.filled_page import load_layout


def write_class_report(sheet: ClassSheet) -> str:
    """The page; the layout engine escapes every text in it."""
    catalogue = open_catalogue(sheet.language)
    words, tag = catalogue.raw("report", "page."), catalogue.text("language.tag")
    layout = load_layout("class_report.html")
    return layout.render(sheet=sheet, figures=sheet.figures, words=words, tag=tag)
