"""Senses and directions in words."""

from __future__ import annotations

from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.worked.numbers import angle_text, bearing, double
from kinegrade.worked.phrases import phrase
from kinegrade.worked.solution_case import Case

AXES = {0.0: "right", 90.0: "up", 180.0: "left", 270.0: "down"}


def sense_of_rotation(value: Any, case: Case) -> str:
    """The sense of a rotation as a text within an equation; nothing for zero."""
    words = rotation_words(value, case)
    return rf"\quad\text{{({words})}}" if words else ""


def rotation_words(value: Any, case: Case) -> str:
    """Clockwise or counter-clockwise, "" for zero."""
    number = double(value)
    return "" if number == 0 else phrase("ccw" if number > 0 else "cw", case.language)


def sense_along(value: float, positive: Vector, ends: tuple[str, str] | None, case: Case) -> str:
    """The direction of a vector as a text within an equation: left, right, up, down, from point to
    point, or reversed.

    `ends` are points of its line in the positive sense, None where it has none.
    """
    if value == 0:
        return ""
    angle = bearing(positive if value > 0 else -positive)
    if angle in AXES:
        return rf"\quad\text{{({phrase(AXES[angle], case.language)})}}"
    if ends is not None:
        start, end = map(case.naming.point, ends if value > 0 else reversed(ends))
        return rf"\quad({phrase('from_to', case.language, start=start, end=end)})"
    return "" if value > 0 else rf"\quad\text{{({phrase('opposite', case.language)})}}"


def direction_words(vector: Vector, case: Case) -> str:
    """The direction of a vector in prose, "" for a zero vector."""
    if not double(vector.x) and not double(vector.y):
        return ""
    angle = bearing(vector)
    if angle in AXES:
        return phrase(AXES[angle], case.language)
    return phrase("at_angle", case.language, angle=f"${angle_text(angle)}$")
