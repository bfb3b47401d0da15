"""What a belt looks like: two pulleys, and the strands that run straight from rim to rim."""

from __future__ import annotations

from math import sqrt

from kinegrade.figure.joints.symbol import Rim, Strand, Symbol
from kinegrade.figure.plane import length, unit
from kinegrade.mechanics.joints import Belt, Circle
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector


def find_belt_symbol(mechanism: Mechanism, joint: Belt) -> Symbol:
    """Both pulleys with the two strands, each on the common tangent of the rims."""
    strands = tuple(_find_strand(mechanism, joint, side) for side in (1, -1))
    start, end = strands[0]
    return Symbol(
        rims=(
            _find_rim(mechanism, joint.body, joint.circle, start),
            _find_rim(mechanism, joint.of, joint.on, end),
        ),
        strands=strands,
    )


def _find_rim(mechanism: Mechanism, body: str, circle: Circle, touch: Vector) -> Rim:
    at = mechanism.points[circle.centre]
    return Rim(body, circle.centre, at, circle.radius, "wheel", False, touch, touch)


def _find_strand(mechanism: Mechanism, joint: Belt, side: int) -> Strand:
    """From the first rim to the second, leaving the first to the left (1) or right (-1) of the line
    of centres.

    The radii to both ends are parallel, along the unit vector w, which leans towards the second
    centre by w.u = (r1 - r2)/d; those of a crossed belt are opposite: (r1 + r2)/d.
    """
    first, second = mechanism.points[joint.circle.centre], mechanism.points[joint.on.centre]
    radius, other = joint.circle.radius, -joint.on.radius if joint.crossed else joint.on.radius
    along = unit(second - first)
    lean = (radius - other) / length(second - first)
    normal = along * lean + along.turned() * (side * sqrt(1 - lean * lean))
    return first + normal * radius, second + normal * other
