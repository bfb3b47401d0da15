"""The page that is kept with an archive as Typst source."""

from __future__ import annotations

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.archive_page import ArchivePage
from kinegrade.press.sheet import PaperSize
from kinegrade.press.typst.layout_call import Sheet, write_layout_call


def write_archive_page_source(page: ArchivePage, size: PaperSize = "a4") -> str:
    """Typst source of the page."""
    words = open_catalogue(page.language)
    sheet: Sheet = {
        "words": words.raw("archive", "layout."),
        "language": words.raw("language", "page."),
        "size": size,
        "title": page.title,
        "warning": page.warning,
        "facts": page.facts,
        "secret": page.secret,
        "steps": page.steps,
        "codes": page.codes,
    }
    return write_layout_call("archive-page", sheet)
