"""What key.npz says of itself: by which key and which head it was written, and what its numbers
stand for.

The file is an archive of arrays as numpy writes it, a few for every thousand papers, so that a
class of any size takes the memory of one part; the archive's checksums find damage.
"""

from __future__ import annotations

from fractions import Fraction
from hashlib import file_digest, sha256
from pathlib import Path

import msgspec

from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.folder.stated_keys import Terms
from kinegrade.numbers.tolerance import Tolerance

FORMAT = 1
ABOUT = "about.json"
#: Papers whose arrays stand together.
PART = 1000
ARRAYS = ("centres", "values", "exact", "terms", "ends", "names", "wrong")


class Origin(msgspec.Struct, frozen=True):
    """What arrays were made of: digests of the key, and of the asks and students of the head."""

    format: int
    key: str
    head: str


class AskTerms(msgspec.Struct, frozen=True, array_like=True):
    """The rule and the period of an ask, as fractions."""

    relative: str
    absolute: str
    figures: int | None
    period: str | None


class About(msgspec.Struct, frozen=True):
    """The origin of the arrays, the names of mistakes by their numbers, and by theirs the terms
    that papers have.
    """

    origin: Origin
    papers: int
    mistakes: tuple[str, ...]
    terms: tuple[tuple[AskTerms, ...], ...]


def find_origin(key: Path, head: ExamHead) -> Origin:
    """What arrays would be made of now. Raises OSError where the key cannot be read."""
    asks = [(ask.question, ask.ask, ask.unit, str(ask.points)) for ask in head.asks]
    stated = msgspec.json.encode((asks, list(head.candidates)))
    with key.open("rb") as stream:
        return Origin(FORMAT, file_digest(stream, "sha256").hexdigest(), sha256(stated).hexdigest())


def state_terms(terms: Terms) -> tuple[AskTerms, ...]:
    """The terms of papers as the file states them."""
    return tuple(
        AskTerms(
            str(rule.relative),
            str(rule.absolute),
            rule.figures,
            None if period is None else str(period),
        )
        for rule, period in zip(terms.rules, terms.periods, strict=True)
    )


def read_terms(stated: tuple[AskTerms, ...], head: ExamHead) -> Terms:
    """The terms that the file states. Raises ValueError where they are no fractions."""
    rules = [
        Tolerance(Fraction(each.relative), Fraction(each.absolute), each.figures) for each in stated
    ]
    periods = [None if each.period is None else Fraction(each.period) for each in stated]
    return Terms(head.asks, tuple(rules), tuple(periods))
