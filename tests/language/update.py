"""Bring the catalogue of a language up to English: `python -m tests.language.update LANGUAGE`.

Entries that are missing are added untranslated, in the order of the English ones; those whose English
text has changed are marked fuzzy; those that English no longer has are dropped. A language that has
no catalogue yet gets one. Translate what has an empty `msgstr`, and look through what is fuzzy.
"""

from __future__ import annotations

import sys
from pathlib import Path

from babel.core import UnknownLocaleError
from babel.messages.catalog import Catalog, Message
from babel.messages.pofile import write_po

import kinegrade
from kinegrade.language.entries import NOUN
from tests.language.catalogue_faults import SOURCE, read_catalogue

CATALOGUES = Path(kinegrade.__file__).parent / "language" / "catalogues"


def update_language(language: str, catalogues: Path = CATALOGUES) -> None:
    """Write all files of a language anew, with what is translated there."""
    folder = catalogues / language
    folder.mkdir(exist_ok=True)
    earlier = read_catalogue(folder)
    english = read_catalogue(catalogues / SOURCE)
    for domain, source in english.items():
        write_catalogue(folder / f"{domain}.po", update_file(source, earlier.get(domain), language))
    for domain in earlier.keys() - english.keys():
        (folder / f"{domain}.po").unlink()


def update_file(source: Catalog, earlier: Catalog | None, language: str) -> Catalog:
    """The entries of English with the translations that there are."""
    updated = Catalog(locale=known_locale(language), fuzzy=False, charset="utf-8")
    translations = {each.context: each for each in earlier or ()}
    for message in source:
        if message.context is not None:
            updated[message.id] = update_entry(message, translations.get(message.context), updated)
    return updated


def update_entry(source: Message, earlier: Message | None, into: Catalog) -> Message:
    """An entry with its translation; fuzzy where that is one of another text."""
    plural = isinstance(source.id, list | tuple)
    empty = ("",) * into.num_plurals if plural else ""
    translation = earlier.string if earlier is not None else empty
    updated = Message(source.id, translation, context=source.context)
    updated.flags = source.flags & {NOUN}  # Babel would guess others from the text
    if earlier is not None and (earlier.id != source.id or earlier.fuzzy):
        updated.flags.add("fuzzy")
    return updated


def known_locale(language: str) -> str | None:
    """The language where Babel knows its plurals; else it gets those of English."""
    try:
        Catalog(locale=language)
    except UnknownLocaleError:
        return None
    return language


def write_catalogue(file: Path, catalog: Catalog) -> None:
    """A file of entries, one text a line, under the header that counts: language and plurals."""
    head = (
        'msgid ""\nmsgstr ""\n'
        f'"Language: {file.parent.name}\\n"\n'
        '"Content-Type: text/plain; charset=utf-8\\n"\n'
        f'"Plural-Forms: {catalog.plural_forms}\\n"\n\n'
    )
    with file.open("wb") as stream:
        stream.write(head.encode())
        write_po(stream, catalog, width=0, omit_header=True)


if __name__ == "__main__":
    update_language(sys.argv[1])
