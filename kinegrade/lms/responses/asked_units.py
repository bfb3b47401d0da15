"""The unit in which a question of a Canvas quiz was asked, where it differs from the unit on paper:
the question's text says so.

The quiz says "Mind the unit: mm/s here, not m/s."; a download has the text without its tags, so
exponents are not raised, as in mm/s2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.students.rounding.kept_decimals import list_finer_units

_TAG = re.compile(r"<[^>]*>")
_POWER = re.compile(r"\^(-?\d+)")


def asked_unit(header: str, unit: str) -> str:
    """The unit that a question's text asks for instead of this one; "" where it asks for this one.

    >>> asked_unit("101: Find it: v = ? mm/s Mind the unit: mm/s here, not m/s.", "m/s")
    'mm/s'
    """
    text = " ".join(_TAG.sub("", header).split())
    for finer, factor in list_finer_units(unit):
        if factor > 1 and any(sentence in text for sentence in _sentences(finer, unit)):
            return finer
    return ""


def on_the_line(unit: str) -> str:
    """A unit as `write_unit_html` of the quiz shows it, without its tags.

    It is written here again because `write_unit_html` takes a second to import, which would delay
    every marking.

    >>> on_the_line("m/s^2")
    'm/s2'
    """
    return _POWER.sub(lambda power: power[1].replace("-", "−"), unit).replace("*", "·")


def _sentences(here: str, on_paper: str) -> Iterator[str]:
    """The sentence of the quiz in every language, without its tags."""
    sentence = Message("quiz.changed-unit", here=on_the_line(here), paper=on_the_line(on_paper))
    for language in known_languages():
        yield open_catalogue(language).write(sentence)
