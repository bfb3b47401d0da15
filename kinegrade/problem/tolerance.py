"""The tolerance for an answer that is zero or next to it: a share of the largest term that goes
into it.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import floor, log10

from msgspec.structs import replace

from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.numbers.units import Unit
from kinegrade.problem.scale import find_scale


def find_effective_tolerance(tolerance: Tolerance, value: float, largest: float) -> Tolerance:
    """The tolerance for an answer of `value` units: where terms of which the `largest` has that
    size cancel, so that it is zero or next to it, the rule's share of that term is allowed. Next to
    zero means smaller than that.
    """
    room = tolerance.share * round_to_two_figures(largest)
    if abs(value) >= room:
        return tolerance
    return replace(tolerance, absolute=max(tolerance.absolute, room))


def may_cancel(tolerance: Tolerance, value: float, unit: Unit, motion: Motion) -> bool:
    """Whether terms may cancel in an answer of `value` units so far that a share of the largest is
    allowed: no term is taken to be larger than the mechanism's scale.
    """
    return abs(value) < tolerance.share * find_scale_of_mechanism(motion, unit)


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
