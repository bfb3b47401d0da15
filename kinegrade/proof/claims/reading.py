"""The claims that the sentences of a statement make, read by those that the catalogues know."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.sign_conventions import Convention

DIFFERENT = 1e-6  # of a length: less is what doubles leave
LETTER = r"[A-Z](?:_\{?\d+\}?)?'*"
# A line through a point, or what turns about it, is no place of the point itself
NO_SUBJECT = "(?<!through )(?<!about )(?<!durch )(?<!um )(?<!过 )(?<!过)(?<!绕 )(?<!绕)"
_SHAPES = {
    "POINT": rf"\$(?P<point>{LETTER})\$",
    "OTHER": rf"\$(?P<other>{LETTER})\$",
    "LINE": rf"\$(?P<start>{LETTER})(?P<end>{LETTER})\$",
    "LINEIS": rf"\$(?P<start>{LETTER})(?P<end>{LETTER})\s*=\s*\$",
    "GIVEN": r"\{\{\s*(?P<given>\w+)(?:\s*\.\s*(?P<part>value|size))?\s*\}\}",
    "WORD": r"\w+",
    "REST": r"[^.;。；{}]*?",
    "BETWEEN": r"(?P<between>[^.;。；{}]*?)",
    "END": r"(?=\s*(?:[.,;:。，；：]|$))",
    "ALONE": r"(?![^.;。；]*\{\{)",
}

_PLAIN = r"[^.,;:。，；：{}()（）]"  # within one part of a sentence
_SENSES: Mapping[Convention, str] = {
    "ccw": "sign-counterclockwise",
    "cw": "sign-clockwise",
    "+x": "sign-right",
    "-x": "sign-left",
    "+y": "sign-up",
    "-y": "sign-down",
}


def read_claims(template: Template, kind: str, before: str = "") -> Iterator[dict[str, str]]:
    """What the sentences of a kind name, in whatever language they are; as `said` what they say."""
    return read_texts(template.words.statement.texts, kind, before)


def read_texts(texts: Iterable[str], kind: str, before: str = "") -> Iterator[dict[str, str]]:
    """The same of any texts."""
    for text in texts:
        for sentence in list_words(kind):
            for match in _make_pattern(sentence, before).finditer(text):
                yield {**match.groupdict(""), "said": " ".join(match[0].split())}


def list_words(kind: str) -> Iterator[str]:
    """The sentences or words of a kind in all languages."""
    for language in known_languages():
        yield from open_catalogue(language).text(f"template.says-{kind}").split("|")


def name_senses(said: str) -> set[Convention]:
    """The senses that words name: "to the right of" a point is none, and counter-clockwise is not
    clockwise.
    """
    return {sense for sense in _SENSES if re.search(_write_words(_SENSES[sense]), said, re.ASCII)}


@cache
def _write_words(*kinds: str) -> str:
    """Any word of some kinds as a pattern, the longest first."""
    words = {word for kind in kinds for word in list_words(kind)}
    return "|".join(map(_write_word, sorted(words, key=lambda word: (-len(word), word))))


def _write_word(word: str) -> str:
    """A word by itself, with room in place of its blanks; a place to the right of another one is
    no sense.
    """
    room = r"\s+".join(map(re.escape, word.split()))
    start, end = (r"(?<![\w-])" if word[0].isascii() else ""), ""
    if word[-1].isascii():
        end = r"(?![\w-])(?!\s+(?:of|von)(?!\w))"
    return f"{start}{room}{end}"


@cache
def _list_shapes() -> Mapping[str, str]:
    """What the capital words of the sentences stand for."""
    near = f"(?:(?!{_write_words('another-matter')}){_PLAIN})*?"
    senses = _write_words(*_SENSES.values())
    verbs = f"(?:{_write_words('verb')})"
    return {**_SHAPES, "NEAR": near, "SENSE": f"(?P<sense>{senses})", "VERB": verbs}


@cache
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
    return _list_shapes().get(piece) or within + re.escape(piece)


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
