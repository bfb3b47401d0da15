"""What is in line at a dead point or a change point of a path."""

from __future__ import annotations

import numpy as np

from kinegrade.language.message import Message
from kinegrade.mechanics.dead_point import find_alignment
from kinegrade.motion.following import Knot
from kinegrade.motion.placing import place_mechanism
from kinegrade.motion.system import System
from kinegrade.numbers.doubles import Doubles

_NOTICED = 1e-7  # of the fastest coordinate's rate: which bodies still turn


class _Near(Doubles):
    """Doubles that have been found by iteration: what is small counts as zero."""

    def __init__(self, size: float) -> None:
        self.least = 1e-9 * size

    def is_zero(self, number: float) -> bool:
        """Whether a product of lengths is zero to within what iteration leaves."""
        return abs(number) < self.least


def describe_alignment(system: System, knot: Knot) -> Message | None:
    """Which joints of bodies that turn are in line there, or which body stands at a right angle to
    its guide; None where nothing is found to be.
    """
    arithmetic = _Near(system.size**2)
    values = (knot.unknowns * system.units).tolist()
    at, _ = system.place(values[:-1], values[-1], arithmetic)
    turning = {
        rate.body
        for rate, part in zip(system.rates, np.abs(knot.tangent[:-1]), strict=True)
        if rate.kind == "turning" and part > _NOTICED
    }
    mechanism = place_mechanism(system.frames, at)
    return find_alignment(mechanism, sorted(turning), arithmetic)
