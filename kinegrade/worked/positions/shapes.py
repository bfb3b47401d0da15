"""Lines and circles in the sentences of a worked solution, and which of their common points is
meant.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from kinegrade.expressions.tree import SIDES_OF, Call, Expression, Name, Number, Operation
from kinegrade.language.message import Message
from kinegrade.worked.formulas.leaves import count_quarter_turns
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.instance import Instance

_SIDES: Mapping[str, Message] = {
    "right": Message("solution.right-one"),
    "left": Message("solution.left-one"),
    "upper": Message("solution.upper-one"),
    "lower": Message("solution.lower-one"),
}


def describe_line(line: Call, instance: Instance) -> Message:
    """A line in a sentence."""
    start, toward = line.arguments
    point = instance.text(start)
    if instance.axes.is_vector(toward):
        second = instance.text(toward)
        return Message("solution.line-between", first=point, second=second)
    quarters, place = count_quarter_turns(toward), instance.axes.pair(start)
    if quarters is None:
        angle = instance.text(toward, degrees=True)
        return Message("solution.slanting-line", point=point, angle=angle)
    if quarters % 2:
        on_axis = place is not None and place[0] == ZERO
        return (
            Message("solution.y-axis") if on_axis else Message("solution.upright-line", point=point)
        )
    on_axis = place is not None and place[1] == ZERO
    return Message("solution.x-axis") if on_axis else Message("solution.level-line", point=point)


def describe_circle(circle: Call, instance: Instance) -> Message:
    """A circle in a sentence."""
    centre, radius = circle.arguments
    return Message("solution.circle", centre=instance.text(centre), radius=instance.text(radius))


def describe_side(branch: Expression, instance: Instance) -> Message | None:
    """Which of two common points is meant; None where the branch tells them apart for two circles
    alone.
    """
    match branch:
        case Name(name):
            return _SIDES.get(name)
        case Call(function, (start, end)):
            side = "left" if function == SIDES_OF["left"] else "right"
            ends = {"start": instance.text(start), "end": instance.text(end)}
            return Message(f"solution.{side}-of-one", **ends)
        case Call() | Number() | Operation():
            return None
        case _:
            assert_never(branch)


def describe_chord_end(
    point: str, line: Call, circle: Call, side: Message | None, instance: Instance
) -> Message:
    """Which of the common points of a line and a circle is meant; where no side tells, they touch
    in one.
    """
    name = instance.letter(point)
    path, round_ = describe_line(line, instance), describe_circle(circle, instance)
    if side is not None:
        return Message(
            "solution.line-meets-circle", point=name, side=side, line=path, circle=round_
        )
    return Message("solution.line-touches-circle", point=name, line=path, circle=round_)
