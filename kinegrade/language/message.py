"""What is to be said, free of any language: the key of a catalogue's entry and what fills its
places.

`kinegrade.language.catalogue` writes it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Literal, TypeAlias

from kinegrade.language import Language

Joint = Literal["and", "or", "comma", "semicolon"]


class Message:
    """An entry of the catalogues and its parts, by the names of their places.

    A part may be a text as it stands (a name, a path, what a file holds), a number, or something
    to be said itself. The part `count`, a number, chooses between singular and plural.

    >>> Message("grammar.expected", expected="a number")
    Message('grammar.expected', expected='a number')
    """

    __slots__ = ("key", "parts")

    key: str
    parts: Mapping[str, Part]

    def __init__(self, key: str, /, **parts: Part) -> None:
        self.key = key
        self.parts = parts

    def __reduce__(self) -> tuple[Callable[..., Message], tuple[str, Mapping[str, Part]]]:
        return _restore, (self.key, self.parts)

    def __repr__(self) -> str:
        parts = "".join(f", {name}={part!r}" for name, part in self.parts.items())
        return f"Message({self.key!r}{parts})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Message) and self.key == other.key and self.parts == other.parts

    def __hash__(self) -> int:
        return hash((self.key, *self.parts.items()))


def _restore(key: str, parts: Mapping[str, Part]) -> Message:
    return Message(key, **parts)


@dataclass(frozen=True)
class Listing:
    """Several things in one place: all of them ("a, b and c"), one of them ("a, b or c"), or merely
    listed ("a, b, c"; whole statements "a; b; c").
    """

    items: tuple[Part, ...]
    joint: Joint = "comma"


@dataclass(frozen=True)
class Noun:
    """A noun that an author wrote, in all the forms that its language has, in their order."""

    forms: tuple[str, ...]


@dataclass(frozen=True)
class ByLanguage:
    """What is said in other words in some languages; `otherwise` in all others."""

    words: tuple[tuple[Language, Part], ...]
    otherwise: Part


@dataclass(frozen=True)
class Quoted:
    """A name or a cell's text as it stands in a file, in quotation marks."""

    text: str


@dataclass(frozen=True)
class Fault:
    """What is wrong, in one line: where it is, what was found, what was expected, what to do.

    Written "bank.toml:3: points: 0 - expected a number above zero - write points = 1"; what is
    empty is left out.
    """

    where: Text
    what: Text | Fault
    expected: Text = ""
    do: Text = ""


Text: TypeAlias = str | Message
Location: TypeAlias = Text  # where a fault is, as its line begins
Number: TypeAlias = int | Decimal | Fraction
Part: TypeAlias = (
    str | int | Decimal | Fraction | Message | Listing | Noun | ByLanguage | Quoted | Fault
)


def list_all(items: Iterable[Part]) -> Listing:
    """Things that hold together: "a, b and c"."""
    return Listing(tuple(items), "and")


def list_choices(items: Iterable[Part]) -> Listing:
    """Things of which one is chosen: "a, b or c"."""
    return Listing(tuple(items), "or")


def list_plainly(items: Iterable[Part]) -> Listing:
    """Things one after another: "a, b, c"."""
    return Listing(tuple(items), "comma")


def list_first(items: Sequence[Part], most: int) -> Part:
    """The first of many things: "a, b, c and 12 more"."""
    if len(items) <= most:
        return list_plainly(items)
    first = list_plainly(items[:most])
    return Message("grammar.names-and-more", names=first, count=len(items) - most)


def list_statements(items: Iterable[Part]) -> Listing:
    """Statements one after another: "a; b; c"."""
    return Listing(tuple(items), "semicolon")
