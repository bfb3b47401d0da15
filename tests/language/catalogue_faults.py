"""What is wrong with the catalogues, entry by entry, and with the code that names their entries."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from pathlib import Path

from babel.messages.catalog import Catalog, Message
from babel.messages.pofile import read_po

from benchmarks.modules import File
from tests.package_files import locate

PLACE = re.compile(r"<([A-Za-z][a-z_]*)(?::([a-z]+))?>")
DEBRIS = re.compile(r"^\s|\s$")
NAMED = ("Message", "text")  # what takes a key and its parts
LISTED = ("raw", "texts")  # what takes the beginning of keys
SOURCE = "en"
NOUN = "noun"  # the flag of names that sentences decline
NUMBER = "count"  # a part that may choose between texts without standing in them


def read_catalogue(folder: Path) -> dict[str, Catalog]:
    """The files of a language by their names, to be changed."""
    return {file.stem: _parse(file.read_bytes()) for file in sorted(folder.glob("*.po"))}


def _parse(text: bytes) -> Catalog:
    return read_po(BytesIO(text), charset="utf-8", abort_invalid=True)


_parse_once = cache(_parse)  # what nobody changes


def _read_once(folder: Path) -> dict[str, Catalog]:
    """The files of a language by their names, to be read."""
    return {file.stem: _parse_once(file.read_bytes()) for file in sorted(folder.glob("*.po"))}


def read_messages(folder: Path) -> dict[str, Message]:
    """The entries of a language by key."""
    return {
        f"{domain}.{message.context}": message
        for domain, catalog in _read_once(folder).items()
        for message in catalog
        if message.context is not None
    }


def find_catalogue_faults(folder: Path, source: Path) -> Iterator[str]:
    """What a translator has left undone or wrong, compared with the English source."""
    entries, english = read_messages(folder), read_messages(source)
    forms = _read_forms(entries)
    plurals = {domain: each.num_plurals for domain, each in _read_once(folder).items()}
    for domain in sorted({key.partition(".")[0] for key in english} - plurals.keys()):
        yield f"{folder.name}/{domain}.po: missing"
    for key in sorted(english.keys() - entries.keys()):
        if key.partition(".")[0] in plurals:
            yield f"{folder.name}: {key}: missing"
    for key in sorted(entries.keys() - english.keys()):
        yield f"{folder.name}: {key}: not in English"
    for key in sorted(entries.keys() & english.keys()):
        count = plurals[key.partition(".")[0]]
        for fault in _find_entry_faults(entries[key], english[key], forms, count):
            yield f"{folder.name}: {key}: {fault}"


def _find_entry_faults(
    entry: Message, english: Message, forms: Sequence[str], plurals: int
) -> Iterator[str]:
    if entry.id != english.id:
        yield "translates another English text"
        return
    if entry.fuzzy:
        yield "is marked fuzzy"
    if (NOUN in entry.flags) != (NOUN in english.flags):
        yield f"is {'a' if NOUN in entry.flags else 'no'} noun, unlike the English entry"
    texts = _texts(entry.string)
    if not all(texts):
        yield "not translated"
        return
    if len(texts) != (plurals if isinstance(english.id, list | tuple) else 1):
        yield f"has {len(texts)} texts for numbers, its language {plurals}"
    yield from _find_text_faults(texts, english, forms)


def _find_text_faults(
    texts: Sequence[str], english: Message, forms: Sequence[str]
) -> Iterator[str]:
    wanted = set().union(*(places(text) for text in _texts(english.id)))
    for text in texts:
        if places(text) - wanted or wanted - places(text) - {NUMBER}:
            yield f"has the places {sorted(places(text))}, in English {sorted(wanted)}"
        for _, form in PLACE.findall(text):
            if form and form not in forms:
                yield f"asks for the form {form}, the language has {', '.join(forms)}"
        if NOUN in english.flags and len(text.split("|")) != len(forms):
            yield f"has {len(text.split('|'))} forms, the language {len(forms)}"


def places(text: str) -> set[str]:
    """The names of the places of a text."""
    return {name.lower() for name, _ in PLACE.findall(text)}


def _texts(texts: str | Sequence[str] | None) -> tuple[str, ...]:
    return (texts or "",) if isinstance(texts, str | None) else tuple(texts)


def _read_forms(entries: Mapping[str, Message]) -> tuple[str, ...]:
    forms = entries.get("language.forms")
    return tuple(str(forms.string or forms.id).split()) if forms else ()


@dataclass(frozen=True)
class Named:
    """Where code names an entry, by a pattern of its key; and the parts given with it, or None
    where they cannot be seen.
    """

    place: str
    pattern: str
    parts: frozenset[str] | None


def find_named(files: Iterable[File]) -> Iterator[Named]:
    """All entries that the code of some modules names."""
    for file in files:
        for node in file.nodes:
            if isinstance(node, ast.Call) and node.args:
                yield from _read_call(node, f"{locate(file)}:{node.lineno}")


def _read_call(call: ast.Call, place: str) -> Iterator[Named]:
    name = getattr(call.func, "attr", getattr(call.func, "id", ""))
    if name in NAMED:
        for key in _read_keys(call.args[0]):
            if r"\." in key:
                yield Named(place, key, _read_parts(call))
    elif name in LISTED and isinstance(call.func, ast.Attribute):
        beginning = r"\.".join(_pattern(argument) for argument in call.args)
        yield Named(place, f"{beginning}.*", None)


def _read_keys(key: ast.expr) -> Iterator[str]:
    """The patterns of a key; of both, where one is chosen."""
    if isinstance(key, ast.IfExp):
        yield from _read_keys(key.body)
        yield from _read_keys(key.orelse)
    elif isinstance(key, ast.JoinedStr | ast.Constant):
        yield _pattern(key)


def _pattern(text: ast.expr) -> str:
    """A pattern that a text fits; what is filled in may be anything of a key."""
    match text:
        case ast.Constant(value=str() as value):
            return re.escape(value)
        case ast.JoinedStr():
            return "".join(map(_pattern, text.values))
        case _:
            return r"[\w-]+"


def _read_parts(call: ast.Call) -> frozenset[str] | None:
    if any(keyword.arg is None for keyword in call.keywords) or len(call.args) > 1:
        return None
    return frozenset(str(keyword.arg) for keyword in call.keywords)


def find_code_faults(files: Iterable[File], source: Path) -> Iterator[str]:
    """Entries that code names and English lacks, parts that do not fit, entries nothing names."""
    entries = read_messages(source)
    used: set[str] = set()
    for named in find_named(files):
        fitting = _find_fitting(named.pattern, entries)
        used.update(fitting)
        if not fitting:
            yield f"{named.place}: no entry {_plain(named.pattern)}"
        if named.parts is None:
            continue
        for key in fitting:
            wanted = set().union(*(places(text) for text in _texts(entries[key].id)))
            if wanted - named.parts or named.parts - wanted - {NUMBER}:
                yield f"{named.place}: {key} takes {sorted(wanted)}, not {sorted(named.parts)}"
    for key in sorted(entries.keys() - used):
        yield f"{key}: no code names it"


def _find_fitting(pattern: str, entries: Mapping[str, Message]) -> list[str]:
    """The keys that fit a pattern, one at most where nothing is filled in."""
    plain = _plain(pattern)
    if re.escape(plain) == pattern:
        return [plain] if plain in entries else []
    return [key for key in entries if re.fullmatch(pattern, key)]


def _plain(pattern: str) -> str:
    return pattern.replace("\\", "")
