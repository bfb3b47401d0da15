"""What the checks of a page go by."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.worked.document import Block, Prose

_ANY = "体"  # stands for any words: a Chinese sentence has no space beside it
_PROJECTIONS = (
    Message("solution.check-projection", axis=_ANY),
    Message("solution.equation-projected", point=_ANY, axis=_ANY),
)


def find_projected_again(blocks: Sequence[Block]) -> Iterator[str]:
    """The checks that project a vector equation once more, which tests the arithmetic alone."""
    ways = [_make_pattern(way, language) for language in known_languages() for way in _PROJECTIONS]
    for block in blocks:
        if isinstance(block, Prose) and any(way.fullmatch(block.text) for way in ways):
            yield block.text


def _make_pattern(way: Message, language: str) -> re.Pattern[str]:
    message = Message("solution.check", way=way, left=_ANY, right=_ANY)
    return re.compile(re.escape(write_sentence(message, language)).replace(_ANY, ".*"))
