"""Which way round the arc of an angle runs, and how far."""

from __future__ import annotations

from math import pi

from kinegrade.figure.plane import shorter_way
from kinegrade.problem.template.hints import TURN, Angle

SMALLEST_ANGLE = pi / 180  # an angle below one degree shows no arc
_ROUNDING = 1e-6  # radians that the least angle drawn may seem to be less


def find_sweep(mark: Angle, turn: float) -> float:
    """The rotation from the first side to the second that the arc shows, of those that end like
    `turn`: in its sense, as its given is counted, or the shorter way.
    """
    shorter = shorter_way(turn)
    if mark.sense is not None and abs(shorter) > SMALLEST_ANGLE:
        sense = TURN[mark.sense]
        return sense * ((sense * shorter) % (2 * pi))
    if mark.sense is None and mark.least is not None:
        least = mark.least - _ROUNDING
        return least + (shorter - least) % (2 * pi)
    return shorter
