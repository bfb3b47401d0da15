"""Two chains to one point, whose place is differentiated twice: what velocities add to
accelerations goes by the velocities of the points themselves.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import sqrt

from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Part, VectorEquation, write_vector_equation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, Multiplier, gather
from kinegrade.worked.checks.check import Check
from kinegrade.worked.checks.forms import Told
from kinegrade.worked.checks.multiplied import Multiplied, TermSide
from kinegrade.worked.checks.positions.conditions import Condition
from kinegrade.worked.checks.shares import Shares
from kinegrade.worked.findings import Form, Moved
from kinegrade.worked.formulas.atoms import TWO, ZERO
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.facts import make_key

_NOTHING = Told((), ())  # which rates drop out says nothing where velocities count by themselves


@dataclass(frozen=True)
class Ends:
    """The terms that lead to a point, and those that lead to the one from which it is seen."""

    point: tuple[Term, ...]
    base: tuple[Term, ...]

    @property
    def signed(self) -> Iterator[tuple[int, tuple[Term, ...]]]:
        """Both, with their signs in the vector from the base to the point."""
        yield 1, self.point
        yield -1, self.base

    @property
    def side(self) -> TermSide:
        """The side of a check on which the acceleration of the point stands, less the base's."""
        return TermSide(self.point, without=self.base)


@dataclass(frozen=True)
class Twice:
    """A vector equation of accelerations whose constraint is differentiated twice."""

    equation: VectorEquation
    case: Case

    @cached_property
    def shares(self) -> Shares:
        """What its terms amount to."""
        return Shares(self.equation, self.case)

    @cached_property
    def _velocities(self) -> Multiplied:
        """What the same terms amount to in velocities, by the symbols that have been given."""
        motion, relation = self.case.motion, self.equation.relation
        slow = write_vector_equation(relation, motion, frozenset(motion.rates), "velocity")
        left, right = (tuple(filter(self._is_unnamed, side)) for side in (slow.left, slow.right))
        named = replace(slow, left=left, right=right)
        return Multiplied(named, Shares(named, self.case), self.case, _NOTHING)

    def _is_unnamed(self, part: Part) -> bool:
        """Whether no velocity of its own has been found."""
        found = part.term and make_key((part.term,), "velocity") in self.case.findings.facts
        return part.role == "relative" or not found

    @property
    def chains(self) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """The terms of either side."""
        return tuple(self.equation.relation.left), tuple(self.equation.relation.right)

    def find_velocity(self, ends: Ends) -> Vector:
        """The velocity of the point, less that of the base."""
        rates = self.case.motion.rates
        first, second = (
            add_vectors(term.velocity(rates) for term in terms) if terms else Vector(0, 0)
            for _, terms in ends.signed
        )
        return first - second

    def list_velocities(self, ends: Ends, by: Multiplier) -> list[Amount] | None:
        """The shares of that velocity; None where one is not on the page."""
        found: list[Amount] = []
        for sign, terms in ends.signed:
            shares = self._velocities.list_shares(terms, by)
            if shares is None:
                return None
            found += (one.signed(sign) for one in shares if one.numbers != ZERO)
        return found

    def _list_moved(self, ends: Ends) -> Form:
        """The velocities that count in it, as the letters have them: where they cancel, too."""
        return {
            Moved(term.rate): sqrt(double(term.coefficient().squared()))
            for _, terms in ends.signed
            for term in terms
        }

    def double_omega(self, turn: Term, shares: list[Amount]) -> list[Amount]:
        """Twice the angular velocity of a body, times a sum."""
        omega = measure(self.case.motion.rates[turn.rate], "rad/s")
        twice = Amount(TWO * self.case.naming.omega(turn.rate.body), TWO.dot(omega))
        return gather(twice, shares) if shares else []

    def list_turned(self, turn: Term, products: tuple[Amount, ...]) -> list[Amount]:
        """The angular acceleration of a body, times a sum; nothing where there is none."""
        alpha = self.case.rates("acceleration")[turn.rate]
        if not double(alpha):
            return []
        letters = self.case.naming.turning(turn.rate.body, "acceleration")
        return gather(Amount(letters, measure(alpha, "rad/s^2")), products)

    def compare(
        self, condition: Condition, ends: Ends, other: TermSide, by: Multiplier
    ) -> Iterator[Check]:
        """The check of both sides, that of the ends and the other one."""
        product = Multiplied(self.equation, self.shares, self.case, _NOTHING)
        for check in product.compare(condition.way, ends.side, other, by):
            form = {**check.form, **self._list_moved(ends)}
            yield replace(check, form=form, conditions=condition.formulas)
