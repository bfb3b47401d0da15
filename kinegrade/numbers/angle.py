"""Exact angles: rational multiples of pi and directions of exact vectors, added, halved and
multiplied.

An angle keeps its components, and its cosine and sine are found only when asked for, so that `pi -
2*phi` or `atan(3/4) + 30 degrees` stay exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from flint import arb, fmpq

from kinegrade.numbers.pi_multiple import multiply_by_pi
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import Real, enclose_at_precision

Direction = tuple[Real, Real]


class RootField(Protocol):
    """A field that takes in the square roots that an angle's cosine and sine need."""

    def sqrt(self, number: Real) -> Real:
        """The positive square root."""

    def sign(self, number: Real) -> int:
        """-1, 0 or 1."""


@dataclass(frozen=True)
class Angle:
    """half_turns*pi plus the sum of factor*(direction of the vector), each direction in (-pi, pi].

    >>> Angle(fmpq(1, 3)) * 2 - Angle(fmpq(1, 6))
    Angle(half_turns=1/2, parts=())
    """

    half_turns: Any
    parts: tuple[tuple[Any, Direction], ...] = ()

    def __add__(self, other: Any) -> Angle:
        if isinstance(other, Angle):
            return Angle(self.half_turns + other.half_turns, _merge(self.parts + other.parts))
        return self if other == 0 else NotImplemented

    __radd__ = __add__

    def __neg__(self) -> Angle:
        return self._times(fmpq(-1))

    def __sub__(self, other: Any) -> Angle:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Angle:
        return (-self).__add__(other)

    def __mul__(self, factor: Any) -> Any:
        if not isinstance(factor, (int, fmpq)):
            return self.as_number() * factor
        return self._times(factor)

    __rmul__ = __mul__

    def _times(self, factor: Any) -> Angle:
        """The angle times a rational number."""
        parts = tuple((share * factor, vector) for share, vector in self.parts)
        return Angle(self.half_turns * factor, _merge(parts))

    def __truediv__(self, divisor: Any) -> Any:
        if not isinstance(divisor, Angle):
            return self * (fmpq(1) / divisor)
        if self.parts or divisor.parts:
            raise Inexact  # the ratio of two angles
        return self.half_turns / divisor.half_turns

    def __rtruediv__(self, number: Any) -> Any:
        return number / self.as_number()

    def __pow__(self, exponent: int) -> Any:
        return self.as_number() ** exponent

    def as_number(self) -> Any:
        """A rational part of a turn as a multiple of pi, which is no angle any more. Raises Inexact
        for an arctangent.
        """
        if self.parts:
            raise Inexact  # an angle times an irrational number
        return multiply_by_pi(self.half_turns, 1)

    def direction(self, field: RootField) -> Direction:
        """(cosine, sine) in `field`; raises Inexact where they lie in no small field."""
        result = _multiple_of_pi(self.half_turns, field)
        for factor, (x, y) in self.parts:
            length = field.sqrt(x * x + y * y)
            result = _compose(result, _power((x / length, y / length), factor, field))
        return result

    def ball(self) -> Any:
        """The angle in radians as an enclosure at the working precision."""
        total = arb.pi() * arb(self.half_turns)
        for factor, (x, y) in self.parts:
            total += arb(factor) * arb.atan2(enclose_at_precision(y), enclose_at_precision(x))
        return total


def _merge(parts: tuple[tuple[Any, Direction], ...]) -> tuple[tuple[Any, Direction], ...]:
    """Parts with equal vectors added up, those with factor zero left out."""
    factors: dict[Direction, Any] = {}
    for factor, vector in parts:
        factors[vector] = factors.get(vector, fmpq(0)) + factor
    return tuple((factor, vector) for vector, factor in factors.items() if factor != 0)


def _compose(first: Direction, second: Direction) -> Direction:
    """The direction of the sum of two angles (complex product)."""
    return first[0] * second[0] - first[1] * second[1], first[0] * second[1] + first[1] * second[0]


def _power(direction: Direction, factor: Any, field: RootField) -> Direction:
    """The direction of `factor` times the angle of `direction`; factors with denominator 1 or 2."""
    if factor.q == 2:
        direction, factor = _halve(direction, field), factor * 2
    if factor.q != 1 or abs(factor) > 12:
        raise Inexact  # a fraction of an angle that has no small field
    if factor < 0:
        direction, factor = (direction[0], -direction[1]), -factor
    result: Direction = (fmpq(1), fmpq(0))
    for _ in range(int(factor)):
        result = _compose(result, direction)
    return result


def _halve(direction: Direction, field: RootField) -> Direction:
    """The direction of half the angle in (-pi, pi] of `direction`."""
    cosine = field.sqrt((1 + direction[0]) / 2)
    sine = field.sqrt((1 - direction[0]) / 2)
    return cosine, -sine if field.sign(direction[1]) < 0 else sine


def _multiple_of_pi(half_turns: Any, field: RootField) -> Direction:
    """(cosine, sine) of half_turns*pi for multiples of 15, 18 and 22.5 degrees; else Inexact."""
    degrees = half_turns * 180
    quarters = int((degrees / 90).floor())
    cosine, sine = _first_quadrant(degrees - 90 * quarters, field)
    for _ in range(quarters % 4):
        cosine, sine = -sine, cosine
    return cosine, sine


def _first_quadrant(degrees: Any, field: RootField) -> Direction:
    """(cosine, sine) of an angle of 0 to 90 degrees."""
    if degrees > 45:
        cosine, sine = _first_quadrant(90 - degrees, field)
        return sine, cosine
    if degrees == 0:
        return fmpq(1), fmpq(0)
    if degrees == 30:
        return field.sqrt(fmpq(3)) / 2, fmpq(1, 2)
    if degrees == 45:
        root = field.sqrt(fmpq(2)) / 2
        return root, root
    if degrees == 15:
        two, six = field.sqrt(fmpq(2)), field.sqrt(fmpq(6))
        return (six + two) / 4, (six - two) / 4
    if degrees in (18, 36):
        five = field.sqrt(fmpq(5))
        short, long = (five - 1) / 4, (five + 1) / 4
        return (
            (field.sqrt(1 - short * short), short)
            if degrees == 18
            else (long, field.sqrt(1 - long * long))
        )
    if degrees * 2 == 45:
        return _halve(_first_quadrant(fmpq(45), field), field)
    raise Inexact  # no square roots of small numbers give its cosine
