"""What is said of expressions that cannot be read or have no value."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping

from kinegrade.errors import suggest
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.numbers.refusals import NegativeRoot, NoDirection

_DEGREES = Message("expression.degrees")
_PRODUCT = Message("expression.product")
# What is expected in place of a character that the grammar does not have.
SLIPS: Mapping[str, Text] = {
    "°": _DEGREES,
    "º": _DEGREES,
    "^": Message("expression.power"),
    "π": "pi",
    "−": Message("expression.minus"),
    "·": _PRODUCT,
    "×": _PRODUCT,
    "²": Message("expression.square"),
    "³": Message("expression.cube"),
    "√": Message("expression.root"),
}


def spell_greek(token: str) -> Message | None:
    """What is expected in place of a Greek letter: its name; None for any other token.

    >>> spell_greek("φ"), spell_greek("f")
    (Message('expression.greek', name='phi'), None)
    """
    named = re.fullmatch(
        r"GREEK (?:SMALL|CAPITAL) LETTER (\w+)", unicodedata.name(token[:1] or " ", "")
    )
    return Message("expression.greek", name=named[1].lower()) if named else None


def explain_unknown_name(name: str, known: Iterable[str]) -> Message:
    """What is said of a name that stands for nothing."""
    return Message("expression.unknown-name", name=Quoted(name), hint=suggest(name, known))


def explain_unknown_function(name: str, known: Iterable[str]) -> Message:
    """What is said of a function that there is not."""
    return Message("expression.unknown-function", name=Quoted(name), hint=suggest(name, known))


def explain_no_value(error: ValueError) -> Message:
    """Why a function has no value."""
    match error:
        case NegativeRoot():
            return Message("expression.negative-root")
        case NoDirection():
            return Message("expression.no-direction")
        case _:  # Python's and the libraries' errors
            return Message("expression.undefined")
