"""Sign conventions as earlier folders keep them: in English words, without a keyword."""

from __future__ import annotations

import re

from kinegrade.sign_conventions import Convention

_WORDS: tuple[tuple[re.Pattern[str], Convention], ...] = (
    (re.compile(r"magnitude\b.*"), "magnitude"),
    (re.compile(r"unsigned|between 0° and 180°"), "unsigned"),
    (re.compile(r"with its sign"), "signed"),
    (re.compile(r"ccw|counter-clockwise positive|positive counter-clockwise\b.*"), "ccw"),
    (re.compile(r"cw|clockwise positive|positive clockwise\b.*"), "cw"),
    (re.compile(r"\+x|positive in the direction of \$\+x\$"), "+x"),
    (re.compile(r"-x|positive in the direction of \$-x\$"), "-x"),
    (re.compile(r"\+y|positive in the direction of \$\+y\$"), "+y"),
    (re.compile(r"-y|positive in the direction of \$-y\$"), "-y"),
)


def recognise_convention(words: object) -> Convention | None:
    """The convention that stands in an ask of an earlier version; None where it is the author's.

    >>> recognise_convention("counter-clockwise positive")
    'ccw'
    """
    text = str(words)
    return next((each for pattern, each in _WORDS if pattern.fullmatch(text)), None)
