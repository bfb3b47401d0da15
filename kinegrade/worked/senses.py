"""Senses and directions in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row, Sign, Space, Text
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import bearing, double, is_zero
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.formulas.symbols import read_symbol

_AXES: Mapping[float, Message] = {
    0.0: Message("solution.right"),
    90.0: Message("solution.up"),
    180.0: Message("solution.left"),
    270.0: Message("solution.down"),
}
_APART = Space("quad")


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


def state_rotation_sense(value: Any, case: Case) -> Row:
    """The sense of a rotation beside its value; nothing for zero."""
    sense = find_rotation_sense(value)
    return say_beside(sense, case) if sense else ()


def state_sense_along(
    value: float, positive: Vector, ends: tuple[str, str] | None, case: Case
) -> Row:
    """The direction of a vector beside its value: left, right, up, down, from point to point, or
    by its angle where it points against its positive sense.

    `ends` are points of its line in the positive sense, None where it has none.
    """
    if value == 0:
        return ()
    sense = find_axis_sense(positive if value > 0 else -positive)
    if sense is not None:
        return say_beside(sense, case)
    if ends is not None:
        start, end = map(case.naming.point, ends if value > 0 else reversed(ends))
        way = read_symbol(case.write(Message("solution.from-to", start=start, end=end)))
        return (_APART, Sign("("), *way.row, Sign(")"))
    return () if value > 0 else say_beside(describe_direction(-positive, case), case)


def say_beside(message: Message, case: Case) -> Row:
    """A message in brackets beside a value; its formulas stand between its words."""
    parts = f"({case.write(message)})".split("$")
    read = (read_math(part, "") if place % 2 else (Text(part),) for place, part in enumerate(parts))
    return (_APART, *(node for row in read for node in row))


def state_way(vector: Vector, case: Case) -> Row:
    """The direction of a vector beside its magnitude where it lies along an axis; that of a
    slanting one is told by what it follows from.
    """
    sense = None if is_zero(vector) else find_axis_sense(vector)
    return say_beside(sense, case) if sense else ()


def state_way_about(vector: Vector, arm: Vector, centre: str, case: Case) -> Row:
    """The direction of a velocity or tangential acceleration beside its magnitude: along an axis,
    else in which sense about a point, from which the vector `arm` leads to the moving one.
    """
    if is_zero(vector) or find_axis_sense(vector):
        return state_way(vector, case)
    return state_way_round(centre, double(arm.cross(vector)), case)


def state_way_round(centre: str, turn: float, case: Case) -> Row:
    """In which sense something goes round a point, counter-clockwise where `turn` is positive."""
    point = case.naming.point(centre)
    if turn > 0:
        return say_beside(Message("solution.around", centre=point), case)
    return say_beside(Message("solution.clockwise-about", point=point), case)


def describe_direction(vector: Vector, case: Case) -> Message:
    """The direction of a vector other than zero in prose."""
    sense = find_axis_sense(vector)
    return sense or Message("solution.at-angle", angle=case.text(state_angle(bearing(vector))))
