"""Own answers that make the rest of a question trivial, so that nothing is earned by going on from
them.

Whoever answers with next to nothing need not think of the terms that hang on it: they vanish, as if
forgotten. Whoever answers with something enormous need not think of any other term. `is_trivial` is
called by `kinegrade.grading.follow`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction

# Of the right answer: what is larger does not make a term vanish that is there
SMALL = Fraction(1, 2)
TINY = Fraction(1, 900)  # of the right answer: stands for nothing
# Times the right answer: more than degrees for radians, or a slipped decimal point, can explain
ENORMOUS = 100
POWERS = (1, 2)  # of a velocity in velocities and in accelerations
Own = Mapping[str, Fraction]


@dataclass(frozen=True, slots=True)
class Later:
    """A later answer: what follows for it from own answers to earlier asks, and whether it agrees
    with a value.
    """

    what_follows: Callable[[Own], Fraction | None]
    agrees: Callable[[Fraction], bool]

    def fits(self, own: Own, factor: Fraction = Fraction(1)) -> bool:
        """Whether it agrees with so many times what follows."""
        value = self.what_follows(own)
        return value is not None and self.agrees(factor * value)


def is_trivial(name: str, own: Own, right: Fraction, later: Later) -> bool:
    """Whether a later answer that follows from `own` cannot be told from one that leaves terms out,
    for the value of `name` among them, where `right` (not zero) is right.
    """
    size = abs(own[name] / right)
    if size < SMALL:  # the term has vanished, and would not have with the right value
        return later.fits({**own, name: right * TINY}) and not later.fits({**own, name: right})
    return size > ENORMOUS and any(_drowns(name, own, right, later, power) for power in POWERS)


def _drowns(name: str, own: Own, right: Fraction, later: Later, power: int) -> bool:
    """Whether everything but a power of the own value has drowned, and would not have with the
    right value.
    """

    def in_proportion(value: Fraction) -> bool:
        return later.fits({**own, name: value}, (own[name] / value) ** power)

    return in_proportion(own[name] / 2) and not in_proportion(right)
