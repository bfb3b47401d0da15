"""The length of a vector in any arithmetic."""

from __future__ import annotations

from typing import Any

from kinegrade.numbers.number import Number, Rooted


class Magnitude:
    """Gives an arithmetic its `magnitude`."""

    def magnitude(self: Rooted, x: Any, y: Any) -> Number:
        """The length of the vector (x, y); along an axis without a root, which the field might not
        have.
        """
        if self.is_zero(x):
            return abs(y)  # type: ignore[no-any-return]
        return abs(x) if self.is_zero(y) else self.sqrt(x * x + y * y)
