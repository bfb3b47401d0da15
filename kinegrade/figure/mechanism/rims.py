"""The circles of a mechanism: wheels, gears, tracks, discs, slotted rings, each derived from the
joints; and those that only a hint knows.
"""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.figure.joints.symbol import Rim, Symbol
from kinegrade.figure.plane import length
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import Rimmed


def find_rims(
    mechanism: Mechanism, symbols: Iterable[Symbol], circles: Iterable[Rimmed]
) -> tuple[Rim, ...]:
    """Every circle once: those of the joints, then those of the hints."""
    found: dict[tuple[str, str, float], Rim] = {}
    of_joints = [rim for symbol in symbols for rim in symbol.rims]
    of_hints = [_find_edge(mechanism, circle) for circle in circles]
    for rim in (*of_joints, *of_hints):
        found.setdefault((rim.body, rim.centre, round(rim.radius, 6)), rim)
    return tuple(found.values())


def _find_edge(mechanism: Mechanism, circle: Rimmed) -> Rim:
    at, touched = mechanism.points[circle.centre], mechanism.points[circle.through]
    return Rim(circle.body, circle.centre, at, length(touched - at), "edge", False, touched)


def order_rims(found: tuple[Rim, ...]) -> tuple[Rim, ...]:
    """Rims from the largest to the smallest, so that none hides another; those of the ground
    first.
    """
    return tuple(sorted(found, key=lambda rim: (rim.body != GROUND, -rim.radius)))
