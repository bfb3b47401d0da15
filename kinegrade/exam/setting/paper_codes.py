"""The codes printed on papers, which identify a paper that has lost its name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import count
from types import MappingProxyType

from kinegrade.draws.keyed_order import address

_NONE: Mapping[str, str] = MappingProxyType({})
LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # without I, L, O, U, which are easily misread


def make_paper_codes(
    secret: str, students: Iterable[str], kept: Mapping[str, str] = _NONE
) -> dict[str, str]:
    """The code of each paper, no two alike; `students` come in the order of their places, and where
    two codes would be alike, the later student gets another. `kept` are codes that exist already.
    """
    codes = dict(kept)
    taken = set(kept.values())
    for student in students:
        if student in kept:
            continue
        attempts = (make_paper_code(secret, student, attempt) for attempt in count())
        codes[student] = next(code for code in attempts if code not in taken)
        taken.add(codes[student])
    return codes


def make_paper_code(secret: str, student: str, attempt: int = 0) -> str:
    """The code of a student's paper, like K7Q2-9FHM: 40 bits of the secret for codes and the
    student's id.
    """
    further = (attempt,) if attempt else ()
    number = address(secret, "paper", student, *further)
    text = "".join(LETTERS[number >> 5 * place & 31] for place in range(8))
    return f"{text[:4]}-{text[4:]}"
