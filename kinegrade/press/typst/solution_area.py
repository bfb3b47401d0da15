"""The printed area of the pages of worked solutions, as in the layouts."""

from __future__ import annotations

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.sheet import PaperSize, SolutionSheet
from kinegrade.press.solutions.course import TextArea
from kinegrade.press.solutions.settings import Column, Spread

# Millimetres: left and right, above and below
_MARGINS, _LARGE_MARGINS = (34.0, 33.5), (40.0, 66.0)
_LARGER = 2.0  # letters of 18 points, where tables of terms have nine
_PAPER: dict[PaperSize, tuple[float, float]] = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}


def find_area(sheet: SolutionSheet, size: PaperSize, spread: Spread) -> TextArea:
    """The area of a page of a sheet, in the size of its letters."""
    script = open_catalogue(sheet.language).raw("language", "page.")["script"]
    (width, height), scale = _PAPER[size], _LARGER if sheet.large else 1.0
    across, along = _LARGE_MARGINS if sheet.large else _MARGINS
    return TextArea(Column((width - across) / scale, script, spread), (height - along) / scale)
