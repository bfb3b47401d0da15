"""The direction along which a distance is measured."""

from __future__ import annotations

from typing import assert_never

from kinegrade.figure.plane import unit
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Projection


def find_measured_direction(along: Projection | None, start: Vector, end: Vector) -> Vector:
    """The unit vector along which a distance is measured."""
    match along:
        case "horizontal":
            return Vector(1.0, 0.0)
        case "vertical":
            return Vector(0.0, 1.0)
        case None:
            return unit(end - start)
        case _:
            assert_never(along)
