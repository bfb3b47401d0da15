"""Names as a press can print them: characters that no font has are written as code points."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from kinegrade.press.protocol import Press
from kinegrade.press.sheet import KeyBook, KeyPaper, Paper, SolutionSheet

_Owned = TypeVar("_Owned", Paper, SolutionSheet, KeyPaper)


def make_legible(name: str, missing: frozenset[str]) -> str:
    """`name` with each character in `missing` written as its code point.

    >>> make_legible("Zoë 😀", frozenset("😀"))
    'Zoë [U+1F600]'
    """
    return "".join(
        f"[U+{ord(character):04X}]" if character in missing else character for character in name
    )


def make_owner_legible(sheet: _Owned, missing: frozenset[str]) -> _Owned:
    """A sheet with each character in `missing` written as its code point in its owner's name and
    id.
    """
    name, student = make_legible(sheet.name, missing), make_legible(sheet.student, missing)
    return replace(sheet, name=name, student=student)


def make_owners_legible(book: KeyBook, press: Press) -> KeyBook:
    """A key with the name and id on each paper as `press` can print them."""
    papers = tuple(book.papers)
    missing = press.unprintable(text for paper in papers for text in (paper.name, paper.student))
    return replace(book, papers=tuple(make_owner_legible(paper, missing) for paper in papers))
