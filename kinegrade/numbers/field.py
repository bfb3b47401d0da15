"""Exact arithmetic: a field that grows by square roots as an instance needs them.

`Field` is one of the three arithmetics for geometry and the plan; `balls` and `floats` are the
others. It raises `Inexact` where a value lies in no small field, and the caller falls back on
balls.
"""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any

from flint import arb, fmpq

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.elimination import Contradiction, eliminate
from kinegrade.numbers.number import Magnitude
from kinegrade.numbers.pi_multiple import PiMultiple, multiply_by_pi, split_pi
from kinegrade.numbers.refusals import Inexact, NegativeRoot, NoDirection
from kinegrade.numbers.square_roots import denesting, split_radicand, square_root
from kinegrade.numbers.surd import MAX_HEIGHT, Real, Root, Surd, enclose, height, sign
from kinegrade.numbers.units import Scale

MAX_LEVEL = 5  # degree 32: beyond it balls are faster (0.3 ms at level 2, 8 ms at level 5)


class Field(Magnitude):
    """The arithmetic of exact numbers; each square root asked for is adjoined unless the field has
    it.

    >>> field = Field()
    >>> root = field.sqrt(fmpq(3, 4))
    >>> root * root, field.sqrt(4 + 4 * root) == 1 + 2 * root
    (3/4, True)
    """

    exact = True
    certified = True

    def __init__(self, roots: tuple[Root, ...] = ()) -> None:
        self.roots = roots

    def fork(self) -> Field:
        """A field with the same numbers that grows independently: for roots that only one answer
        needs.
        """
        return Field(self.roots)

    def context(self) -> AbstractContextManager[Any]:
        """Nothing to set up while working exactly."""
        return nullcontext()

    def number(self, rational: Any) -> Real:
        """A rational number."""
        return fmpq(rational)

    def scale(self, scale: Scale) -> Real:
        """What a unit is in SI, a rational times a power of pi."""
        return multiply_by_pi(scale.rational, scale.power)

    def turns(self, half_turns: Any) -> Angle:
        """The angle of `half_turns` times pi. Raises Inexact for an irrational number of half
        turns.
        """
        if not isinstance(half_turns, (int, fmpq)):
            raise Inexact  # an irrational part of a turn
        return Angle(fmpq(half_turns))

    def is_zero(self, number: Real) -> bool:
        """Whether a number is zero, decided exactly."""
        return bool(number == 0)

    def sign(self, number: Real) -> int:
        """-1, 0 or 1, decided exactly."""
        return sign(number)

    def choose(self, condition: bool, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`."""
        return yes if condition else no

    def sqrt(self, number: Real) -> Real:
        """The positive square root, adjoined when the field has none.

        Raises ValueError for a negative number, Inexact when the field would become too large.
        """
        if sign(number) < 0:
            raise NegativeRoot
        if isinstance(number, PiMultiple):
            return multiply_by_pi(self.sqrt(number.coefficient), _halve_power(number.power))
        root = square_root(number, self.roots)
        if root is None:
            root = self._adjoin(number)
        return root if sign(root) >= 0 else -root

    def _adjoin(self, number: Real) -> Real:
        if len(self.roots) >= MAX_LEVEL:
            raise Inexact  # the exact field would be too large
        simpler = denesting(number, self.roots)
        if simpler is not None:
            self.sqrt(simpler)
            return self.sqrt(number)
        if height(number) > MAX_HEIGHT:
            raise Inexact  # the root of a number of too many digits
        factor, radicand = split_radicand(number)
        shared = self._shared(radicand)
        if shared is not None:
            return self.sqrt(fmpq(shared.radicand)) * self.sqrt(radicand / shared.radicand) * factor
        root = Root(radicand, len(self.roots) + 1)
        self.roots = (*self.roots, root)
        return Surd(root, fmpq(0), factor)

    def _shared(self, radicand: Real) -> Root | None:
        """A root of the field whose integer radicand divides the new integer one: sqrt 6 beside
        sqrt 2 is sqrt 3.
        """
        if isinstance(radicand, Surd):
            return None
        for root in self.roots:
            plain = not isinstance(root.radicand, Surd) and 1 < root.radicand < radicand
            if plain and (radicand / root.radicand).q == 1:
                return root
        return None

    def embed(self, value: Any) -> Any:
        """A number or Angle of another field, such as a fork, as one of this field; roots are
        adjoined as needed.
        """
        if isinstance(value, Angle):
            return Angle(
                value.half_turns,
                tuple((k, (self.embed(x), self.embed(y))) for k, (x, y) in value.parts),
            )
        if isinstance(value, PiMultiple):
            return PiMultiple(self.embed(value.coefficient), value.power)
        if not isinstance(value, Surd):
            return value
        return self.embed(value.a) + self.embed(value.b) * self.sqrt(
            self.embed(value.root.radicand)
        )

    def cos(self, angle: Any) -> Real:
        """Cosine of an Angle (or of the number 0)."""
        return _as_angle(angle).direction(self)[0]

    def sin(self, angle: Any) -> Real:
        """Sine of an Angle (or of the number 0)."""
        return _as_angle(angle).direction(self)[1]

    def arctangent(self, y: Real, x: Real) -> Angle:
        """The angle from +x to the vector (x, y), in (-pi, pi]; a rational multiple of pi when it
        is one of those of `_recognise_angle`.

        Raises ValueError for the zero vector.
        """
        if x == 0 and y == 0:
            raise NoDirection
        y, x = _cancel_pi(y, x)
        nice = _recognise_angle(self, y, x)
        return nice if nice is not None else Angle(fmpq(0), ((fmpq(1), (x, y)),))

    def solve(self, rows: list[list[Real]], right: list[Real]) -> list[Real]:
        """The unknowns of the linear equations rows * unknowns = right, which must have full column
        rank.

        Raises Singular when they do not determine the unknowns, Contradiction when a surplus row
        does not fit.
        """
        return eliminate(
            [list(map(_make_rational, row)) for row in rows],
            list(map(_make_rational, right)),
            self.is_zero,
        )

    def require_zero(self, number: Real) -> None:
        """Raises Contradiction unless the number is zero."""
        if number != 0:
            raise Contradiction


def _make_rational(number: Any) -> Real:
    """Plain integers as rationals, so that a division never leaves the exact numbers."""
    return fmpq(number) if isinstance(number, int) else number


def _as_angle(value: Any) -> Angle:
    """An Angle unchanged; the number 0 as the zero angle; any other number has no exact sine."""
    if isinstance(value, Angle):
        return value
    if not isinstance(value, (PiMultiple, Surd, fmpq, int)):
        raise TypeError("an angle is a number or an Angle")
    if value == 0:
        return Angle(fmpq(0))
    raise Inexact  # the sine of a number of radians


def _halve_power(power: int) -> int:
    """The power of pi in a square root. Raises Inexact for an odd one under the root."""
    if power % 2:
        raise Inexact  # the root of pi
    return power // 2


def _cancel_pi(y: Real, x: Real) -> tuple[Real, Real]:
    """The components of a vector without the power of pi that they share. Raises Inexact for
    different ones.
    """
    (y, high), (x, wide) = split_pi(y), split_pi(x)
    if y != 0 and x != 0 and high != wide:
        raise Inexact  # a direction with pi in it
    return y, x


def _recognise_angle(field: Field, y: Real, x: Real) -> Angle | None:
    """The direction of (x, y) as a rational multiple of pi, when it is a multiple of 15, 18 or 22.5
    degrees.
    """
    degrees = round(float(arb.atan2(enclose(y, 96), enclose(x, 96))) * 57.29577951308232 * 2) / 2
    if degrees % 15 and degrees % 18 and degrees % 22.5:
        return None
    candidate = Angle(fmpq(int(degrees * 2), 360))
    try:
        cosine, sine = candidate.direction(field.fork())
        fits = cosine * y - sine * x == 0 and sign(cosine * x + sine * y) > 0
    except (ArithmeticError, Inexact):
        return None
    return candidate if fits else None
