"""The tolerance for an answer that is zero or next to it: a share of the mechanism's scale."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from math import floor, log10

from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.numbers.units import Unit
from kinegrade.problem.scale import find_scale


def find_effective_tolerance(
    tolerance: Tolerance, value: float, unit: Unit, motion: Motion
) -> Tolerance:
    """The tolerance for an answer of `value` units: where it is zero or next to it, the rule's
    share of the mechanism's scale is allowed. Next to zero means smaller than that.
    """
    room = tolerance.share * find_scale_of_mechanism(motion, unit)
    if abs(value) >= room:
        return tolerance
    return replace(tolerance, absolute=max(tolerance.absolute, room))


@lru_cache(maxsize=1024)
def find_scale_of_mechanism(motion: Motion, unit: Unit) -> Fraction:
    """The mechanism's scale in a unit, to two significant figures."""
    return round_to_two_figures(find_scale(motion, unit))


def round_to_two_figures(size: float) -> Fraction:
    """A size rounded to two significant figures, exactly; what doubles left of a tie is a tie."""
    if size <= 0:
        return Fraction(0)
    step = Fraction(10) ** (floor(log10(size)) - 1)
    return round(Fraction(f"{size:.12g}") / step) * step
