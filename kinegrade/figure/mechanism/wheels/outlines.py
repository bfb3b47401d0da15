"""The outlines of round bodies: circles, the profiles of cams, and what lies around several
circles of one cam.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import pi

from kinegrade.figure.joints.symbol import Kind, Rim, Symbol, find_fixed_pin
from kinegrade.figure.mechanism.wheels.cam import trace_cam_profile
from kinegrade.figure.plane import hull, polar
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.figure.teeth import TOOTH_TIP
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

RING = 2.4  # millimetres of material around a circle that encloses others
_MARGINS: Mapping[Kind, float] = {
    "wheel": 0.0,
    "gear": TOOTH_TIP,
    "slot": BAR_WIDTH / 2,
    "cam": 0.0,
    "edge": 0.0,
}
_STEPS = 180  # corners of a circle within an outline, two degrees apart


def trace_outlines(
    mechanism: Mechanism, shapes: Mapping[str, str], joints: Sequence[Symbol], rims: Sequence[Rim]
) -> Iterator[tuple[Vector, ...]]:
    """The outer outline of each circle of one body, counter-clockwise; of the circles of a cam the
    one around them all.
    """
    for rim in rims:
        if rim.kind == "cam":
            yield hull(trace_cam_outline(mechanism, joints, rim))
        elif rim.kind == "edge" and shapes.get(rim.body) == "cam":
            yield trace_around([each for each in rims if each.kind == "edge"])
        else:
            yield _trace_circle(rim.at, find_outer_radius(rim))


def find_outer_radius(rim: Rim) -> float:
    """The radius of a circle with the material outside it: of a ring, about a slot, of teeth."""
    if rim.ring:
        return rim.radius + RING
    return rim.radius + _MARGINS[rim.kind]


def trace_around(rims: Sequence[Rim]) -> tuple[Vector, ...]:
    """The outline around circles, as a taut belt would lie about them."""
    return hull(at for rim in rims for at in _trace_circle(rim.at, rim.radius))


def trace_cam_outline(
    mechanism: Mechanism, joints: Sequence[Symbol], rim: Rim
) -> tuple[Vector, ...]:
    """The profile of a cam about its fixed pin, in the unit of the mechanism."""
    return trace_cam_profile(find_pivot(mechanism, joints, rim), rim.touch, rim.at, rim.radius)


def find_pivot(mechanism: Mechanism, joints: Sequence[Symbol], rim: Rim) -> Vector:
    """The fixed pin of the body of a circle; its centre where there is none."""
    pin = find_fixed_pin(joints, rim.body)
    return rim.at if pin is None else mechanism.points[pin]


def _trace_circle(at: Vector, radius: float) -> tuple[Vector, ...]:
    turns = [2 * pi * number / _STEPS for number in range(_STEPS)]
    return tuple(at + polar(turn, radius) for turn in turns)
