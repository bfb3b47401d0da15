"""The claims that the sentences of a statement make, read by those that the catalogues know."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template

DIFFERENT = 1e-6  # of a length: less is what doubles leave
LETTER = r"[A-Z](?:_\{?\d+\}?)?'*"
_SHAPES = {
    "POINT": rf"\$(?P<point>{LETTER})\$",
    "OTHER": rf"\$(?P<other>{LETTER})\$",
    "LINE": rf"\$(?P<start>{LETTER})(?P<end>{LETTER})\$",
    "GIVEN": r"\{\{\s*(?P<given>\w+)(?:\s*\.\s*(?P<part>value|size))?\s*\}\}",
    "WORD": r"\w+",
    "REST": r"[^.;。；{}]*?",
    "BETWEEN": r"(?P<between>[^.;。；{}]*?)",
    "END": r"(?=\s*(?:[.,;:。，；：]|$))",
    "ALONE": r"(?![^.;。；]*\{\{)",
}


def read_claims(template: Template, kind: str, before: str = "") -> Iterator[dict[str, str]]:
    """What the sentences of a kind name, in whatever language they are; as `said` what they say."""
    for text in template.words.statement.texts:
        for sentence in list_words(kind):
            for match in _make_pattern(sentence, before).finditer(text):
                yield {**match.groupdict(""), "said": " ".join(match[0].split())}


def list_words(kind: str) -> Iterator[str]:
    """The sentences or words of a kind in all languages."""
    for language in known_languages():
        yield from open_catalogue(language).text(f"template.says-{kind}").split("|")


def _make_pattern(sentence: str, before: str) -> re.Pattern[str]:
    """A sentence of the catalogue as a pattern: its capital words are shapes, a blank any room; no
    word begins within another, as in counter-clockwise.
    """
    pieces = re.findall(r"[A-Z]{2,}|\s+|(?:(?![A-Z]{2,})\S)+", sentence.strip())
    return re.compile(before + "".join(map(_write_piece, pieces)), re.ASCII)


def _write_piece(piece: str) -> str:
    """A piece of a sentence as a pattern."""
    if piece.isspace():
        return r"\s*"
    within = r"(?<![\w-])" if piece[0].isalpha() else ""
    return _SHAPES.get(piece) or within + re.escape(piece)


def find_points(template: Template, *letters: str) -> list[str]:
    """The points that go by these letters; none where one of them is no point's."""
    labels = template.figure.labels
    named = {
        _plain(labels.get(name) or write_point_symbol(name)): name
        for name in template.scheme.points
    }
    found = [named.get(_plain(letter), "") for letter in letters]
    return found if all(found) else []


def _plain(symbol: str) -> str:
    """O_{1} is O_1."""
    return symbol.replace("{", "").replace("}", "")
