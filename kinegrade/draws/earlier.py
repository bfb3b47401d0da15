"""What earlier exams dealt of a question, and is not to be dealt again."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from math import prod

from kinegrade.draws.deck import Combination, Deck
from kinegrade.errors import ExpressionError
from kinegrade.problem.needs import find_needs
from kinegrade.problem.template.domain import find_digits
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class EarlierDraws:
    """Values of the `givens` that stand on papers of earlier exams, each in the order of the
    givens: another value of a given that no student reads does not make other numbers.
    """

    givens: tuple[str, ...] = ()
    values: frozenset[tuple[str, ...]] = frozenset()

    def has(self, combination: Combination) -> bool:
        """Whether an earlier exam dealt a combination."""
        return bool(self.values) and self._select(combination) in self.values

    def count(self, deck: Deck) -> int:
        """How many combinations of a deck that excludes."""
        others = (len(choices) for name, choices in deck.domains.items() if name not in self.givens)
        return len(self.values) * prod(others)

    def _select(self, combination: Combination) -> tuple[str, ...]:
        return tuple(combination[name] for name in self.givens)


NONE_EARLIER = EarlierDraws()


def find_earlier_draws(
    template: Template, asks: Iterable[str], deck: Deck, earlier: Iterable[Mapping[str, str]]
) -> EarlierDraws:
    """What of a deck `earlier` papers with questions of that template have had, by the givens that
    these asks need.
    """
    needed = find_needs(template, asks).givens
    givens = tuple(name for name in deck.domains if name in needed)
    found = (_find_choices(values, givens, deck) for values in earlier)
    return EarlierDraws(givens, frozenset(values for values in found if values is not None))


def _find_choices(
    values: Mapping[str, str], givens: tuple[str, ...], deck: Deck
) -> tuple[str, ...] | None:
    """The choices of a deck that are those values; None where its domains do not hold one."""
    found = tuple(
        find_choice(values[name], deck.domains[name]) for name in givens if name in values
    )
    complete = tuple(choice for choice in found if choice is not None)
    return complete if len(complete) == len(givens) else None


def find_choice(text: str, choices: tuple[str, ...]) -> str | None:
    """The choice that is a number, in this form or in another; None where none is."""
    if text in choices:
        return text
    with suppress(ExpressionError):
        number = find_digits(text)
        return next((choice for choice in choices if find_digits(choice) == number), None)
    return None
