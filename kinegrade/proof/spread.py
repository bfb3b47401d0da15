"""How the answers of an ask spread over the drawn instances, and how easily they are guessed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isclose

from kinegrade.problem.quantity import Quantity

_OFTEN = 0.9  # an ask that equals a given in nine instances out of ten is guessed by copying it


@dataclass
class Spread:
    """The values of one ask over the instances, and the givens they were equal to, signs apart."""

    values: list[float] = field(default_factory=list)
    copies: Counter[str] = field(default_factory=Counter)

    def note(self, answer: Quantity, givens: Mapping[str, Quantity]) -> None:
        """Count the answer of one more instance."""
        self.values.append(answer.value)
        for name, given in givens.items():
            if isclose(abs(answer.value), abs(given.value), rel_tol=1e-12):
                self.copies[name] += 1

    @property
    def negative(self) -> float:
        """The share of negative answers."""
        return sum(value < 0 for value in self.values) / len(self.values)

    @property
    def constant(self) -> bool:
        """Whether all instances have one answer."""
        return len(self.values) > 1 and all(
            isclose(value, self.values[0], rel_tol=1e-12) for value in self.values
        )

    def copied(self) -> str | None:
        """The given that the answer equals (signs apart) in almost all instances, if there is
        one.
        """
        for name, count in self.copies.most_common(1):
            if count >= _OFTEN * len(self.values):
                return name
        return None
