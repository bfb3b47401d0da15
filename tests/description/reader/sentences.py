"""Sentences and the strict patterns by which they are read."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from tests.description.reader.lines import MATH
from tests.description.reader.phrases import KINDS, body_of, mover_of
from tests.description.reader.vocabulary import Vocabulary, lowered

BLANK = re.compile(r"\{(\w+)(?::(\w+))?\}")
Parts = dict[str, Any]


class NotUnderstood(ValueError):
    """A sentence that no pattern matches."""


@dataclass(frozen=True)
class Pattern:
    """A form of sentence with blanks `{kind:label}`, and what is made of what fills them."""

    form: str
    make: Callable[[Parts, Vocabulary], Iterable[object]]


def sentences_of(paragraph: str) -> Iterator[str]:
    """The sentences, without their full stops."""
    text = " ".join(paragraph.split())
    start, formula = 0, False
    for place, sign in enumerate(text):
        formula ^= sign == "$"
        if sign == "." and not formula and text[place + 1 : place + 2] in ("", " "):
            yield text[start:place].strip()
            start = place + 1
    if text[start:].strip():
        raise NotUnderstood(f"a sentence without its full stop: {text[start:].strip()}")


def kind_of(kind: str, words: Vocabulary) -> tuple[str, Callable[[str, Vocabulary], Any]]:
    """What may fill a blank, and how it is read."""
    body = words.pattern_of_bodies()
    if kind == "body":
        return body, body_of
    if kind == "bodies":
        return f"{body}(?:, {body})*,? and {body}", bodies_of
    if kind == "mover":
        return f"(?:{MATH} of {body}|{MATH})", mover_of
    return KINDS[kind]


def bodies_of(text: str, words: Vocabulary) -> list[str]:
    """All the bodies of a list."""
    return [words.body(part) for part in re.findall(words.pattern_of_bodies(), text)]


def fills(pattern: Pattern, sentence: str, words: Vocabulary) -> Parts | None:
    """What fills the blanks of the pattern in the sentence, if it has that form."""
    blanks = {found[2] or found[1]: found[1] for found in BLANK.finditer(pattern.form)}
    form = BLANK.sub(
        lambda found: f"(?P<{found[2] or found[1]}>{kind_of(found[1], words)[0]})", pattern.form
    )
    match = re.fullmatch(form, lowered(sentence))
    if match is None:
        return None
    parts: Parts = dict(match.groupdict())
    for label, kind in blanks.items():
        if parts[label] is not None:
            parts[label] = kind_of(kind, words)[1](parts[label], words)
    return parts


def read_sentence(sentence: str, patterns: Iterable[Pattern], words: Vocabulary) -> list[object]:
    """What the sentence tells; exactly one pattern must have its form."""
    found = [(p, parts) for p in patterns if (parts := fills(p, sentence, words)) is not None]
    if len(found) != 1:
        trouble = "more than one meaning" if found else "sentence not understood"
        raise NotUnderstood(f"{trouble}: {sentence}")
    pattern, parts = found[0]
    return list(pattern.make(parts, words))
