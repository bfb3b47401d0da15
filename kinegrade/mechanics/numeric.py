"""A mechanism with plain floats, for drawing; never for answers."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector


def convert_to_floats(mechanism: Mechanism) -> Mechanism:
    """The same mechanism with every number a float."""
    return Mechanism(
        {name: convert_value(point) for name, point in mechanism.points.items()},
        mechanism.bodies,
        tuple(convert_value(joint) for joint in mechanism.joints),
        tuple(convert_value(driver) for driver in mechanism.drivers),
    )


def convert_value(part: Any) -> Any:
    """A vector, line, circle, joint or driver with its numbers as floats; names are unchanged."""
    if isinstance(part, Vector):
        return Vector(float(part.x), float(part.y))
    if is_dataclass(part) and not isinstance(part, type):
        return replace(
            part, **{field.name: convert_value(getattr(part, field.name)) for field in fields(part)}
        )
    if isinstance(part, (str, bool, tuple)):
        return part
    return float(part)
