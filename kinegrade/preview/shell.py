"""The page around the parts: choices of the problem and the language, and where parts go."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.press.html.filled_page import load_layout

ASSETS: Mapping[str, str] = {"preview.js": "text/javascript", "preview.css": "text/css"}


def write_shell(path: Path, language: Language) -> str:
    """The page before anything of the file is shown."""
    words = open_catalogue(language)
    return load_layout("preview.html").render(
        words=words.raw("preview", "page."),
        tag=words.text("language.tag"),
        name=path.name,
        chosen=language,
        languages=known_languages(),
    )


def read_asset(name: str) -> bytes:
    """The script or the style of the page."""
    return (files("kinegrade.press.html") / "layouts" / name).read_bytes()
