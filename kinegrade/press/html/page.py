"""A paper as one HTML file that stands alone, around the body that pandoc makes of its tree."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from importlib.resources import files
from string import Template

from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.filled_layout import fill_layout
from kinegrade.press.sheet import Paper, PaperSize

_CSS_SIZES: Mapping[PaperSize, str] = {"a4": "A4", "letter": "letter"}


def write_page(paper: Paper, body: str, size: PaperSize) -> bytes:
    """The page in UTF-8; `body` is HTML already."""
    layout = files("kinegrade.press.html") / "layouts" / "paper.html"
    page = Template(layout.read_text(encoding="utf-8"))
    words = open_catalogue(paper.language)
    owner = f"{words.text('paper.owner', code=paper.code)} · {paper.student}"
    return page.substitute(
        language=words.text("language.tag"),
        title=escape(f"{paper.title} {paper.code}"),
        style=fill_layout("html", "paper.css", size=_CSS_SIZES[size]),
        body=body,
        footer=escape(owner),
    ).encode()
