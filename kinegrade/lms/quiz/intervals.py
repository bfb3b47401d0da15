"""What counts as right, as a quiz file can express it: one closed interval, or one for each turn of
an angle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kinegrade.exam.quiz.document import QuizAsk
from kinegrade.lms.quiz.decimals import write_decimal

_TURNS = 2  # a quiz accepts angles within this many turns of zero, and says so
_EVEN = Fraction(1, 10**15)  # no system that computes in doubles distinguishes such margins


@dataclass(frozen=True)
class RightInterval:
    """A right number with all that counts as right: from `low` to `high`, both included."""

    value: Fraction
    low: Fraction
    high: Fraction

    @property
    def middle(self) -> Fraction:
        """Halfway between the bounds."""
        return (self.low + self.high) / 2

    @property
    def symmetric(self) -> bool:
        """Whether the value is in the middle, within double precision."""
        below, above = self.value - self.low, self.high - self.value
        return abs(below - above) <= _EVEN * (below + above)

    @property
    def value_text(self) -> str:
        """The value as a decimal."""
        return write_decimal(self.value)

    @property
    def low_text(self) -> str:
        """The lower bound, rounded outwards where it must be, so that no right answer becomes
        wrong.
        """
        return write_decimal(self.low, "down")

    @property
    def high_text(self) -> str:
        """The upper bound, rounded outwards where it must be."""
        return write_decimal(self.high, "up")

    @property
    def margin_texts(self) -> tuple[str, str]:
        """How far the interval reaches below and above the value as it is written."""
        written = Fraction(self.value_text)
        return write_decimal(written - self.low, "up"), write_decimal(self.high - written, "up")


def find_right_intervals(ask: QuizAsk) -> tuple[RightInterval, ...]:
    """The interval of the key first; for an angle also those whole turns away, as `turn` gives
    them.
    """
    return turn(RightInterval(ask.value, ask.low, ask.high), ask.period)


def turn(interval: RightInterval, period: Fraction | None) -> tuple[RightInterval, ...]:
    """The interval first, then those whole turns away with a part within TURNS turns of zero.

    Without a period there is one interval. For an angle within one turn of zero, one turn more and
    one turn less are included.
    """
    if period is None:
        return (interval,)
    farthest = _TURNS * period
    fewest = -((interval.high + farthest) // period)
    most = (farthest - interval.low) // period
    shifts = [turns * period for turns in sorted(range(fewest, most + 1), key=abs) if turns]
    return (
        interval,
        *(
            RightInterval(interval.value + shift, interval.low + shift, interval.high + shift)
            for shift in shifts
        ),
    )


def turn_next_to_zero(ask: QuizAsk) -> RightInterval:
    """The one interval whose value is within half a turn of zero, for systems that take one."""
    if ask.period is None:
        return RightInterval(ask.value, ask.low, ask.high)
    shift = -((ask.value + ask.period / 2) // ask.period) * ask.period
    return RightInterval(ask.value + shift, ask.low + shift, ask.high + shift)
