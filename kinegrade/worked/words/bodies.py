"""The words for the kinds of bodies that templates name: the crank, gear 2."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Literal

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message, Text

_Kind = Literal[
    "arm",
    "bar",
    "boom",
    "cam",
    "cord",
    "coupler",
    "crank",
    "cylinder",
    "disc",
    "door",
    "drum",
    "dynamo",
    "engine",
    "follower",
    "frame",
    "gear",
    "jaw",
    "lever",
    "load",
    "pinion",
    "piston",
    "planet-gear",
    "plate",
    "platform",
    "pulley",
    "rack",
    "ring",
    "rocker",
    "rod",
    "roller",
    "rope",
    "shaft",
    "sleeve",
    "slider",
    "spool",
    "strut",
    "sun-gear",
    "table",
    "wheel",
    "yoke",
]
_KINDS: Mapping[str, _Kind] = {  # by the words that templates use for bodies
    "arm": "arm",
    "bar": "bar",
    "boom": "boom",
    "cam": "cam",
    "cord": "cord",
    "coupler": "coupler",
    "crank": "crank",
    "cylinder": "cylinder",
    "disc": "disc",
    "disk": "disc",
    "door": "door",
    "drum": "drum",
    "dynamo": "dynamo",
    "engine": "engine",
    "follower": "follower",
    "frame": "frame",
    "gear": "gear",
    "jaw": "jaw",
    "lever": "lever",
    "load": "load",
    "pinion": "pinion",
    "piston": "piston",
    "planet": "planet-gear",
    "plate": "plate",
    "platform": "platform",
    "pulley": "pulley",
    "rack": "rack",
    "ring": "ring",
    "rocker": "rocker",
    "rod": "rod",
    "roller": "roller",
    "rope": "rope",
    "shaft": "shaft",
    "sleeve": "sleeve",
    "slider": "slider",
    "spool": "spool",
    "strut": "strut",
    "sun": "sun-gear",
    "table": "table",
    "tappet": "follower",
    "wheel": "wheel",
    "yoke": "yoke",
}


_NO_POINTS = re.compile(r"(?=(?:[^a-z]|p)*[a-oq-z])[A-Za-z]{3,}\d*")  # p is the prime of points


def is_word(name: str) -> bool:
    """Whether a body is named by a word rather than by letters of points.

    >>> is_word("drum"), is_word("Trommel"), is_word("ring1"), is_word("OpD"), is_word("W1")
    (True, True, True, False, False)
    """
    return name.islower() or bool(_NO_POINTS.fullmatch(name))


def is_kind(word: str) -> bool:
    """Whether the catalogues have a word for a kind of body."""
    return _find_kind(word) is not None


def _find_kind(word: str) -> _Kind | None:
    """The kind of body that a word of any language names."""
    lower = word.lower()
    return _KINDS.get(lower) or _gather_translated_kinds().get(lower)


@cache
def _gather_translated_kinds() -> Mapping[str, _Kind]:
    """The kinds by the catalogues' words for them."""
    found = dict[str, _Kind]()
    for language in known_languages():
        for kind in _KINDS.values():
            word = open_catalogue(language).text(f"solution.bare-{kind}")
            found.setdefault(word.lower(), kind)
    return found


def name_kind(word: str) -> Message:
    """A body by the word for its kind, with its article; a word that is not known stays as the
    template has it.
    """
    kind = _find_kind(word)
    if kind is None:
        return Message("solution.other-body", name=word.replace("_", " "))
    return Message(f"solution.body-{kind}")


def name_by_number(word: str, number: str) -> Message:
    """A body by the word for its kind and its number, or its letter in prose."""
    kind = _find_kind(word)
    if kind is None:
        return Message("solution.other-body", name=f"{word} {number}")
    return Message(f"solution.numbered-{kind}", number=number)


def name_barely(word: str) -> Text:
    """The word for a kind of body without an article."""
    kind = _find_kind(word)
    return Message(f"solution.bare-{kind}") if kind else word.replace("_", " ")
