"""The names of the files that translate others. Loads nothing, as every start reads it."""

from __future__ import annotations

from kinegrade.language import Language


def name_beside(file: str, language: Language) -> str:
    """The file that translates another one.

    >>> name_beside("mechanisms/arm.toml", Language("de"))
    'mechanisms/arm.de.toml'
    """
    return f"{file.removesuffix('.toml')}.{language}.toml"
