"""Certified arithmetic: each number is a ball (`flint.arb`) that encloses the true value.

Used where an instance's values lie in no small exact field (37 degrees, deeply nested radicals).
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import Any

from flint import arb, ctx, fmpq

from kinegrade.numbers.elimination import Contradiction, eliminate
from kinegrade.numbers.number import Magnitude
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import NegativeRoot, NoDirection
from kinegrade.numbers.surd import Surd, enclose_at_precision
from kinegrade.numbers.units import Scale

PRECISIONS = (
    256,
    1024,
    4096,
)  # bits; the first leaves over 40 digits after the cancellation of a usual solve


def is_ball(value: Any) -> bool:
    """Whether a value is an enclosure.

    >>> is_ball(Balls(256).turns(1)), is_ball(fmpq(1))
    (True, False)
    """
    return isinstance(value, arb)


class Undecided(ArithmeticError):
    """A ball contains zero, so that a sign or a pivot is undecided at this precision."""


class Balls(Magnitude):
    """The arithmetic of enclosures at `precision` bits; work inside `context()`."""

    exact = False
    certified = True

    def __init__(self, precision: int) -> None:
        self.precision = precision

    def fork(self) -> Balls:
        """The same arithmetic: balls need no field."""
        return self

    def context(self) -> AbstractContextManager[Any]:
        """Sets flint's working precision for the block."""
        manager: AbstractContextManager[Any] = ctx.workprec(self.precision)
        return manager

    def embed(self, value: Any) -> Any:
        """The same ball: balls need no conversion."""
        return value

    def number(self, rational: Any) -> Any:
        """An enclosure of a rational number or of an exact surd."""
        exact = rational if isinstance(rational, (Surd, PiMultiple)) else fmpq(rational)
        return enclose_at_precision(exact)

    def scale(self, scale: Scale) -> Any:
        """An enclosure of what a unit is in SI."""
        return arb(scale.rational) * arb.pi() ** scale.power

    def turns(self, half_turns: Any) -> Any:
        """The angle of `half_turns` times pi, in radians."""
        return arb.pi() * arb(half_turns)

    def is_zero(self, number: Any) -> bool:
        """Whether a number may be taken for zero: it contains zero and is narrower than half the
        precision.
        """
        value = arb(number)
        if 0 not in value:
            return False
        if value.rad() < arb(2) ** (-self.precision // 2):
            return True
        raise Undecided

    def sign(self, number: Any) -> int:
        """-1, 0 or 1; raises Undecided for a wide ball about zero."""
        if self.is_zero(number):
            return 0
        return 1 if number > 0 else -1

    def choose(self, condition: bool, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`."""
        return yes if condition else no

    def sqrt(self, number: Any) -> Any:
        """The positive square root; zero for a narrow ball about zero; ValueError below zero."""
        side = self.sign(number)
        if side < 0:
            raise NegativeRoot
        return arb(number).sqrt() if side else arb(number).nonnegative_part().sqrt()

    def cos(self, angle: Any) -> Any:
        """Cosine of an angle in radians."""
        return arb(angle).cos()

    def sin(self, angle: Any) -> Any:
        """Sine of an angle in radians."""
        return arb(angle).sin()

    def arctangent(self, y: Any, x: Any) -> Any:
        """The angle from +x to the vector (x, y) in radians; ValueError for the zero vector."""
        if self.is_zero(y):
            if self.is_zero(x):
                raise NoDirection
            return arb(0) if x > 0 else arb.pi()
        return arb.atan2(arb(y), arb(x))

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """As `Field.solve`; raises Undecided where a pivot cannot be distinguished from zero at
        this precision.
        """
        return eliminate([list(map(arb, row)) for row in rows], list(map(arb, right)), self.is_zero)

    def require_zero(self, number: Any) -> None:
        """Raises Contradiction unless the number may be taken for zero."""
        if not self.is_zero(number):
            raise Contradiction
