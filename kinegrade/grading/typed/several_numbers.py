"""Whether another number stands behind the first one of an answer: `3, 4`, `3 or 4`."""

from __future__ import annotations

import re

_NEXT_NUMBER = re.compile(r"[\s.,;'\u3001~=\u2248]*(?:[+-]\s*)?\(?\s*[0-9]")
_OTHER_NUMBER = re.compile(
    r"(?:^|\s)(?:[^\W\d_]+\.?\s+|[\u4e00-\u9fff]+\s*|[|&]\s*)[+-]?[0-9]"
)  # behind a word: 3 or 4
_SHARE_OF_TIME = re.compile(r"\s*1\s*/\s*[^\W\d]|\s*\(\s*1\s*/")


def begins_with_number(rest: str) -> bool:
    """Whether what stands behind a number begins with another one; 1/s is a unit."""
    return _NEXT_NUMBER.match(rest) is not None and _SHARE_OF_TIME.match(rest) is None


def has_other_number(rest: str) -> bool:
    """Whether another number stands somewhere in it behind a word.

    >>> has_other_number(" or 4"), has_other_number(" m/s^2")
    (True, False)
    """
    return _OTHER_NUMBER.search(rest) is not None
