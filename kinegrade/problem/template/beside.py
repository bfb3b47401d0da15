"""Translations in files beside: `slider-crank.de.toml` holds German texts of `slider-crank.toml`.

A translation has the keys of the file that it translates, with a text at each:

    title = "Schubkurbelgetriebe"
    statement = "..."

    [parameters]
    r = "Länge der Kurbel OA"

    [bodies]
    ram = "der Stößel|des Stößels|dem Stößel|den Stößel"  # a body that is named by a word

    [asks]
    v_B = "Geschwindigkeit des Schiebers $B$"
    a_rel = { means = "...", sign = "..." }  # where the author states a sign convention in words

    [reasons]
    l = "Die Tangenten von $O_1$ aus sind gleich lang"  # why a named length is what it is

    [text]
    turning = ["schneller werdend", "gleichförmig"]  # the wordings in their order

Its texts are laid into the tables of the file, which are then read as if they stood there; faults
name the file and the line on which a text does stand.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from glob import escape
from pathlib import Path

from msgspec import Struct

from kinegrade.errors import FieldError, suggest
from kinegrade.files.fields.document import Document, FileKind, read_text, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.lines import lines_of_toml
from kinegrade.files.fields.place import Place, Source, Where, key_path
from kinegrade.files.fields.values import text as read_words
from kinegrade.language import Language
from kinegrade.language.known import known_languages, read_language
from kinegrade.language.message import Fault, Message
from kinegrade.problem.template.translation_names import name_beside

Translations = Mapping[Language, str]  # the texts of the files, by their languages
Content = Mapping[str, object]
_LENGTH_OF_CODE = 2  # of a language that is not known


class Beside(Struct, frozen=True):
    """The translations beside a file, which is named as messages name it."""

    file: str
    kind: FileKind
    translations: Translations


class LaidIn(Struct, frozen=True):
    """The tables of a file with the texts of its translations in them, where everything stands, and
    the faults of the translations.
    """

    content: dict[str, object]
    source: Source
    faults: tuple[Faults, ...]


class _Translation(Struct, frozen=True):
    """A file of translations that is TOML."""

    language: Language
    document: Document
    content: Content
    faults: Faults


class _TranslatedSource(Struct, frozen=True):
    """A file with texts of others laid into it: `laid` says whose the text at a place is."""

    base: Source
    laid: Mapping[Place, tuple[Document, Place]]

    def where(self, place: Place) -> Where:
        """The file and line of a place."""
        if place not in self.laid:
            return self.base.where(place)
        document, inside = self.laid[place]
        return document.where(inside)


def is_translation(path: Path) -> bool:
    """Whether a file has the name of a translation."""
    return "." in path.stem and _is_code(path.stem.rpartition(".")[2])


def read_translations(path: Path, kind: FileKind) -> dict[Language, str]:
    """The texts of the files beside one, by language.

    Raises the kind's error where one cannot be read or its language is not known.
    """
    files = {
        file.stem.removeprefix(f"{path.stem}."): file
        for file in sorted(path.parent.glob(f"{escape(path.stem)}.*.toml"))
    }
    return {
        _read_code(code, file, kind): read_text(file, kind)
        for code, file in files.items()
        if _is_code(code)
    }


def lay_in(
    content: Content, source: Source, beside: Beside, places: Mapping[Place, Place]
) -> LaidIn:
    """The tables of a file with the texts of its translations.

    `places` are those at which a translation may have a text, with the tables by language into
    which it goes. Raises the kind's error where a translation is not TOML.
    """
    laid: dict[Place, tuple[Document, Place]] = {}
    together = dict(content)
    opened = [
        _open(name_beside(beside.file, language), language, text, beside.kind)
        for language, text in beside.translations.items()
    ]
    for one in opened:
        for place, words in _list_texts(one, places):
            target = (*places[place], one.language)
            if _is_free(one, place, target, together):
                together = _put(together, target, words)
                laid[target] = one.document, place
    return LaidIn(together, _TranslatedSource(source, laid), tuple(one.faults for one in opened))


def state_texts(content: Content, places: Iterable[Place]) -> Content:
    """The tables of a file with its `language` beside each text that it writes once at one of these
    places, so that other languages may stand beside it.
    """
    language = content.get("language")
    if not isinstance(language, str) or language not in known_languages():
        return content
    for place in places:
        words = find_value(content, place)
        if isinstance(words, str):
            content = _put(content, (*place, language), words)
    return content


def find_value(content: object, place: Place) -> object:
    """What stands at a place; None where nothing does."""
    inside = content
    for step in place:
        match inside, step:
            case dict(), str() if step in inside:
                inside = inside[step]
            case list(), int() if 0 <= step < len(inside):
                inside = inside[step]
            case _:
                return None
    return inside


def _is_code(code: str) -> bool:
    """Whether part of a file's name stands for a language, known or not."""
    return code in known_languages() or (len(code) == _LENGTH_OF_CODE and code.isalpha())


def _read_code(code: str, file: Path, kind: FileKind) -> Language:
    try:
        return read_language(code)
    except FieldError as error:
        raise kind.error(Fault(str(file), error.what, error.expected, error.do)) from error


def _open(file: str, language: Language, text: str, kind: FileKind) -> _Translation:
    table = toml_table(file, text, kind)
    document = Document(file, text, lines_of_toml)
    return _Translation(language, document, table.content, table.faults)


def _list_texts(
    translation: _Translation, places: Mapping[Place, Place]
) -> Iterator[tuple[Place, str]]:
    """The texts of a translation at places where there may be one; others are noted as faults."""
    for place, value in _list_leaves(translation.content, ()):
        if place not in places:
            known = suggest(key_path(place), map(key_path, places))
            translation.faults.note(place, Message("texts.no-such-text"), do=known)
            continue
        try:
            yield place, read_words(value)
        except FieldError as error:
            translation.faults.note_error(place, error)


def _is_free(translation: _Translation, place: Place, target: Place, content: Content) -> bool:
    """Whether there is no text in the language yet where one is to go; a fault is noted if not."""
    there = find_value(content, target[:-1])
    if not isinstance(there, dict):
        remedy = Message("texts.name-languages")
        translation.faults.note(place, Message("texts.plain"), do=remedy)
        return False
    if translation.language in there:
        what = Message("texts.twice", language=translation.language)
        translation.faults.note(place, what, do=Message("texts.leave-one-out"))
        return False
    return True


def _list_leaves(value: object, place: Place) -> Iterator[tuple[Place, object]]:
    match value:
        case dict():
            for key, inside in value.items():
                yield from _list_leaves(inside, (*place, key))
        case list():
            for number, inside in enumerate(value):
                yield from _list_leaves(inside, (*place, number))
        case _:
            yield place, value


def _put(content: Content, place: Place, words: str) -> dict[str, object]:
    """The same tables with a text at a place."""
    together = _replace(content, place, words)
    return together if isinstance(together, dict) else dict(content)


def _replace(inside: object, place: Place, words: str) -> object:
    if not place:
        return words
    first, rest = place[0], place[1:]
    match inside, first:
        case dict(), str():
            return {**inside, first: _replace(inside.get(first), rest, words)}
        case str(), str():
            return {first: words}
        case list(), int():
            return [*inside[:first], _replace(inside[first], rest, words), *inside[first + 1 :]]
        case _:
            return inside
