"""The flaws that figures of some templates still have, each with the reason; the list only shrinks.

The proof passes over these alone; whoever removes the cause removes the line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class KnownFlaw:
    """How the flaw of a letter is told at first, and its reason."""

    begins: str
    reason: str


KNOWN: Mapping[str, KnownFlaw] = {
    "pose-four-bar-coupler": KnownFlaw(
        "x2 does not start at its origin", "a bold bar would hide its head"
    ),
    "ring-gear-planet-relative-spin": KnownFlaw("O2 far from its point", "the planet is small"),
}


def drop_known(template: str, flaws: list[str]) -> list[str]:
    """The flaws that are not known of a template."""
    known = KNOWN.get(template)
    return [flaw for flaw in flaws if known is None or not flaw.startswith(known.begins)]
