"""Senses and directions in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.formulas.numbers import bearing, double, write_angle
from kinegrade.worked.words.solution_case import Case

_AXES: Mapping[float, Message] = {
    0.0: Message("solution.right"),
    90.0: Message("solution.up"),
    180.0: Message("solution.left"),
    270.0: Message("solution.down"),
}


def find_axis_sense(vector: Vector) -> Message | None:
    """To which side a vector points along an axis; None for a slanting one."""
    return _AXES.get(bearing(vector))


def find_rotation_sense(value: Any) -> Message | None:
    """Clockwise or counter-clockwise, None for zero."""
    number = double(value)
    return None if number == 0 else name_rotation_sense(number > 0)


def name_rotation_sense(counter_clockwise: bool) -> Message:
    """The sense of a rotation."""
    if counter_clockwise:
        return Message("solution.counter-clockwise")
    return Message("solution.clockwise")


def write_rotation_sense(value: Any, case: Case) -> str:
    """The sense of a rotation as a text within an equation; nothing for zero."""
    sense = find_rotation_sense(value)
    return write_beside_value(sense, case) if sense else ""


def write_sense_along(
    value: float, positive: Vector, ends: tuple[str, str] | None, case: Case
) -> str:
    """The direction of a vector as a text within an equation: left, right, up, down, from point to
    point, or reversed.

    `ends` are points of its line in the positive sense, None where it has none.
    """
    if value == 0:
        return ""
    sense = find_axis_sense(positive if value > 0 else -positive)
    if sense is not None:
        return write_beside_value(sense, case)
    if ends is not None:
        start, end = map(case.naming.point, ends if value > 0 else reversed(ends))
        return rf"\quad({case.write(Message('solution.from-to', start=start, end=end))})"
    return "" if value > 0 else write_beside_value(Message("solution.opposite"), case)


def write_beside_value(message: Message, case: Case) -> str:
    """A message in brackets, as a text within an equation after its value."""
    return rf"\quad\text{{({case.write(message)})}}"


def describe_direction(vector: Vector) -> Message:
    """The direction of a vector other than zero in prose."""
    sense = find_axis_sense(vector)
    return sense or Message("solution.at-angle", angle=write_angle(bearing(vector)))


def is_zero(vector: Vector) -> bool:
    """Whether a vector has no direction."""
    return not double(vector.x) and not double(vector.y)
