"""What key.npz says of itself: by which key and which head it was written, and what its numbers
stand for.

The file is an archive of arrays as numpy writes it, a few for every thousand papers, so that a
class of any size takes the memory of one part; the archive's checksums find damage.

That the key is the one that the arrays were made of is known by its digest. Reading a large key for
that takes longer than marking by it, so a key of the size and the time that it had then is believed
to be the same, as version control does. The time is kept as that of the arrays' own file, a certain
moment later, as the content of two like exams is the same; it is not kept where the arrays were
written so soon after the key that a change might bear the same time.
"""

from __future__ import annotations

import os
from fractions import Fraction
from hashlib import file_digest, sha256
from pathlib import Path

import msgspec

from kinegrade.exam.folder.key.stated_keys import Terms
from kinegrade.exam.folder.records import ExamHead
from kinegrade.numbers.tolerance import Tolerance

FORMAT = 1
ABOUT = "about.json"
#: Papers whose arrays stand together.
PART = 1000
# No file system counts time in coarser steps than two seconds
_SETTLED = 2 * 10**9
# In ns: a moment that no copy, and no tool that gives all files one time, gives by chance
_LATER = 123_456_789
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
    that papers have; the key's file has so many bytes, -1 in arrays of earlier versions.
    """

    origin: Origin
    papers: int
    mistakes: tuple[str, ...]
    terms: tuple[tuple[AskTerms, ...], ...]
    key_size: int = -1


def find_origin(key: Path, head: ExamHead) -> Origin:
    """What arrays would be made of now. Raises OSError where the key cannot be read."""
    with key.open("rb") as stream:
        return Origin(FORMAT, file_digest(stream, "sha256").hexdigest(), _digest_head(head))


def keep_time(columns: Path, changed: int) -> None:
    """Keeps with arrays that have just been written when their key was last changed, in ns."""
    if columns.stat().st_mtime_ns - changed > _SETTLED:
        os.utime(columns, ns=(changed + _LATER, changed + _LATER))


def is_current(about: About, columns: Path, key: Path, head: ExamHead) -> bool:
    """Whether arrays in the file `columns` were made of this key and this head. Raises OSError."""
    now, kept = key.stat(), columns.stat().st_mtime_ns
    if now.st_size == about.key_size and kept == now.st_mtime_ns + _LATER:
        return about.origin == Origin(FORMAT, about.origin.key, _digest_head(head))
    return about.origin == find_origin(key, head)


def is_other_key(about: About, key: Path, head: ExamHead) -> bool:
    """Whether arrays were made of another key, whatever its head. Raises OSError."""
    return about.origin.format == FORMAT and about.origin.key != find_origin(key, head).key


def is_of_head(about: About, head: ExamHead) -> bool:
    """Whether arrays were made for this head, whatever its key."""
    return about.origin.format == FORMAT and about.origin.head == _digest_head(head)


def _digest_head(head: ExamHead) -> str:
    asks = [(ask.question, ask.ask, ask.unit, str(ask.points)) for ask in head.asks]
    return sha256(msgspec.json.encode((asks, list(head.candidates)))).hexdigest()


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
