"""The words for the kinds of bodies that templates name: the crank, gear 2."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

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


def is_kind(word: str) -> bool:
    """Whether the catalogues have a word for a kind of body."""
    return word in _KINDS


def name_kind(word: str) -> Message:
    """A body by the word for its kind, with its article; a word of the template that is not known
    stays as it is.
    """
    kind = _KINDS.get(word)
    if kind is None:
        return Message("solution.other-body", name=word)
    return Message(f"solution.body-{kind}")


def name_by_number(word: str, number: str) -> Message:
    """A body by the word for its kind and its number, or its letter in prose."""
    kind = _KINDS.get(word)
    if kind is None:
        return Message("solution.other-body", name=f"{word} {number}")
    return Message(f"solution.numbered-{kind}", number=number)


def name_barely(word: str) -> Text:
    """The word for a kind of body without an article."""
    kind = _KINDS.get(word)
    return Message(f"solution.bare-{kind}") if kind else word
