"""The entries of a catalogue as their files hold them: gettext's .po, read with Babel.

`msgctxt` is the key without its part before the point, which is the file's name; `msgid` is the
English text, `msgstr` the translation; in English itself `msgstr` is empty. Names that sentences
decline are flagged `noun` and give one form after another, separated by "|".
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from gettext import c2py
from pathlib import Path
from typing import TYPE_CHECKING

from kinegrade.language import ENGLISH, Language

if TYPE_CHECKING:
    from babel.messages.catalog import Message

NOUN = "noun"


@dataclass(frozen=True)
class Entry:
    """A text, or one for each number of things; `source` is what it translates."""

    texts: tuple[str, ...]
    source: tuple[str, ...]
    flags: frozenset[str]


@dataclass(frozen=True)
class Entries:
    """A file of a catalogue: its entries by key, and which of an entry's texts a number takes."""

    entries: Mapping[str, Entry]
    plural: Callable[[int], int]


def catalogue_folder(language: Language) -> Path:
    """Where the files of a language are."""
    return Path(__file__).parent / "catalogues" / language


@cache
def read_entries(language: Language, domain: str) -> Entries:
    """One file of a language, read once."""
    from babel.messages.pofile import read_po  # it would slow every start

    file = catalogue_folder(language).joinpath(f"{domain}.po")
    with file.open("rb") as stream:
        catalog = read_po(stream, charset="utf-8", abort_invalid=True)
    entries = {
        f"{domain}.{message.context}": _read_entry(message, language)
        for message in catalog
        if message.context is not None
    }
    return Entries(entries, c2py(catalog.plural_expr))


def _read_entry(message: Message, language: Language) -> Entry:
    source = _as_tuple(message.id)
    texts = source if language == ENGLISH else _as_tuple(message.string)
    return Entry(texts, source, frozenset(message.flags))


def _as_tuple(texts: str | Sequence[str] | None) -> tuple[str, ...]:
    return (texts or "",) if isinstance(texts, str | None) else tuple(texts)
