"""What messages say, in English: tests compare these texts."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Part


def said(what: Part) -> str:
    """A message in English."""
    return open_catalogue(ENGLISH).write(what)


def all_said(several: Iterable[Part]) -> list[str]:
    """Several messages in English."""
    return list(map(said, several))
