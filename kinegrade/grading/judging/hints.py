"""What probably went wrong with a number, judging by the number alone: a sign, a power of ten,
degrees for radians.

Only ratios that rarely arise by chance are named, and feedback words them as a "perhaps". The marks
already report mistakes that follow from the mechanism; this is for all other wrong answers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import pi
from typing import Literal

from kinegrade.numbers.tolerance import Tolerance

Kind = Literal[
    "opposite",
    "power of ten",
    "twice",
    "half",
    "degrees for radians",
    "radians for degrees",
    "revolutions per minute",
    "revolutions per second",
    "rounded",
    "another ask",
    "close",
]
_LARGEST_POWER = 6
_WIDEST = 0.02  # of the right answer: a wider interval would be hit by chance
_CLOSE = 0.05  # of the right answer
_COARSE = 0.1  # of the right answer: what is farther off is not put down to rounding
_DOUBLED: tuple[tuple[Kind, float], ...] = (("twice", 2.0), ("half", 0.5))


@dataclass(frozen=True, slots=True)
class Hint:
    """`reversed_sign` is whether the sign is opposite as well; `power` is the power of ten;
    `column` is the ask whose answer it is.
    """

    kind: Kind
    reversed_sign: bool = False
    power: int = 0
    column: str = ""


def find_hint(
    value: Fraction,
    right: Fraction,
    rule: Tolerance,
    unit: str,
    others: Mapping[str, Fraction],
    *,
    coarse: float = 0.0,
) -> Hint | None:
    """What a wrong value suggests, or None; `others` are the right answers of the question's other
    asks, by column, `coarse` is how far off rounding too coarsely may lead.

    A value fits if it would be right by the rule, and lies within 2 %, but for a factor or as
    another answer.

    >>> from kinegrade.numbers.tolerance import ONE_PER_CENT
    >>> find_hint(Fraction("-0.257"), Fraction("0.25725"), ONE_PER_CENT, "m/s", {})
    Hint(kind='opposite', reversed_sign=False, power=0, column='')
    """
    if not right or not value:
        return None
    ratio = float(value / right)  # for a guess floats will do
    below, above = _find_room(right, rule)
    for candidate, factor in _list_candidates(unit):
        if below <= ratio / factor - 1 <= above:
            return candidate
    if abs(ratio - 1) <= min(coarse / abs(float(right)), _COARSE):
        return Hint("rounded")
    for column, other in others.items():
        if other and _fits(value, other, rule):
            return Hint("another ask", column=column)
    return Hint("close") if abs(ratio - 1) <= _CLOSE else None


def _fits(value: Fraction, right: Fraction, rule: Tolerance) -> bool:
    below, above = _find_room(right, rule)
    return below <= float(value / right) - 1 <= above


def _find_room(right: Fraction, rule: Tolerance) -> tuple[float, float]:
    """Shares of the right answer, the smallest and the largest, by which one may be off."""
    ends = [float(bound / right) - 1 for bound in rule.interval(right)]
    return max(min(ends), -_WIDEST), min(max(ends), _WIDEST)


@lru_cache(maxsize=256)
def _list_candidates(unit: str) -> tuple[tuple[Hint, float], ...]:
    """Hints with the ratio of the value to the right answer, the likeliest first."""
    powers = [
        power for power in sorted(range(-_LARGEST_POWER, _LARGEST_POWER + 1), key=abs) if power
    ]
    found = [(Hint("opposite"), -1.0)]
    for sign in (1.0, -1.0):
        turned = sign < 0
        found += [(Hint("power of ten", turned, power), sign * 10.0**power) for power in powers]
        found += [
            (Hint(kind, turned), sign * factor)
            for kind, factor in (*_DOUBLED, *_list_angular_factors(unit))
        ]
    return tuple(found)


def _list_angular_factors(unit: str) -> Sequence[tuple[Kind, float]]:
    """Factors between measures of angle; none for lengths and speeds."""
    forgotten: list[tuple[Kind, float]] = [
        ("degrees for radians", 180 / pi),
        ("radians for degrees", pi / 180),
    ]
    if unit == "rad/s":
        return [
            *forgotten,
            ("revolutions per minute", 30 / pi),
            ("revolutions per second", 1 / (2 * pi)),
        ]
    return forgotten if unit.startswith(("rad", "deg")) else []
