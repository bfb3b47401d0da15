"""In which unit a question of a Canvas quiz was asked, where that is another one than on paper: its
text says so.

The quiz says "Mind the unit: mm/s here, not m/s."; a download carries the text without its tags, so
that exponents stand on the line, as in mm/s2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinegrade.lms.quiz.question_words import WORDS
from kinegrade.problem.kept_decimals import units

_TAG = re.compile(r"<[^>]*>")
_POWER = re.compile(r"\^(-?\d+)")
_NUMBER = re.compile(r"[-+−]?[\d.,\s]*\d[\d.,\s]*(?:[eE][-+−]?\d+)?")


def asked_unit(header: str, unit: str) -> str:
    """The unit that a question's text asks for instead of this one; "" where it asks for this one.

    >>> asked_unit("101: Find it: v = ? mm/s Mind the unit: mm/s here, not m/s.", "m/s")
    'mm/s'
    """
    text = " ".join(_TAG.sub("", header).split())
    for finer, factor in units(unit):
        if factor > 1 and any(sentence in text for sentence in _sentences(finer, unit)):
            return finer
    return ""


def in_unit(typed: str, unit: str) -> str:
    """What was typed as a number in that unit; anything but a bare number stays as it is.

    >>> in_unit("4.25", "mm/s"), in_unit("4.25 m/s", "mm/s"), in_unit("4.25", "")
    ('4.25 mm/s', '4.25 m/s', '4.25')
    """
    return f"{typed} {unit}" if unit and _NUMBER.fullmatch(typed.strip()) else typed


def on_the_line(unit: str) -> str:
    """A unit as `unit_html` of the quiz shows it, without its tags.

    It is written here as well because that one takes a second to import, and every marking would
    wait for it.

    >>> on_the_line("m/s^2")
    'm/s2'
    """
    return _POWER.sub(lambda power: power[1].replace("-", "−"), unit).replace("*", "·")


def _sentences(here: str, on_paper: str) -> Iterator[str]:
    """The sentence of the quiz in every language, as it stands on the line."""
    for words in WORDS.values():
        yield words.changed_unit.format(on_the_line(here), on_the_line(on_paper))
