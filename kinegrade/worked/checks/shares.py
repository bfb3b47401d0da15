"""What the terms of a vector equation amount to when it is multiplied by a vector that is given by
coordinates: each rotation by its rate and the coordinates of its points, so that no angle is
needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias, assert_never

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, ONE, TWO, ZERO, AxisName, add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.positions.construction_steps import list_steps
from kinegrade.worked.vectors.components import find_heading, list_component, state_arm
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS, name_part, name_point_vector


@dataclass(frozen=True)
class Amount:
    """A quantity in letters and in numbers, without its sign; 0 in numbers where it vanishes."""

    letters: Formula
    numbers: Formula
    sign: int = 1

    def signed(self, sign: int) -> Amount:
        """The amount, or its opposite where the sign is negative."""
        return replace(self, sign=self.sign * sign)

    def squared(self) -> Amount:
        """The square."""
        return Amount(self.letters**TWO, self.numbers**TWO)

    def times(self, other: Amount) -> Amount:
        """The product; of one the other one alone."""
        sign = self.sign * other.sign
        if self.letters == ONE:
            return other.signed(self.sign)
        if self.letters == other.letters:
            return self.squared().signed(sign)
        letters, numbers = self.letters * other.letters, self.numbers.dot(other.numbers)
        return Amount(letters, ZERO if ZERO in (self.numbers, other.numbers) else numbers, sign)


def add_letters(amounts: Iterable[Amount]) -> Formula:
    """The sum in letters."""
    return add_terms(one.letters.signed(one.sign) for one in amounts)


def add_numbers(amounts: Iterable[Amount]) -> Formula:
    """The sum in numbers, without what vanishes."""
    return add_terms(one.numbers.signed(one.sign) for one in amounts if one.numbers != ZERO)


UNIT = Amount(ONE, ONE)

# The components that are not zero by the choice of the axes
Pair: TypeAlias = Mapping[AxisName, Amount]


@dataclass(frozen=True)
class Multiplier:
    """A vector by which an equation is multiplied, with its components; its length counts in
    metres, or it is a unit vector.
    """

    vector: Vector
    pair: Pair
    is_unit: bool = False

    def name_unit(self, level: Level) -> str:
        """The unit of its product with velocities or accelerations."""
        unit = UNITS[level, False]
        return unit if self.is_unit else unit.replace("m", "m^2", 1)

    def turned(self) -> Multiplier:
        """The vector turned through a right angle to the left."""
        places: dict[AxisName, AxisName] = {"y": "x", "x": "y"}
        signs = {"y": -1, "x": 1}
        pair = {places[axis]: one.signed(signs[axis]) for axis, one in self.pair.items()}
        return Multiplier(self.vector.turned(), pair)

    def dot(self, other: Pair) -> Iterator[Amount]:
        """The products of equal components."""
        return (
            self.pair[axis].times(other[axis])
            for axis in AXES
            if {axis} <= self.pair.keys() & other.keys()
        )


def point_along(axis: AxisName) -> Multiplier:
    """The unit vector of an axis."""
    return Multiplier({"x": Vector(1, 0), "y": Vector(0, 1)}[axis], {axis: UNIT}, is_unit=True)


def point_from_base(term: Term, case: Case) -> Multiplier:
    """The vector of a rotation, from its base to its point."""
    return Multiplier(term.vector, _find_arm(term, case))


def _find_arm(term: Term, case: Case) -> Pair:
    """The coordinates of a rotation's point from its base point."""
    axes = choose_axes(list_steps(case.template))
    components: dict[AxisName, Amount] = {}
    for axis in AXES:
        letters = state_arm(axis, term, axes, case)
        if letters is not None:
            number = _measure_arm(axis, term, letters.sign, case)
            components[axis] = Amount(letters.size, number, letters.sign)
    return components


def _measure_arm(axis: AxisName, term: Term, sign: int, case: Case) -> Formula:
    """The difference of two coordinates, where one of them is zero the other one."""
    before, after = (
        measure(case.motion.points[point][PLACES[axis]], "m") for point in (term.base, term.point)
    )
    if ZERO in (before, after) or before == after:
        return measure(term.vector[PLACES[axis]] * sign, "m")
    return after - before


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
            case "sliding":
                return self._list_sliding(term, by)
            case "arc":
                return None
            case _:
                assert_never(term.kind)

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
        arm = Multiplier(term.vector, _find_arm(term, case))
        found: list[Amount] = []
        if double(rate):
            if case.findings.spares(term.rate, level):
                return None
            letters = case.naming.turning(term.rate.body, level)
            turning = Amount(letters, measure(rate, UNITS[level, True]))
            found += _gather(turning, tuple(by.dot(arm.turned().pair)))
        omega = case.motion.rates[term.rate]
        if level == "acceleration" and double(omega):
            square = Amount(
                case.naming.omega(term.rate.body) ** TWO, measure(omega, "rad/s") ** TWO
            )
            found += (one.signed(-1) for one in _gather(square, tuple(by.dot(arm.pair))))
        return found

    def _list_sliding(self, term: Term, by: Multiplier) -> list[Amount] | None:
        """The share of a vector along a path that does not turn, by its components."""
        if term.frame != GROUND and term.frame not in self.case.translating:
            return None
        if not double(by.vector.dot(self.find_vector(term))):
            return []
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

    def find_fact(self, term: Term) -> Fact | None:
        """What has been found of a sliding motion; None where nothing has."""
        level = self.equation.level
        if self.case.findings.spares(term.rate, level):
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


def _gather(rate: Amount, products: Sequence[Amount]) -> list[Amount]:
    """A rate times the sum of products."""
    if len(products) < 2:
        return [rate.times(one) for one in products]
    numbers = add_numbers(products)
    product = ZERO if numbers == ZERO else rate.numbers.dot(numbers)
    return [Amount(rate.letters * add_letters(products), product)]
