"""A mechanism with plain floats, for drawing; never for answers."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector


def drawable_mechanism(mechanism: Mechanism) -> Mechanism:
    """The same mechanism with every number a float."""
    return Mechanism(
        {name: in_floats(point) for name, point in mechanism.points.items()},
        mechanism.bodies,
        tuple(in_floats(joint) for joint in mechanism.joints),
        tuple(in_floats(driver) for driver in mechanism.drivers),
    )


def in_floats(part: Any) -> Any:
    """A vector, line, circle, joint or driver with its numbers as floats; names are unchanged."""
    if isinstance(part, Vector):
        return Vector(float(part.x), float(part.y))
    if is_dataclass(part) and not isinstance(part, type):
        return replace(
            part, **{field.name: in_floats(getattr(part, field.name)) for field in fields(part)}
        )
    if isinstance(part, (str, bool, tuple)):
        return part
    return float(part)
