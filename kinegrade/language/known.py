"""Which languages there are: those with a folder of catalogues."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cache

from kinegrade.errors import FieldError, suggest
from kinegrade.language import ENGLISH, Language
from kinegrade.language.entries import catalogue_folder
from kinegrade.language.message import Message, Quoted

_SETTINGS = ("LC_ALL", "LC_MESSAGES", "LANG")  # of POSIX: the first that is set decides


@cache
def known_languages() -> tuple[Language, ...]:
    """The languages with catalogues, by name.

    >>> ENGLISH in known_languages()
    True
    """
    folders = catalogue_folder(Language("")).iterdir()
    return tuple(sorted(Language(folder.name) for folder in folders if folder.is_dir()))


def read_language(text: str) -> Language:
    """The language of that name. Raises FieldError for one that has no catalogues."""
    if text in known_languages():
        return Language(text)
    raise FieldError(
        Message("grammar.unknown", name=Quoted(text)),
        Message("grammar.language"),
        suggest(text, known_languages()),
    )


def choose_terminal_language(settings: Mapping[str, str] = os.environ) -> Language:
    """The language that the environment asks for on the terminal; English where there is no
    catalogue for it.

    >>> choose_terminal_language({"LANG": "zh_CN.UTF-8"}), choose_terminal_language({"LANG": "C"})
    ('zh', 'en')
    """
    asked = next((settings[name] for name in _SETTINGS if settings.get(name)), "")
    name = Language(asked.split("_")[0].split(".")[0])
    return name if name in known_languages() else ENGLISH
