"""Layouts that are texts with `$name`s to be filled in: HTML, CSS, the XML of Word."""

from __future__ import annotations

from html import escape
from importlib.resources import files
from string import Template


def fill_layout(room: str, name: str, **texts: str) -> str:
    """A file of the `layouts` of a room of the press with texts in place of its `$name`s, escaped
    for XML; control characters become spaces.
    """
    clean = {
        key: "".join(letter if letter.isprintable() else " " for letter in text)
        for key, text in texts.items()
    }
    layout = files(f"kinegrade.press.{room}") / "layouts" / name
    template = Template(layout.read_text(encoding="utf-8"))
    return template.substitute({key: escape(text) for key, text in clean.items()})
