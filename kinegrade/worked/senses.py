"""Senses and directions in words."""

from __future__ import annotations

from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.worked.numbers import bearing, double, write_angle
from kinegrade.worked.phrases import fill_phrase
from kinegrade.worked.solution_case import Case

_AXES = {0.0: "right", 90.0: "up", 180.0: "left", 270.0: "down"}


def write_rotation_sense(value: Any, case: Case) -> str:
    """The sense of a rotation as a text within an equation; nothing for zero."""
    words = describe_rotation(value, case)
    return rf"\quad\text{{({words})}}" if words else ""


def describe_rotation(value: Any, case: Case) -> str:
    """Clockwise or counter-clockwise, "" for zero."""
    number = double(value)
    return "" if number == 0 else fill_phrase("ccw" if number > 0 else "cw", case.language)


def write_sense_along(
    value: float, positive: Vector, ends: tuple[str, str] | None, case: Case
) -> str:
    """The direction of a vector as a text within an equation: left, right, up, down, from point to
    point, or reversed.

    `ends` are points of its line in the positive sense, None where it has none.
    """
    if value == 0:
        return ""
    angle = bearing(positive if value > 0 else -positive)
    if angle in _AXES:
        return rf"\quad\text{{({fill_phrase(_AXES[angle], case.language)})}}"
    if ends is not None:
        start, end = map(case.naming.point, ends if value > 0 else reversed(ends))
        return rf"\quad({fill_phrase('from_to', case.language, start=start, end=end)})"
    return "" if value > 0 else rf"\quad\text{{({fill_phrase('opposite', case.language)})}}"


def describe_direction(vector: Vector, case: Case) -> str:
    """The direction of a vector in prose, "" for a zero vector."""
    if not double(vector.x) and not double(vector.y):
        return ""
    angle = bearing(vector)
    if angle in _AXES:
        return fill_phrase(_AXES[angle], case.language)
    return fill_phrase("at_angle", case.language, angle=f"${write_angle(angle)}$")
