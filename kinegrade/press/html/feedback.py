"""A feedback sheet as one self-contained HTML page."""

from __future__ import annotations

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout
from kinegrade.press.sheet import FeedbackSheet


def write_feedback_html(sheet: FeedbackSheet) -> str:
    """The page; all text in it is escaped, so that nothing a student typed becomes a tag."""
    catalogue = open_catalogue(sheet.language)
    words = catalogue.raw("feedback", "sheet.")
    tag = catalogue.text("language.tag")
    return str(load_layout("feedback.html").render(sheet=sheet, words=words, tag=tag))
