"""The entries of a catalogue as their files hold them: gettext's .po, read with polib.

`msgctxt` is the key without its part before the point, which is the file's name; `msgid` is the
English text, `msgstr` the translation; in English itself `msgstr` is empty. Names that sentences
decline are flagged `noun` and give one form after another, separated by "|".

Dataclasses, for `--help` needs no msgspec, which would take a sixth of its time to load.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from gettext import c2py
from pathlib import Path
from typing import TYPE_CHECKING

from kinegrade.language import ENGLISH, Language

if TYPE_CHECKING:
    from polib import POEntry

NOUN = "noun"
_RULE = "n != 1"  # what gettext takes where a file states none


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
    from polib import pofile  # it would slow every start

    catalogue = pofile(str(catalogue_folder(language) / f"{domain}.po"), encoding="utf-8")
    entries = {
        f"{domain}.{entry.msgctxt}": _read_entry(entry, language)
        for entry in catalogue
        if entry.msgctxt is not None and not entry.obsolete
    }
    return Entries(entries, c2py(_find_plural_rule(catalogue.metadata.get("Plural-Forms", ""))))


def _find_plural_rule(header: str) -> str:
    """The expression for the number of a plural's form.

    >>> _find_plural_rule("nplurals=2; plural=(n != 1);")
    '(n != 1)'
    """
    return header.partition("plural=")[2].rstrip(" ;") or _RULE


def _read_entry(entry: POEntry, language: Language) -> Entry:
    plural = entry.msgid_plural
    source = (entry.msgid, plural) if plural else (entry.msgid,)
    texts = source if language == ENGLISH else _list_translations(entry)
    return Entry(texts, source, frozenset(entry.flags))


def _list_translations(entry: POEntry) -> tuple[str, ...]:
    """The translation, or one for each form of a plural."""
    if not entry.msgid_plural:
        return (entry.msgstr,)
    return tuple(text for _, text in sorted(entry.msgstr_plural.items()))
