"""Real numbers of a tower of quadratic fields over the rationals: Q, Q(sqrt 2), Q(sqrt 2)(sqrt(3 +
sqrt 2)), ...

A rational is a `flint.fmpq`, the element of sympy's QQ with python-flint ground types. A number
that needs roots is a `Surd` a + b*sqrt(d), where a, b and d live lower in the tower and b is not
zero; so every number has one form, stands as low in the tower as it can, and equality is equality
of forms. Building a tower costs nothing, whereas sympy's `AlgebraicField` takes 45 ms for two
radicals, which a class would pay again and again, as each student has different numbers.

Fields are made by `kinegrade.numbers.field`, which also decides what has a square root in a tower.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb, ctx, fmpq

Real = Any  # flint.fmpq, Surd or PiMultiple: flint ships no types
_MAX_SIGN_PRECISION = 1 << 16
# Bits of a coefficient: some 5,000 digits; beyond it balls serve better, and hostile powers end
MAX_HEIGHT = 1 << 14


@dataclass(frozen=True)
class Root:
    """The positive square root of `radicand`, adjoined as level `level` (1 is the lowest) of a
    tower.
    """

    radicand: Real
    level: int


class Surd:
    """a + b*sqrt(root.radicand), b not zero. Supports + - * / **, comparison and sign with
    rationals and surds.

    >>> from flint import fmpq
    >>> x = Surd(Root(fmpq(2), 1), fmpq(1), fmpq(1))
    >>> (x * x).a, (x * x).b, x * x - 2 * x
    (3, 2, 1)
    """

    __slots__ = ("_double", "_hash", "a", "b", "root")

    def __init__(self, root: Root, a: Real, b: Real) -> None:
        self.root, self.a, self.b = root, a, b
        # Found when they are asked for: of most numbers on the way nobody asks
        self._double: float | None = None
        self._hash: int | None = None

    def __add__(self, other: Real) -> Real:
        if isinstance(other, Surd) and other.root.level >= self.root.level:
            if other.root.level > self.root.level:
                return Surd(other.root, other.a + self, other.b)
            _require_same_tower(self, other)
            return make_surd(self.root, self.a + other.a, self.b + other.b)
        if isinstance(other, (Surd, fmpq, int)):
            return Surd(self.root, self.a + other, self.b)
        return NotImplemented

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd(self.root, -self.a, -self.b)

    def __sub__(self, other: Real) -> Real:
        return self + (-other)

    def __rsub__(self, other: Real) -> Real:
        return -self + other

    def __mul__(self, other: Real) -> Real:
        if isinstance(other, Surd) and other.root.level >= self.root.level:
            if other.root.level > self.root.level:
                return Surd(other.root, other.a * self, other.b * self)
            _require_same_tower(self, other)
            product = self.b * other.b * self.root.radicand
            return make_surd(
                self.root, self.a * other.a + product, self.a * other.b + self.b * other.a
            )
        if isinstance(other, (Surd, fmpq, int)):
            return make_surd(self.root, self.a * other, self.b * other)
        return NotImplemented

    __rmul__ = __mul__

    def inverse(self) -> Real:
        """1/self, by the conjugate."""
        norm = self.a * self.a - self.b * self.b * self.root.radicand
        factor = 1 / norm
        return Surd(self.root, self.a * factor, -self.b * factor)

    def __truediv__(self, other: Real) -> Real:
        if isinstance(other, Surd):
            return self * other.inverse()
        if isinstance(other, (fmpq, int)):
            return Surd(self.root, self.a / other, self.b / other)
        return NotImplemented

    def __rtruediv__(self, other: Real) -> Real:
        return self.inverse() * other

    def __pow__(self, exponent: int) -> Real:
        if exponent < 0:
            return self.inverse() ** -exponent
        result: Real = fmpq(1)
        for bit in bin(exponent)[2:]:
            result = result * result * self if bit == "1" else result * result
        return result

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Surd):
            return False if isinstance(other, (fmpq, int)) else NotImplemented
        return self.root == other.root and self.a == other.a and self.b == other.b

    def __hash__(self) -> int:
        if self._hash is None:
            self._hash = hash((self.root.level, self.a, self.b))
        return self._hash

    def __lt__(self, other: Real) -> bool:
        return sign(self - other) < 0

    def __gt__(self, other: Real) -> bool:
        return sign(self - other) > 0

    def __le__(self, other: Real) -> bool:
        return sign(self - other) <= 0

    def __ge__(self, other: Real) -> bool:
        return sign(self - other) >= 0

    def __abs__(self) -> Surd:
        return -self if sign(self) < 0 else self

    def __float__(self) -> float:
        if self._double is None:
            self._double = float(enclose(self, 96))
        return self._double

    def ball(self) -> Any:
        """The number as an enclosure at the working precision."""
        root = enclose_at_precision(self.root.radicand).sqrt()
        return enclose_at_precision(self.a) + enclose_at_precision(self.b) * root

    def sign(self) -> int:
        """-1 or 1. Exact: a form that is not zero is separated from zero by raising the
        precision.
        """
        precision = 64
        while precision <= _MAX_SIGN_PRECISION:
            value = enclose(self, precision)
            if 0 not in value:
                return 1 if value > 0 else -1
            precision *= 2
        raise ArithmeticError("the sign of an exact number could not be separated from zero")

    def __reduce__(self) -> tuple[type[Surd], tuple[Root, Real, Real]]:
        return Surd, (self.root, self.a, self.b)

    def height(self) -> int:
        """The bits of the longest numerator or denominator among the rational coefficients."""
        return max(height(self.a), height(self.b))

    def __repr__(self) -> str:
        return f"Surd({self.a} + {self.b}*sqrt({self.root.radicand}))"


def make_surd(root: Root, a: Real, b: Real) -> Real:
    """a + b*sqrt(root.radicand) in its unique form: the root is dropped when b is zero."""
    return Surd(root, a, b) if b != 0 else a


def height(number: Real) -> int:
    """The bits of the longest numerator or denominator among the number's rational coefficients."""
    if isinstance(number, fmpq):
        return max(int(number.p).bit_length(), int(number.q).bit_length())
    return int(number.height())


def _require_same_tower(first: Surd, second: Surd) -> None:
    """Refuse to mix numbers of different towers, which have no common form."""
    if first.root is not second.root and first.root != second.root:
        raise ArithmeticError("numbers of two different fields: bring both into one field first")


def enclose_at_precision(number: Real) -> Any:
    """An enclosure of `number` as a `flint.arb` at the working precision."""
    return arb(number) if isinstance(number, (fmpq, int)) else number.ball()


def enclose(number: Real, precision: int) -> Any:
    """An enclosure of `number` as a `flint.arb`, computed with `precision` bits."""
    with ctx.workprec(precision):
        return enclose_at_precision(number)


def sign(number: Real) -> int:
    """-1, 0 or 1, decided exactly."""
    if isinstance(number, (fmpq, int)):
        return int(number > 0) - int(number < 0)
    return int(number.sign())
