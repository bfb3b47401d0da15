"""Answers that make the rest of a question trivial, so that nothing is earned by carrying on from
them.

With an answer next to zero, the terms that depend on it vanish, as if the student had forgotten
them. With an enormous answer, no other term matters. `is_trivial` is called by
`kinegrade.grading.judging.follow`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

# Of the right answer: no larger value makes an existing term vanish
_SMALL = Fraction(1, 2)
_TINY = Fraction(1, 900)  # of the right answer: stands in for zero
_LARGE = 4  # times the right answer: no smaller value drowns what else there is
_POWERS = (1, 2)  # of a velocity, in velocities and in accelerations
Own = Mapping[str, Fraction]  # a student's answers by ask, each in its unit
WhatFollows = Callable[[Own], Sequence[Fraction]]  # from them, for a later answer


@dataclass(frozen=True, slots=True)
class Later:
    """A later answer: what follows for it from the student's answers to earlier asks, and whether
    it agrees with a value.
    """

    what_follows: WhatFollows
    agrees: Callable[[Fraction], bool]

    def fits(self, answers: Own, factor: Fraction = Fraction(1)) -> bool:
        """Whether it agrees with `factor` times something that follows."""
        return any(self.agrees(factor * value) for value in self.what_follows(answers))


def is_trivial(name: str, answers: Own, right: Fraction, later: Later) -> bool:
    """Whether a later answer that follows from `answers` cannot be distinguished from one that
    leaves terms out, because of the value of `name` among them; `right` (not zero) is the right
    value.
    """
    size = abs(answers[name] / right)
    if size < _SMALL:  # the term has vanished, and would not have with the right value
        return later.fits({**answers, name: right * _TINY}) and not later.fits(
            {**answers, name: right}
        )
    return size > _LARGE and any(
        _has_drowned(name, answers, right, later, power) for power in _POWERS
    )


def _has_drowned(name: str, answers: Own, right: Fraction, later: Later, power: int) -> bool:
    """Whether a power of this value drowns everything else, and would not with the right value."""

    def in_proportion(value: Fraction) -> bool:
        return later.fits({**answers, name: value}, (answers[name] / value) ** power)

    return in_proportion(answers[name] / 2) and not in_proportion(right)
