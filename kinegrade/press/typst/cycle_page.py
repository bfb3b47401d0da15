"""The page of a cycle as Typst source."""

from __future__ import annotations

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.language.prose.typst import write_line
from kinegrade.press.cycle_page import CyclePage
from kinegrade.press.sheet import PaperSize
from kinegrade.press.typst.layout_call import Sheet, write_layout_call

_WHERE = Message("typesetting.place-cycle")


def write_cycle_page_source(page: CyclePage, size: PaperSize = "a4") -> str:
    """Typst source of the page. Raises TypesetError for a symbol that is none."""
    sheet: Sheet = {
        "language": open_catalogue(page.language).raw("language", "page."),
        "size": size,
        "title": page.title,
        "figure": page.figure,
        "facts": [write_line(fact, _WHERE, page.language) for fact in page.facts],
        "graphs": page.graphs,
    }
    return write_layout_call("cycle-page", sheet)
