"""A feedback sheet as one self-contained HTML page."""

from __future__ import annotations

from kinegrade.grading.feedback import FeedbackSheet
from kinegrade.grading.html_layout import load_layout


def write_feedback_html(sheet: FeedbackSheet) -> str:
    """The page; all text in it is escaped, so that nothing a student typed becomes a tag."""
    return str(load_layout("feedback.html").render(sheet=sheet, words=sheet.words))
