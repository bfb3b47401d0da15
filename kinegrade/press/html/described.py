"""A figure in words on a page: they unfold below a line that says what they are."""

from __future__ import annotations

from collections.abc import Callable

from kinegrade.description.said import Description
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_plain_html


def write_described(
    described: Description | None, language: Language, write: Callable[[str], str]
) -> str:
    """The long text of a description, its prose turned into HTML by `write`; "" where there is
    none.
    """
    if described is None or not described.long:
        return ""
    heading = write_plain_html(open_catalogue(language).text("description.heading"))
    words = "".join(write(part.text) for part in described.long)
    return f"<details><summary>{heading}</summary>\n{words}</details>\n"
