"""How the answers of an ask spread over the drawn instances, and how easily they are guessed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isclose
from typing import Literal

from kinegrade.problem.quantity import Quantity

_OFTEN = 0.9  # an ask that equals a given in nine instances out of ten is guessed by copying it
_FEWEST = 10  # instances: in fewer, numbers are equal by chance


@dataclass(frozen=True)
class Copied:
    """What an answer may be copied from: a given, or an ask before it."""

    kind: Literal["given", "ask"]
    name: str


@dataclass
class Spread:
    """The values of one ask over the instances, and what they were equal to, signs apart."""

    values: list[float] = field(default_factory=list)
    copies: Counter[Copied] = field(default_factory=Counter)

    def note(self, answer: Quantity, known: Mapping[Copied, Quantity]) -> None:
        """Count the answer of one more instance, in which a student knows or has found these."""
        self.values.append(answer.value)
        for one, quantity in known.items():
            if isclose(abs(answer.value), abs(quantity.value), rel_tol=1e-12):
                self.copies[one] += 1

    @property
    def negative(self) -> float:
        """The share of negative answers."""
        return sum(value < 0 for value in self.values) / len(self.values)

    def is_constant(self, *, vanishes: bool, complete: bool) -> bool:
        """Whether all instances have one answer, other than a zero that is a proper one; of a few
        it is said where they are `complete`, and there are no others.
        """
        same = all(isclose(value, self.values[0], rel_tol=1e-12) for value in self.values)
        enough = len(self.values) >= (2 if complete else _FEWEST)
        return enough and same and not (vanishes and self.values[0] == 0)

    @property
    def copied(self) -> Copied | None:
        """What the answer equals (signs apart) in almost all instances, if there is such a
        quantity.
        """
        for one, count in self.copies.most_common(1):
            if count >= max(_OFTEN * len(self.values), _FEWEST):
                return one
        return None
