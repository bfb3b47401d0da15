"""What the terms of a vector equation amount to when it is multiplied by a vector that is given by
coordinates: each rotation by its rate and the coordinates of its points, so that no angle is
needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, Multiplier, gather
from kinegrade.worked.checks.arms import point_from_base
from kinegrade.worked.checks.relative_shares import list_relative_shares
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.measures import double, find_sign
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rolled_motion import state_rolled_radius
from kinegrade.worked.rates.speeds import find_rotation_value
from kinegrade.worked.vectors.components import find_heading, list_component
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS, name_part, name_point_vector


@dataclass(frozen=True)
class Shares:
    """The shares of the terms of an equation in its product with a vector."""

    equation: VectorEquation
    case: Case

    def list_of(self, terms: Iterable[Term], by: Multiplier) -> list[Amount] | None:
        """The shares of terms; None where one of them is not known by what the page has."""
        shares: list[Amount] = []
        for term in terms:
            found = self._list_one(term, by)
            if found is None:
                return None
            shares += found
        return shares

    def _list_one(self, term: Term, by: Multiplier) -> list[Amount] | None:
        match term.kind:
            case "rotation":
                return self._list_rotating(term, by)
            case "sliding" | "arc" if self._is_carried(term):
                return list_relative_shares(term, by, self.equation, self.case)
            case "sliding":
                return self._list_sliding(term, by)
            case "arc":
                return None
            case _:
                assert_never(term.kind)

    def _is_carried(self, term: Term) -> bool:
        """Whether a point moves relative to a frame that turns."""
        return term.frame != GROUND and term.frame not in self.case.translating

    def measure(self, terms: Sequence[Term], by: Multiplier) -> float:
        """What they amount to."""
        return sum(double(by.vector.dot(self.find_vector(term))) for term in terms)

    def find_vector(self, term: Term) -> Vector:
        """The vector of a term."""
        motion = self.case.motion
        match self.equation.level:
            case "velocity":
                return term.velocity(motion.rates)
            case "acceleration":
                return term.acceleration(motion.rates, motion.changes)
            case _:
                assert_never(self.equation.level)

    def _list_rotating(self, term: Term, by: Multiplier) -> list[Amount] | None:
        """m . (omega x r), and what the normal acceleration adds."""
        level, case = self.equation.level, self.case
        rate = case.rates(level)[term.rate]
        arm = point_from_base(term, case)
        found: list[Amount] = []
        if double(rate):
            if case.findings.spares(term.rate, level):
                return None
            letters = case.naming.turning(term.rate.body, level)
            turning = Amount(letters, measure(rate, UNITS[level, True]))
            found += gather(turning, tuple(by.dot(arm.turned().pair)))
        omega = case.motion.rates[term.rate]
        if level == "acceleration" and double(omega):
            square = Amount(
                case.naming.omega(term.rate.body) ** TWO, measure(omega, "rad/s") ** TWO
            )
            found += (one.signed(-1) for one in gather(square, tuple(by.dot(arm.pair))))
        return found

    def _list_sliding(self, term: Term, by: Multiplier) -> list[Amount] | None:
        """The share of a vector along a path that does not turn, by its components."""
        if not double(by.vector.dot(self.find_vector(term))):
            return []
        if self._is_spared(term):
            return self._list_rolling(term, by)
        fact = self.find_fact(term)
        if fact is None or any(find_heading(piece, self.case) is None for piece in fact.parts):
            return None
        components: dict[AxisName, Amount] = {}
        for axis in by.pair:
            shares = [one for one in list_component(fact, axis, self.case) if one.counts]
            if len(shares) > 1:
                return None
            for one in shares:
                sign = {"+": 1, "-": -1}[one.sign]
                plain = replace(one, sign="+")
                components[axis] = Amount(plain.in_symbols, plain.in_numbers, sign)
        return list(by.dot(components))

    def _list_rolling(self, term: Term, by: Multiplier) -> list[Amount] | None:
        """The share of a wheel's centre along an axis by the rotation, r omega; None for any other
        point whose speed nobody needs.
        """
        case, level, vector = self.case, self.equation.level, self.find_vector(term)
        for relation in case.motion.frames.relations:
            roll = find_rolling(relation.source)
            if roll is None or roll.of != GROUND or roll.circle.centre != term.point:
                continue
            rate = find_rotation_value(roll.body, case, level)
            turning = Amount(
                case.naming.turning(roll.body, level), measure(rate, UNITS[level, True])
            )
            arm = Amount(state_rolled_radius(roll, case), measure(roll.circle.radius, "m"))
            for axis, place in PLACES.items():
                if not double(vector[1 - place]):
                    sign = find_sign(vector[place]) * find_sign(rate)
                    return list(by.dot({axis: arm.times(turning).signed(sign)}))
        return None

    def _is_spared(self, term: Term) -> bool:
        return self.case.findings.spares(term.rate, self.equation.level)

    def find_fact(self, term: Term) -> Fact | None:
        """What has been found of a sliding motion; None where nothing has."""
        level = self.equation.level
        if self._is_spared(term):
            return None
        part = next((one for one in self.equation.parts if _is_of(one, term)), None)
        if part is None:
            return self.case.findings.facts.get(make_key((term,), level))
        given = part.role == "absolute" and part.unknown is None
        symbol = (
            name_point_vector(term.point, level, self.case)
            if given
            else name_part(self.equation, part, self.case)
        )
        positive = find_positive_sense(term, self.case, level)
        return Fact(symbol, part.value, False, (Piece(symbol, positive, part.value, term),))


def _is_of(part: Part, term: Term) -> bool:
    return part.term == term and part.role in ("absolute", "transport", "relative")
