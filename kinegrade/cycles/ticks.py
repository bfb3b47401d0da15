"""Round numbers along an axis: steps of 1, 2 or 5 times a power of ten, or of parts of a turn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.round_numbers import round_up

_TURNS = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360, 720, 1800, 3600)  # degrees


@dataclass(frozen=True)
class Axis:
    """An axis from `low` to `high`, whose `ticks` are multiples of `step`."""

    low: float
    high: float
    step: float

    @property
    def ticks(self) -> tuple[float, ...]:
        """The numbers at which it is marked."""
        first, last = (
            math.ceil(self.low / self.step - 1e-9),
            math.floor(self.high / self.step + 1e-9),
        )
        return tuple(number * self.step for number in range(first, last + 1))

    def write(self, tick: float) -> str:
        """A tick as text, with as many decimals as the step needs."""
        decimals = max(0, -math.floor(math.log10(self.step) + 1e-9))
        return f"{round(tick, decimals) + 0.0:.{decimals}f}"

    def place(self, value: float) -> float:
        """The part of the axis that lies before a value."""
        return (value - self.low) / (self.high - self.low)


def make_axis(low: float, high: float, most: int) -> Axis:
    """The axis that holds an interval, from tick to tick, of which it has about `most`."""
    if high - low < 1e-9 * max(abs(low), abs(high), 1e-3):
        room = abs(high) or 1.0
        low, high = low - room, high + room
    step = _choose_step((high - low) / most)
    return Axis(math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step, step)


def make_turn_axis(low: float, high: float, most: int) -> Axis:
    """The axis of an angle in degrees, from `low` to `high` as they are."""
    least = (high - low) / most
    step = next((float(each) for each in _TURNS if each >= least), _choose_step(least))
    return Axis(low, high, step)


def _choose_step(least: float) -> float:
    """The smallest round number that is not below `least`, as far as doubles tell."""
    return float(round_up(Fraction(least * (1 - 1e-9))))
