"""Dimensions: the powers of length and time that a unit has, and a quantity must have; angles are
pure numbers.
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct

from kinegrade.language.message import Message
from kinegrade.numbers.units import Unit, read_unit


class Dimension(Struct, frozen=True):
    """Powers of length and time; a root makes halves of them."""

    length: Fraction
    time: Fraction

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.length + other.length, self.time + other.time)

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(self.length - other.length, self.time - other.time)

    def __pow__(self, exponent: Fraction) -> Dimension:
        return Dimension(self.length * exponent, self.time * exponent)

    @property
    def unit(self) -> str:
        """The unit in SI: "m/s^2"; rates count radians.

        >>> SPEED.unit, RATE.unit, (SPEED * SPEED).unit
        ('m/s', 'rad/s', 'm^2/s^2')
        """
        if self == NUMBER:
            return "1"
        over = [_write_power("m", self.length)] if self.length > 0 else []
        over += [_write_power("s", self.time)] if self.time > 0 else []
        under = [_write_power("m", -self.length)] if self.length < 0 else []
        under += [_write_power("s", -self.time)] if self.time < 0 else []
        plain = "rad" if under == [_write_power("s", -self.time)] else "1"
        return "/".join(["*".join(over) or plain, *under])


def _write_power(unit: str, power: Fraction) -> str:
    """A unit to a positive power."""
    return unit if power == 1 else f"{unit}^{power}"


def _make_dimension(length: int, time: int) -> Dimension:
    """The dimension of these powers."""
    return Dimension(Fraction(length), Fraction(time))


def find_dimension(unit: Unit) -> Dimension:
    """The dimension of a unit; radians and degrees are pure numbers."""
    return _make_dimension(unit.length, unit.time)


def find_si_unit(unit: Unit) -> Unit:
    """The unit in SI of the same kind of quantity; degrees stay.

    >>> find_si_unit(read_unit("km/h")).text, find_si_unit(read_unit("rpm")).text
    ('m/s', 'rad/s')
    """
    return unit if unit.is_si else read_unit(find_dimension(unit).unit)


NUMBER = _make_dimension(0, 0)
LENGTH = _make_dimension(1, 0)
SPEED = _make_dimension(1, -1)
ACCELERATION = _make_dimension(1, -2)
RATE = _make_dimension(0, -1)
CHANGE = _make_dimension(0, -2)
_NAMES = {
    NUMBER: Message("template.dimension-number"),
    LENGTH: Message("template.dimension-length"),
    _make_dimension(0, 1): Message("template.dimension-time"),
    SPEED: Message("template.dimension-velocity"),
    ACCELERATION: Message("template.dimension-acceleration"),
    RATE: Message("template.dimension-rate"),
    CHANGE: Message("template.dimension-change"),
}


def describe_dimension(dimension: Dimension) -> Message:
    """A dimension for a message."""
    return _NAMES.get(dimension) or Message("template.dimension-other", unit=dimension.unit)
