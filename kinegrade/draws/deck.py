"""A question's deck: every combination of its parameters' values once, in the order of a secret."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import prod
from types import MappingProxyType

from kinegrade.draws.keyed_order import KeyedOrder
from kinegrade.problem.template.template import Template

Combination = Mapping[str, str]  # for each parameter a value, as a text in the parameter's unit
_NOTHING: Mapping[str, tuple[str, ...]] = MappingProxyType({})


@dataclass(frozen=True)
class Deck:
    """All combinations of the values in `domains`; `secret` and `question` decide their order."""

    domains: Mapping[str, tuple[str, ...]]
    secret: str = field(repr=False)
    question: str

    @property
    def size(self) -> int:
        """How many combinations there are."""
        return prod(map(len, self.domains.values()))

    def combination(self, position: int) -> Combination:
        """The combination at a position of the order, counted from zero. Raises IndexError."""
        index = self._order.at(position)
        values = {}
        for name, choices in self.domains.items():
            index, place = divmod(index, len(choices))
            values[name] = choices[place]
        return values

    def first(self, count: int) -> list[Combination]:
        """The first combinations of the order, `count` of them, or all where there are no more."""
        return list(self.walk(count))

    def walk(self, count: int) -> Iterator[Combination]:
        """The same one after another, each worked out when it is asked for."""
        return map(self.combination, range(min(count, self.size)))

    @cached_property
    def _order(self) -> KeyedOrder:
        return KeyedOrder(self.secret, self.question, self.size)


def make_deck(
    template: Template,
    secret: str,
    question: str,
    fixed: Mapping[str, tuple[str, ...]] = _NOTHING,
) -> Deck:
    """The deck of a template; `fixed` replaces the domains of some parameters."""
    domains = {
        name: fixed.get(name, parameter.choices) for name, parameter in template.parameters.items()
    }
    return Deck(domains, secret, question)
