"""The TOML text of a template or a shared mechanism as plain tables, within limits.

Which tables there are, and faults cut to one line, are here too.
"""

from __future__ import annotations

from typing import Any

from kinegrade.errors import TemplateError, TomlError, message
from kinegrade.fields.place import Where
from kinegrade.fields.toml_text import read_toml

MAX_CHARACTERS = 100_000

KEYS = (
    "title",
    "family",
    "source",
    "parameters",
    "lengths",
    "points",
    "bodies",
    "joints",
    "inputs",
    "conditions",
    "asks",
    "statement",
    "text",
    "published",
    "figure",
    "tags",
    "method",
)
KNOWN = (*KEYS, "mechanism")  # a template that stands alone has no use for the last
NEEDED = (
    "title",
    "family",
    "source",
    "parameters",
    "points",
    "bodies",
    "joints",
    "inputs",
    "asks",
    "statement",
)


def toml_tables(where: str, text: str) -> dict[str, Any]:
    """The tables of a TOML text. Raises TemplateError when it is too long, no TOML, or holds absurd
    numbers.
    """
    if len(text) > MAX_CHARACTERS:
        raise TemplateError(f"{where}: {len(text)} characters: at most {MAX_CHARACTERS} are read")
    try:
        return read_toml(text)
    except TomlError as error:
        place = str(Where(where, (), error.line))
        raise TemplateError(message(place, str(error), "a template in TOML", "fix it")) from error
