"""A scale of grades: which grade a share of the points earns, and whether it passes.

Shares are exact and bounds are included: whoever has just half of the points has reached 50 %.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Step:
    """A grade, the share of the points from which on it is given, and whether it passes."""

    grade: str
    least: Fraction
    passes: bool


@dataclass(frozen=True, slots=True)
class Scale:
    """The grades, the best first; the last is given from 0 on. `absent` is the word for students
    who answered nothing at all, "" for none.
    """

    steps: tuple[Step, ...]
    absent: str = ""

    def find_step(self, share: Fraction) -> Step:
        """The best grade whose bound a share of the points reaches; bonus points may take it above
        1.
        """
        return next(step for step in self.steps if share >= step.least)

    @property
    def pass_mark(self) -> Fraction | None:
        """The share of the points from which on one passes; None where nobody can."""
        return next((step.least for step in reversed(self.steps) if step.passes), None)


def begin_at_zero(steps: Sequence[Step]) -> tuple[Step, ...]:
    """The steps without those below one that everybody reaches; the last one begins at 0.

    >>> one, two = Step("1", Fraction(-1, 10), True), Step("2", Fraction(-1, 2), False)
    >>> begin_at_zero([one, two])
    (Step(grade='1', least=Fraction(0, 1), passes=True),)
    """
    kept: list[Step] = []
    for step in steps:
        kept.append(step)
        if step.least <= 0:
            break
    *better, last = kept
    return (*better, Step(last.grade, Fraction(0), last.passes))
