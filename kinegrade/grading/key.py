"""An exam as grading sees it: who was asked what, and the key of each paper.

`exam_folder` fills these values; `sheet`, `judge` and `marks` use them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache

from kinegrade.exact.figures import figures_interval


@dataclass(frozen=True, slots=True)
class Ask:
    """One answer box, the same on every paper; `unit` is "1" for a pure number.

    `sign` is the convention in English, "counter-clockwise positive", as it stands on papers; "" where it is not known.
    """

    question: str
    ask: str
    unit: str
    points: Fraction
    sign: str = ""

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"


@dataclass(frozen=True, slots=True)
class Rule:
    """How far from a right answer is still right: max(relative*|answer|, absolute), in the ask's unit.

    With `figures`, right is also what agrees with the answer to that many significant figures.
    """

    relative: Fraction = Fraction(0)
    absolute: Fraction = Fraction(0)
    figures: int | None = None

    def key(
        self, value: Fraction, period: Fraction | None = None, mistakes: Mapping[str, Fraction] | None = None
    ) -> Key:
        """The key by which `value` is right.

        >>> [float(bound) for bound in Rule(figures=3).key(Fraction("1.2304")).interval]
        [1.225, 1.235]
        """
        agreeing = figures_interval(value, self.figures) if self.figures and value else None
        return Key(value, max(self.relative * abs(value), self.absolute), period, agreeing, self, mistakes or {})


@lru_cache(maxsize=4096)  # few rules serve a whole class, and every key holds on to its own
def rule(relative: Fraction, absolute: Fraction, figures: int | None = None) -> Rule:
    """The rule of these numbers, one and the same object for equal ones."""
    return Rule(relative, absolute, figures)


@dataclass(frozen=True, slots=True)
class Key:
    """The right answer and how far from it is still right: exact fractions, all in the unit of the ask.

    `period` is a full turn for an angle that is right with any number of turns more or less. `agreeing` are the
    smallest and the largest number that agree with the value to the significant figures asked for, if any are. `rule`
    is what the tolerance and they come from; `mistakes` are the wrong answers that known mistakes lead to, by id.
    """

    value: Fraction
    tolerance: Fraction
    period: Fraction | None = None
    agreeing: tuple[Fraction, Fraction] | None = None
    rule: Rule | None = field(default=None, compare=False)
    mistakes: Mapping[str, Fraction] = field(default_factory=dict, hash=False)

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest right answer: within the tolerance, or agreeing."""
        low, high = self.value - self.tolerance, self.value + self.tolerance
        return (min(low, self.agreeing[0]), max(high, self.agreeing[1])) if self.agreeing else (low, high)


@dataclass(frozen=True, slots=True)
class Examinee:
    """Whose paper it is, and its key by answer column."""

    student: str
    name: str
    keys: Mapping[str, Key]


@dataclass(frozen=True, slots=True)
class Exam:
    """The asks in the order of the paper, the examinees in the order of the roster."""

    asks: tuple[Ask, ...]
    examinees: tuple[Examinee, ...]

    @property
    def questions(self) -> tuple[str, ...]:
        """The questions in the order of the paper."""
        return tuple(dict.fromkeys(ask.question for ask in self.asks))
