"""What mechanics needs of numbers and of arithmetics, so that one formula serves them all.

A number is a rational or a surd, a ball, a double, or an array of doubles; an `Arithmetic` is what
else is done with numbers of one kind. Operands stay `Any`: numbers of one kind go together, which
no protocol can say, and the exact library ships no types.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import Any, Protocol

from kinegrade.numbers.units import Scale


class Number(Protocol):
    """A number of any arithmetic, or an array of them.

    A comparison gives a truth value, for arrays an array of them.
    """

    def __neg__(self) -> Number: ...

    def __abs__(self) -> Number: ...

    def __float__(self) -> float: ...

    def __add__(self, other: Any, /) -> Number: ...

    def __radd__(self, other: Any, /) -> Number: ...

    def __sub__(self, other: Any, /) -> Number: ...

    def __rsub__(self, other: Any, /) -> Number: ...

    def __mul__(self, other: Any, /) -> Number: ...

    def __rmul__(self, other: Any, /) -> Number: ...

    def __truediv__(self, other: Any, /) -> Number: ...

    def __rtruediv__(self, other: Any, /) -> Number: ...

    def __lt__(self, other: Any, /) -> Any: ...

    def __gt__(self, other: Any, /) -> Any: ...


class Solver(Protocol):
    """An arithmetic of linear equations: what a plan is run with."""

    def solve(self, rows: list[list[Any]], right: list[Any]) -> Sequence[Number]:
        """The unknowns of rows * unknowns = right; there may be more rows than unknowns.

        Raises Singular where the rows do not determine every unknown, Contradiction where a surplus
        row does not fit.
        """

    def require_zero(self, number: Any) -> None:
        """Raises Contradiction unless the number is zero, as far as the arithmetic checks it."""


class Rooted(Protocol):
    """What a magnitude needs of an arithmetic."""

    def is_zero(self, number: Any) -> bool:
        """Whether a number is zero."""

    def sqrt(self, number: Any) -> Number:
        """The positive square root. Raises ValueError below zero, or gives NaN."""


class Magnitude:
    """Gives an arithmetic its `magnitude`."""

    def magnitude(self: Rooted, x: Any, y: Any) -> Number:
        """The length of the vector (x, y); along an axis without a root, which the field might not
        have.
        """
        if self.is_zero(x):
            return abs(y)  # type: ignore[no-any-return]
        return abs(x) if self.is_zero(y) else self.sqrt(x * x + y * y)


class Arithmetic(Solver, Rooted, Protocol):
    """All that is done with numbers of one kind beside adding, multiplying and dividing.

    It is `exact` if no number of it is rounded, `certified` if what it decides is certain.
    """

    exact: bool
    certified: bool

    def fork(self) -> Arithmetic:
        """An arithmetic of the same numbers that takes in others by itself."""

    def context(self) -> AbstractContextManager[Any]:
        """What is set up while working in the arithmetic."""

    def embed(self, value: Any) -> Any:
        """A number or an angle of a fork as one of this arithmetic."""

    def number(self, rational: Any) -> Any:
        """A rational number as one of this arithmetic."""

    def scale(self, scale: Scale) -> Any:
        """What a unit is in SI, as one of this arithmetic."""

    def turns(self, half_turns: Any) -> Any:
        """The angle of `half_turns` times pi."""

    def sign(self, number: Any) -> Any:
        """-1, 0 or 1."""

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`."""

    def cos(self, angle: Any) -> Number:
        """Cosine of an angle."""

    def sin(self, angle: Any) -> Number:
        """Sine of an angle."""

    def arctangent(self, y: Any, x: Any) -> Any:
        """The angle from +x to the vector (x, y), in (-pi, pi]."""

    def magnitude(self, x: Any, y: Any) -> Number:
        """The length of the vector (x, y)."""
