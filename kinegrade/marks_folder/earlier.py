"""The known mistakes that lead to an answer, and whether it was compared by a policy's rule, also
where marks.csv of an earlier version says that in its reasons alone, always in English.
"""

from __future__ import annotations

import re

from kinegrade.marks_folder.layout import MISTAKE, NAMES_BETWEEN

_NAME = r"[a-z][a-z0-9]*(?:-[a-z0-9]+)*"
_MISTAKE = re.compile(rf"{_NAME}(?=:|$)")
_BESIDES = re.compile(rf"; so do(?:es)? ({_NAME}(?:, {_NAME})*)$")
_BY_POLICY = " by the policy"


def find_mistakes(verdict: str, listed: str, reason: str) -> tuple[str, ...]:
    """The identifiers of the mistakes that lead to an answer with this verdict, as they are listed
    beside the reason or, by earlier versions, named in it.
    """
    if verdict != MISTAKE:
        return ()
    return tuple(listed.split(NAMES_BETWEEN)) if listed else _find_named_mistakes(reason)


def _find_named_mistakes(reason: str) -> tuple[str, ...]:
    """The identifiers in the reason for a mistake, the likeliest first.

    >>> _find_named_mistakes("coriolis-dropped: leads to 3, allowed 0.03; so does sense-reversed")
    ('coriolis-dropped', 'sense-reversed')
    """
    first, besides = _MISTAKE.match(reason), _BESIDES.search(reason)
    return (first[0], *(besides[1].split(", ") if besides else ())) if first else ()


def names_policy(reason: str) -> bool:
    """Whether a reason ends with a note that the rule was the policy's.

    >>> names_policy("key 1, difference 0.01, allowed 0.02 by the policy")
    True
    """
    return reason.endswith(_BY_POLICY)
