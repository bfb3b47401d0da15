"""A vector equation multiplied by a vector: both sides by what the page has found, and compared."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from kinegrade.language.message import Message
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, Multiplier, add_letters, add_numbers
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import Told, multiply_relation
from kinegrade.worked.checks.shares import Shares
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES, ZERO
from kinegrade.worked.formulas.measures import size
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import (
    UNITS,
)


@dataclass(frozen=True)
class TermSide:
    """The terms of a side, what stands there besides, with its value, and terms taken from it."""

    terms: tuple[Term, ...]
    own: tuple[Amount, ...] = ()
    value: float = 0.0
    without: tuple[Term, ...] = ()


@dataclass(frozen=True)
class Multiplied:
    """The two chains of a vector equation, whose ends are one point; nothing is worked out of what
    is `told`.
    """

    equation: VectorEquation
    shares: Shares
    case: Case
    told: Told

    @property
    def chains(self) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """The terms of either side."""
        relation = self.equation.relation
        return tuple(relation.left), tuple(relation.right)

    def tells(self, by: Vector) -> bool:
        """Whether the equation times a vector says what is not told."""
        return not self.told.says(multiply_relation(self.equation.relation, by))

    def compare(
        self, way: Message, one: TermSide, other: TermSide, by: Multiplier
    ) -> Iterator[Check]:
        """The check of two sides, where it is not told, every share of both is on the page and a
        rotation counts on one of them.
        """
        if not self.tells(by.vector):
            return
        left, right = (self._state(side, by) for side in (one, other))
        if left is None or right is None or not (left.letters or right.letters):
            return
        if left.numbers == right.numbers == ZERO:
            return
        terms = (*one.terms, *other.terms, *other.without)
        largest = size(by.vector) * max(
            (size(self.shares.find_vector(term)) for term in terms), default=0.0
        )
        form = multiply_relation(self.equation.relation, by.vector)
        unit = by.name_unit(self.equation.level)
        yield compare(way, left, right, unit, form=form, largest=largest)

    def _state(self, side: TermSide, by: Multiplier) -> Side | None:
        added, taken = (self.list_shares(terms, by) for terms in (side.terms, side.without))
        if added is None or taken is None:
            return None
        every = (*side.own, *added, *(one.signed(-1) for one in taken))
        value = self.shares.measure(side.terms, by) - self.shares.measure(side.without, by)
        letters = add_letters(every) if every else None
        return Side(add_numbers(every), value + side.value, letters)

    def find_components(self, terms: Sequence[Term]) -> Fact | None:
        """The sum of terms where the page has it by its components."""
        facts, level = self.case.findings.facts, self.equation.level
        fact = facts.get(make_key(tuple(terms), level)) if terms else None
        return fact if fact is not None and fact.by_components else None

    def list_shares(self, terms: Sequence[Term], by: Multiplier) -> list[Amount] | None:
        """The shares of terms: by the components of their sum where the page has these."""
        level, fact = self.equation.level, self.find_components(terms)
        if fact is None:
            return self.shares.list_of(terms, by)
        components = {
            axis: Amount(
                replace(fact.symbol, axis=axis),
                measure(fact.value[PLACES[axis]], UNITS[level, False]),
            )
            for axis in AXES
        }
        return list(by.dot(components))
