"""Exact numbers with pi in them: a rational or a surd times a power of pi.

A drive of 100 r/min turns with 10 pi/3 rad/s, so velocities are multiples of pi and accelerations
of its square. Pi is transcendental: multiples of different powers never cancel, and none is zero.
A sum of different powers has no place here and raises `Inexact`; balls hold it.
"""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq

from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import Real, Surd, enclose, enclose_at_precision, height, sign


class PiMultiple:
    """coefficient * pi**power, neither of them zero. Supports + - * / **, comparison and sign with
    rationals, surds and its own kind.

    >>> from flint import fmpq
    >>> rate = PiMultiple(fmpq(10, 3), 1)
    >>> rate * rate, rate / rate, rate * 0
    (PiMultiple(100/9, 2), 1, 0)
    """

    __slots__ = ("coefficient", "power")

    def __init__(self, coefficient: Real, power: int) -> None:
        self.coefficient, self.power = coefficient, power

    def __add__(self, other: Real) -> Real:
        coefficient, power = split_pi(other)
        if coefficient == 0:
            return self
        if power != self.power:
            raise Inexact  # a sum of different powers of pi
        return multiply_by_pi(self.coefficient + coefficient, power)

    __radd__ = __add__

    def __neg__(self) -> PiMultiple:
        return PiMultiple(-self.coefficient, self.power)

    def __sub__(self, other: Real) -> Real:
        return self + (-other)

    def __rsub__(self, other: Real) -> Real:
        return -self + other

    def __mul__(self, other: Real) -> Real:
        coefficient, power = split_pi(other)
        return multiply_by_pi(self.coefficient * coefficient, self.power + power)

    __rmul__ = __mul__

    def __truediv__(self, other: Real) -> Real:
        coefficient, power = split_pi(other)
        return multiply_by_pi(self.coefficient / coefficient, self.power - power)

    def __rtruediv__(self, other: Real) -> Real:
        return multiply_by_pi(other / self.coefficient, -self.power)

    def __pow__(self, exponent: int) -> Real:
        return multiply_by_pi(self.coefficient**exponent, self.power * exponent)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, PiMultiple):
            return NotImplemented
        return self.power == other.power and bool(self.coefficient == other.coefficient)

    def __hash__(self) -> int:
        return hash((self.coefficient, self.power))

    def __lt__(self, other: Real) -> bool:
        return self._compare(other) < 0

    def __gt__(self, other: Real) -> bool:
        return self._compare(other) > 0

    def __le__(self, other: Real) -> bool:
        return self._compare(other) <= 0

    def __ge__(self, other: Real) -> bool:
        return self._compare(other) >= 0

    def _compare(self, other: Real) -> int:
        """The sign of the difference; different powers are compared as balls, which part them."""
        try:
            return sign(self - other)
        except Inexact:
            return _part(self, other)

    def __abs__(self) -> PiMultiple:
        return PiMultiple(abs(self.coefficient), self.power)

    def __float__(self) -> float:
        return float(enclose(self, 96))

    def __repr__(self) -> str:
        return f"PiMultiple({self.coefficient}, {self.power})"

    def ball(self) -> Any:
        """The number as an enclosure at the working precision."""
        return enclose_at_precision(self.coefficient) * arb.pi() ** self.power

    def sign(self) -> int:
        """-1 or 1."""
        return sign(self.coefficient)

    def height(self) -> int:
        """The bits of the longest numerator or denominator in the coefficient."""
        return height(self.coefficient)


def multiply_by_pi(coefficient: Real, power: int) -> Real:
    """coefficient * pi**power in its one form, without pi where the power or the number is zero.

    >>> from flint import fmpq
    >>> multiply_by_pi(fmpq(1, 2), 0), multiply_by_pi(fmpq(1, 2), 1)
    (1/2, PiMultiple(1/2, 1))
    """
    return PiMultiple(coefficient, power) if power and coefficient != 0 else coefficient


def split_pi(number: Real) -> tuple[Real, int]:
    """A number as a coefficient and the power of pi it is multiplied by, pi as an angle included.

    Raises Inexact for an angle that is no rational part of a turn.
    """
    if isinstance(number, (Surd, fmpq, int)):
        return number, 0
    multiple = number if isinstance(number, PiMultiple) else number.as_number()
    return (multiple.coefficient, multiple.power) if multiple != 0 else (multiple, 0)


def _part(first: Real, second: Real) -> int:
    """The sign of first - second, two numbers that cannot be equal."""
    precision = 64
    while True:
        difference = enclose(first, precision) - enclose(second, precision)
        if 0 not in difference:
            return 1 if difference > 0 else -1
        precision *= 2
