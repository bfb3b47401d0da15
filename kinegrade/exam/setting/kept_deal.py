"""What an exam folder records as dealt: a student who has a paper keeps its numbers, even if
another version of kinegrade, or another bank, would deal others to the same place.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.draws.deck import Combination, Deck
from kinegrade.draws.earlier import find_choice

Stated = Mapping[str, Mapping[str, Mapping[str, str]]]  # by paper and question the values it has


def find_kept(deck: Deck, stated: Stated, question: str) -> dict[str, Combination]:
    """The combinations of a question that papers keep: the values stated for them, as long as they
    are in the deck's domains.
    """
    found = {
        paper: _find_combination(deck, drawn[question])
        for paper, drawn in stated.items()
        if question in drawn
    }
    return {paper: values for paper, values in found.items() if values is not None}


def _find_combination(deck: Deck, texts: Mapping[str, str]) -> Combination | None:
    """The combination of a deck with these values; None where a domain does not hold one."""
    if texts.keys() != deck.domains.keys():
        return None
    found = {}
    for name, choices in deck.domains.items():
        choice = find_choice(texts[name], choices)
        if choice is None:
            return None
        found[name] = choice
    return found
