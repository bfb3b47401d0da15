"""The sentences of the catalogues as patterns: their capital words stand for what differs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import pairwise

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.sign_conventions import Convention

LETTER = r"[A-Z](?:_\{?\d+\}?)?'*"
# A line through a point, or what turns about it, is no place of the point itself
NO_SUBJECT = "(?<!through )(?<!about )(?<!durch )(?<!um )(?<!过 )(?<!过)(?<!绕 )(?<!绕)"
SENSES: Mapping[Convention, str] = {
    "ccw": "sign-counterclockwise",
    "cw": "sign-clockwise",
    "+x": "sign-right",
    "-x": "sign-left",
    "+y": "sign-up",
    "-y": "sign-down",
}
_SHAPES = {
    "POINT": rf"\$(?P<point>{LETTER})\$",
    "SAME": r"\$(?P=other)\$",
    "THAN": rf"\$(?P<than>{LETTER})\$",
    "LINE": rf"\$(?P<start>{LETTER})(?P<end>{LETTER})\$",
    "LINEIS": rf"\$(?P<start>{LETTER})(?P<end>{LETTER})\s*=\s*\$",
    "GIVEN": r"\{\{\s*(?P<given>\w+)(?:\s*\.\s*(?P<part>value|size))?\s*\}\}",
    "FORMULA": r"\$(?P<formula>[^$]*[a-z][^$]*)\$",
    "WORD": r"(?u:\w+)",
    "REST": r"[^.;。；{}]*?",
    "BETWEEN": r"(?P<between>[^.;。；{}]*?)",
    "END": r"(?=\s*(?:[.,;:。，；：]|$))",
    "ALONE": r"(?![^.;。；]*\{\{)",
}
_PLAIN = r"[^.,;:。，；：{}()（）]"  # within one part of a sentence
_LATIN = r"(?u:[^\W\d_]|-)+"
_NAME = r"[A-Z]{1,3}_?\d*(?:[A-Z]\d*)*(?!\w)"  # of a body or point, as BG, O1B
HAN = r"[\u4e00-\u9fff]"


def list_words(kind: str) -> Iterator[str]:
    """The sentences or words of a kind in all languages."""
    for language in known_languages():
        yield from open_catalogue(language).text(f"template.says-{kind}").split("|")


def find_words(kind: str, text: str) -> list[str]:
    """The words of a kind that a text has. None begins within another word, as the y component does
    in "velocity component"; German joins words, and Chinese parts none.
    """
    return [
        word
        for language in known_languages()
        for word in open_catalogue(language).text(f"template.says-{kind}").split("|")
        if begins_a_word(word, text, language)
    ]


def begins_a_word(word: str, text: str, language: Language) -> bool:
    """Whether a text has a word that begins one there, or in languages that join words, any."""
    before = r"(?<![\w-])" if language == "en" else ""
    return re.search(before + re.escape(word), text) is not None


@cache
def write_words(*kinds: str) -> str:
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
def make_pattern(sentence: str, before: str) -> re.Pattern[str]:
    """A sentence of the catalogue as a pattern: its capital words are shapes, a blank any room; no
    word begins within another, as in counter-clockwise.
    """
    pieces = re.findall(r"[A-Z]{2,}|\s+|(?:(?![A-Z]{2,})\S)+", sentence.strip())
    written = (_write_piece(piece, last) for last, piece in pairwise(["", *pieces]))
    return re.compile(before + "".join(written), re.ASCII)


def _write_piece(piece: str, last: str) -> str:
    """A piece of a sentence as a pattern; right behind a shape it ends a compound word."""
    if piece.isspace():
        return r"\s*"
    within = r"(?<![\w-])" if piece[0].isalpha() and last not in _list_shapes() else ""
    return _list_shapes().get(piece) or within + re.escape(piece)


@cache
def _list_shapes() -> Mapping[str, str]:
    """What the capital words of the sentences stand for."""
    part = f"(?:(?!{write_words('another-matter')}){_PLAIN})"
    free = f"(?:(?!{write_words('another-matter')})(?!\\$){_PLAIN})"
    word = f"(?!{write_words('preposition')}|{_NAME}){_LATIN}"
    unnamed = rf"(?u:(?![\w-]))(?!\s*\$|\s*{_NAME})"
    lies = f"(?:{write_words('lies')})"
    resumed = rf",\s*(?:{write_words('finite-verb')})"  # of what stands before an insertion
    which = rf"(?!{resumed}),?\s*(?:(?:{write_words('which')})\s*)?"
    return {
        **_SHAPES,
        "NEAR": f"{part}*?",
        "FREE": f"{free}*?",
        "NOUN": rf"(?P<noun>{word}(?:\s+{word}){{0,2}}{unnamed}|{HAN}{{1,6}}?)",
        "SENSE": f"(?P<sense>{write_words(*SENSES.values())})",
        "VERB": f"(?:{write_words('verb')})",
        "FASTER": f"(?:{write_words('faster')})",
        "SLOWER": f"(?:{write_words('slower')})",
        "SLIDES": f"(?:{write_words('slides')})",
        "LIES": rf"{which}{lies}",
        "BE": rf"(?:{which}{lies})?\s*,?",
        "OTHER": rf"{_write_naming()}\$(?P<other>{LETTER})\$",
    }


def _write_naming() -> str:
    """What may stand before the letter of a point: the fixed pin, dem Gelenk, 固定铰链."""
    other = f"(?!{write_words('preposition')})"
    latin = rf"(?:{write_words('article')})\s+(?:{other}{_LATIN}\s+){{0,3}}"
    return rf"(?:{latin}|(?:{other}{HAN}){{1,6}}\s*)?"
