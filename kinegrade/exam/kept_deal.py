"""What an exam folder says was dealt: whoever has a paper keeps its numbers, although another
version of kinegrade, or another bank, would deal others to the same place.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from kinegrade.errors import ExpressionError
from kinegrade.problem.deal import Deal
from kinegrade.problem.deck import Combination, Deck
from kinegrade.problem.domain import digits


def dealt_values(
    deck: Deck, deal: Deal, places: Mapping[str, int], stated: Mapping[str, Mapping[str, str]]
) -> dict[str, Combination]:
    """What each student, or version, gets of a question, by the places; `stated` is what some have
    already.

    Those keep it as long as it is in the deck's domains. If that is not what their places would
    get, the others get what nobody has, while it lasts.
    """
    dealt = {whose: deck.combination(deal.position(place)) for whose, place in places.items()}
    kept = {
        whose: values
        for whose, texts in stated.items()
        if whose in dealt and (values := _combination(deck, texts)) is not None
    }
    if all(dealt[whose] == values for whose, values in kept.items()):
        return dealt
    taken = {tuple(values.values()) for values in kept.values()}
    good = (deck.combination(deal.position(place)) for place in range(deal.good))
    free = (values for values in good if tuple(values.values()) not in taken)
    return {whose: kept.get(whose) or next(free, values) for whose, values in dealt.items()}


def _combination(deck: Deck, texts: Mapping[str, str]) -> Combination | None:
    """The combination of a deck with these values; None where a domain does not hold one."""
    if texts.keys() != deck.domains.keys():
        return None
    found = {}
    for name, choices in deck.domains.items():
        choice = texts[name] if texts[name] in choices else _equal_choice(texts[name], choices)
        if choice is None:
            return None
        found[name] = choice
    return found


def _equal_choice(text: str, choices: tuple[str, ...]) -> str | None:
    """The choice that is the same number in another form."""
    with suppress(ExpressionError):
        number = digits(text)
        return next((choice for choice in choices if digits(choice) == number), None)
    return None
