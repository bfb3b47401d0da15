"""Quantities in letters and in numbers, and vectors of such components by which an equation is
multiplied.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.formulas.atoms import AXES, ONE, TWO, ZERO, Measured, add_terms
from kinegrade.worked.formulas.formula import Formula, Power, Product
from kinegrade.worked.vectors.vectors import UNITS


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
        if ONE in (self.letters, other.letters):
            return replace(other if self.letters == ONE else self, sign=sign)
        if self.letters == other.letters:
            return self.squared().signed(sign)
        letters, numbers = self.letters * other.letters, self.numbers.dot(other.numbers)
        return Amount(letters, ZERO if ZERO in (self.numbers, other.numbers) else numbers, sign)

    def over(self, other: Amount) -> Amount:
        """The quotient."""
        sign = self.sign * other.sign
        return Amount(self.letters / other.letters, self.numbers / other.numbers, sign)


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
    """A vector by which an equation is multiplied, with its components and its length, None where
    that is not on the page; it counts in metres, or is a unit vector.
    """

    vector: Vector
    pair: Pair
    length: Amount | None = UNIT

    @property
    def is_unit(self) -> bool:
        """Whether it is a unit vector."""
        return self.length == UNIT

    def name_unit(self, level: Level) -> str:
        """The unit of its product with velocities or accelerations."""
        unit = UNITS[level, False]
        return unit if self.is_unit else unit.replace("m", "m^2", 1)

    def turned(self) -> Multiplier:
        """The vector turned through a right angle to the left."""
        places: dict[AxisName, AxisName] = {"y": "x", "x": "y"}
        signs = {"y": -1, "x": 1}
        pair = {places[axis]: one.signed(signs[axis]) for axis, one in self.pair.items()}
        return Multiplier(self.vector.turned(), pair, self.length)

    def dot(self, other: Pair) -> Iterator[Amount]:
        """The products of equal components."""
        return (
            self.pair[axis].times(other[axis])
            for axis in AXES
            if {axis} <= self.pair.keys() & other.keys()
        )


def point_along(axis: AxisName) -> Multiplier:
    """The unit vector of an axis."""
    return Multiplier({"x": Vector(1, 0), "y": Vector(0, 1)}[axis], {axis: UNIT})


def _take_unit(product: Amount) -> Formula | None:
    """A product of two lengths without their units, with its sign; None for any other."""
    match product.numbers:
        case Product((Measured(first, "m"), Measured(second, "m"))):
            sign = product.sign * first.sign * second.sign
            return first.size.dot(second.size).signed(sign)
        case Power(Measured(number, "m"), exponent):
            return (number.size**exponent).signed(product.sign)
        case _:
            return None


def _add_areas(lengths: Iterable[Formula | None]) -> Formula:
    """The sum of products of lengths, with its unit; 0 for none."""
    areas = [one for one in lengths if one is not None]
    return Measured(add_terms(areas), "m^2") if areas else ZERO


def gather(rate: Amount, products: Sequence[Amount]) -> list[Amount]:
    """A rate times the sum of products; those of two lengths have their unit once, and the sum
    begins with a plus sign.
    """
    if len(products) < 2:
        return [rate.times(_join(one)) for one in products]
    sign = max(one.sign for one in products)
    turned = sorted((one.signed(sign) for one in products), key=lambda one: -one.sign)
    lengths = [_take_unit(one) for one in turned if one.numbers != ZERO]
    numbers = _add_areas(lengths) if None not in lengths else add_numbers(turned)
    product = ZERO if numbers == ZERO else rate.numbers.dot(numbers)
    return [Amount(rate.letters * add_letters(turned), product, sign)]


def _join(product: Amount) -> Amount:
    """A product of two lengths with one unit; any other as it is."""
    area = _take_unit(product.signed(product.sign))
    return product if area is None else replace(product, numbers=Measured(area, "m^2"))
