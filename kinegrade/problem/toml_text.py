"""The TOML text of a template or a shared mechanism as plain tables, within limits.

Which tables there are, and faults cut to one line, are here too.
"""

from __future__ import annotations

from typing import Any

from kinegrade.errors import TemplateError, TomlError, one_line
from kinegrade.toml_reading import read_toml

MAX_CHARACTERS = 100_000
MAX_PROBLEM = 300  # characters of a fault: enough for a place, what stands there, what was expected

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
        raise TemplateError(f"{where}: not readable as TOML: {short_line(str(error))}") from error


def short_line(text: str) -> str:
    """A text as one line of a message can hold it."""
    line = one_line(text)
    return line if len(line) <= MAX_PROBLEM else f"{line[: MAX_PROBLEM - 1]}…"
