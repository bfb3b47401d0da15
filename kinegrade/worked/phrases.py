"""The sentences of worked solutions in both languages, from `phrases.toml`."""

from __future__ import annotations

import re
import tomllib
from functools import cache
from importlib.resources import files
from typing import Any

from kinegrade.language import Language

_PLACE = re.compile(r"<(\w+)>")


@cache
def _load_phrases() -> dict[str, dict[Language, str]]:
    """All sentences by name and language."""
    text = files("kinegrade.worked").joinpath("phrases.toml").read_text(encoding="utf-8")
    table: dict[str, Any] = tomllib.loads(text)
    return table


def fill_phrase(key: str, language: Language, **parts: object) -> str:
    """A sentence in one language with its placeholders filled in; an inserted first word keeps its
    case.

    >>> fill_phrase("ccw", "zh")
    '逆时针'
    """
    return _PLACE.sub(lambda place: str(parts[place[1]]), _load_phrases()[key][language])
