"""The length of a vector in any arithmetic."""

from __future__ import annotations

from typing import Any, Protocol


class Rooted(Protocol):
    """What a magnitude needs of an arithmetic: a test for zero, and square roots."""

    def is_zero(self, number: Any) -> bool:
        """Whether a number is zero."""

    def sqrt(self, number: Any) -> Any:
        """The positive square root."""


class Magnitude:
    """Gives an arithmetic its `magnitude`."""

    def magnitude(self: Rooted, x: Any, y: Any) -> Any:
        """The length of the vector (x, y); along an axis without a root, which the field might not
        have.
        """
        if self.is_zero(x):
            return abs(y)
        return abs(x) if self.is_zero(y) else self.sqrt(x * x + y * y)
