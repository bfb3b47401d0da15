"""Rotational speeds: n turns in a time mean the angular velocity 2 pi n.

So it is with what has the letter n. What an author counts in r/min under another letter differs
from rad/s by its unit alone.
"""

from __future__ import annotations

from kinegrade.numbers.units import Unit
from kinegrade.worked.formulas.atoms import TWO, Measured, Number, Symbol
from kinegrade.worked.formulas.formula import Formula, Product
from kinegrade.worked.formulas.symbols import PI, begins_with_letter

FULL_TURN = Product((TWO, PI))
_TURN = 2  # times pi, in radians


def is_rotational_speed(symbol: Symbol, unit: Unit) -> bool:
    """Whether a symbol stands for a number of turns in a time."""
    return unit.counts_turns and unit.time == -1 and begins_with_letter(symbol, "n")


def count_full_turns(number: Formula) -> Formula:
    """The angle of so many turns: 2 pi n."""
    return Product((TWO, PI, number.size)).signed(number.sign)


def turn_into_angle(number: Formula, unit: Unit) -> Formula:
    """The angular velocity of so many turns in the unit's time: 2 pi 600/(60 s) for 600 r/min."""
    seconds = _TURN / unit.scale.rational
    angle = FULL_TURN.dot(number.size) / Measured(Number(str(seconds)), "s")
    return angle.signed(number.sign)


def count_seconds(per_second: Formula, unit: Unit) -> Formula:
    """A number of turns a second, times the seconds of the unit's time: 60 s/min for r/min."""
    seconds = _TURN / unit.scale.rational
    if seconds == 1:
        return per_second
    return per_second.dot(Measured(Number(str(seconds)), "s/min"))
