"""Vectors whose magnitudes are added where they should be added as vectors."""

from __future__ import annotations

from typing import Self

from kinegrade.mechanics.vector import Component, Vector, add_vectors
from kinegrade.numbers.number import Arithmetic
from kinegrade.students.mistaking.slips import Share


class ScalarSum(Vector):
    """A sum of vectors of which a student takes the sum of their magnitudes for the magnitude.

    Its components, and all that is worked out from them, are those of the sum. `share` is what
    remains of the vectors' directions.
    """

    parts: tuple[Vector, ...]
    share: Share

    @classmethod
    def make(cls, parts: tuple[Vector, ...], share: Share) -> Self:
        """The sum of the parts, which may be such sums themselves."""
        total = cls(*add_vectors(parts))
        total.parts, total.share = parts, share
        return total

    def magnitude(self, arithmetic: Arithmetic) -> Component:
        """The sum of the magnitudes where nothing of the directions remains, in the parts' unit."""
        added = sum(part.magnitude(arithmetic) for part in self.parts)
        return arithmetic.choose(self.share == 0, added, super().magnitude(arithmetic))
