"""What one sheet set by LaTeX gives: its pages, and a source that can be typeset again."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePosixPath
from types import MappingProxyType

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.latex.xetex import STYLE, write_style
from kinegrade.press.protocol import Printout


def make_printout(
    name: str,
    pdf: bytes,
    source: str,
    language: Language,
    pictures: Mapping[str, bytes] = MappingProxyType({}),
) -> Printout:
    """The pages, and their source with the style and the pictures that it asks for beside it."""
    place = PurePosixPath(name)
    text = _write_introduction(place.name, language) + source
    files = {f"{place.name}.tex": text.encode(), STYLE: write_style().encode(), **pictures}
    return Printout(pdf, {str(place.with_name(beside)): files[beside] for beside in files})


def _write_introduction(name: str, language: Language) -> str:
    words = open_catalogue(language)
    return f"% {words.text('typesetting.source', file=f'{name}.tex')}\n"
