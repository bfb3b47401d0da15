"""What the Typst compiler says of a source, as faults."""

from __future__ import annotations

import re

import typst

from kinegrade.errors import Problem
from kinegrade.language.message import Fault, Location, Message
from kinegrade.press.protocol import unprintable_character

_BOX = re.compile(r'the text `"(.*?)"` could not be displayed')
_ESCAPE = re.compile(r"\\u\{([0-9a-f]+)\}")


def find_boxed(error: typst.TypstError) -> list[str]:
    """The texts that would print as boxes, as the compiler quotes them."""
    quoted = _BOX.findall(error.diagnostic)
    return [_ESCAPE.sub(lambda match: chr(int(match[1], 16)), text) for text in quoted]


def explain(error: typst.TypstError, where: Location) -> tuple[Problem, ...]:
    """The faults of a source: the characters that no font prints, else what cannot be set."""
    boxed = dict.fromkeys("".join(find_boxed(error)))
    if not boxed:
        return (
            Fault(where, error.message, Message("typesetting.math"), Message("typesetting.fix")),
        )
    return tuple(unprintable_character(where, character) for character in boxed)
