"""What people type before a number: a label (v_B =), and that it is about so much."""

from __future__ import annotations

import re
from functools import cache

from kinegrade.grading.typed.sense import names_sense
from kinegrade.language.message import Message
from kinegrade.language.spellings import match_spellings

_NO_LABEL = r"(?!sqrt|pi\b|\u03c0\s*=)"
_LABEL = re.compile(
    rf"\|?{_NO_LABEL}[^\W\d][\w'\u2032^{{}}()|\\, ]{{0,30}}(?:[=\u2248]|:(?!=))\s*|=\s*",
    re.IGNORECASE,
)
_ABOUT = r"[\u2248~\u2243\u2245\u223c]"


def undress(text: str) -> str:
    """The text without a label before the number (v_B =) and without a word for "about"; a sense
    (clockwise: 5) is no label.
    """
    label = _LABEL.match(text)
    unlabelled = text[label.end() :] if label and not names_sense(label[0]) else text
    about = _match_about().match(unlabelled)
    return (unlabelled[about.end() :] if about else unlabelled).strip()


@cache
def _match_about() -> re.Pattern[str]:
    """A sign or a word for "about" in any language, the longest of those that begin alike."""
    words = match_spellings(Message("marking.about"))
    return re.compile(rf"(?:{_ABOUT}|{words})\s*", re.IGNORECASE)
