"""What an exam folder records as dealt: a student who has a paper keeps its numbers, even if
another version of kinegrade, or another bank, would deal others to the same place.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from kinegrade.draws.deal import Deal
from kinegrade.draws.deck import Combination, Deck
from kinegrade.errors import ExpressionError
from kinegrade.problem.template.domain import find_digits


def deal_values(
    deck: Deck, deal: Deal, places: Mapping[str, int], stated: Mapping[str, Mapping[str, str]]
) -> dict[str, Combination]:
    """The values that each student, or version, gets for a question, by place; `stated` holds those
    that some have already.

    Those keep them as long as they are in the deck's domains. If these are not what their places
    would get, the others get combinations that no one has yet, while these last.
    """
    dealt = {whose: deck.combination(deal.position(place)) for whose, place in places.items()}
    kept = {
        whose: values
        for whose, texts in stated.items()
        if whose in dealt and (values := _find_combination(deck, texts)) is not None
    }
    if all(dealt[whose] == values for whose, values in kept.items()):
        return dealt
    taken = {tuple(values.values()) for values in kept.values()}
    good = (deck.combination(deal.position(place)) for place in range(deal.good))
    free = (values for values in good if tuple(values.values()) not in taken)
    return {whose: kept.get(whose) or next(free, values) for whose, values in dealt.items()}


def _find_combination(deck: Deck, texts: Mapping[str, str]) -> Combination | None:
    """The combination of a deck with these values; None where a domain does not hold one."""
    if texts.keys() != deck.domains.keys():
        return None
    found = {}
    for name, choices in deck.domains.items():
        choice = texts[name] if texts[name] in choices else _find_equal_choice(texts[name], choices)
        if choice is None:
            return None
        found[name] = choice
    return found


def _find_equal_choice(text: str, choices: tuple[str, ...]) -> str | None:
    """The choice that is the same number in another form."""
    with suppress(ExpressionError):
        number = find_digits(text)
        return next((choice for choice in choices if find_digits(choice) == number), None)
    return None
