"""The keys of a paper as grading sees them: what is right for each ask, and by which rule.

`key_decoding` and `exact_keys` fill these values; `papers` holds them, `judging` and `marks` use
them.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import NamedTuple, Protocol

from kinegrade.numbers.tolerance import Tolerance


@dataclass(frozen=True, slots=True)
class Key:
    """The right answer, in the unit of the ask, and the rule that says how far from it is right.

    `period` is a full turn for an angle that is right with any number of turns more or less;
    `mistakes` are the wrong answers that known mistakes lead to, by id.

    >>> [float(bound) for bound in Key(Fraction("1.2304"), Tolerance(figures=3)).interval]
    [1.225, 1.235]
    """

    value: Fraction
    rule: Tolerance
    period: Fraction | None = None
    mistakes: Mapping[str, Fraction] = field(default_factory=dict, hash=False)

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest right answer."""
        return self.rule.interval(self.value)


# In place of the key of an alternative that a paper does not hold
NOT_ASKED = Key(Fraction(0), Tolerance())


class StatedKey(NamedTuple):
    """A key as it stands in key.jsonl; `key` works it out exactly, only when that is needed.

    `value` is the right answer as a decimal or a plain fraction, `mistakes` what mistakes lead to:
    to double precision, which is as far as they are known, or exactly.
    """

    value: str
    rule: Tolerance
    mistakes: Mapping[str, float | Fraction]
    period: Fraction | None

    def key(self, names: Container[str]) -> Key:
        """The exact key, with the mistakes of these names only."""
        mistakes = {
            name: wrong if isinstance(wrong, Fraction) else Fraction(repr(wrong))
            for name, wrong in self.mistakes.items()
            if name in names
        }
        return Key(Fraction(self.value), self.rule, self.period, mistakes)


class Keys(Protocol):
    """The keys of one paper in the order of its asks: `ListedKeys`, or as files state them."""

    def __getitem__(self, ask: int, /) -> Key | StatedKey:
        """The key of an ask."""

    def __len__(self) -> int:
        """How many there are."""

    def __iter__(self) -> Iterator[Key | StatedKey]:
        """All of them."""

    def state(self, ask: int, /) -> str:
        """The right answer to an ask, as a decimal or a fraction."""

    def list_centres(self) -> Sequence[float]:
        """The right answers in double precision; NaN where a number of turns is right too."""

    def list_values(self) -> Sequence[float]:
        """The right answers, those of cyclic angles too, nearly rounded."""

    def list_periods(self) -> Sequence[Fraction | None]:
        """The full turn of each ask, where any number of turns is right too."""

    def list_rules(self) -> tuple[Tolerance, ...]:
        """The rule of each ask; where papers share all of them, the same object."""

    def find_lacking(self) -> frozenset[int]:
        """The numbers of the asks that the paper does not hold; their keys are NOT_ASKED."""
