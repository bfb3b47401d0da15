"""Where a point lies, in a sentence that follows its construction."""

from __future__ import annotations

from typing import Literal, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, list_parts
from kinegrade.language.message import Message
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.meetings.circles_meeting import turns_left
from kinegrade.worked.positions.polar import find_polar_way, write_positive
from kinegrade.worked.positions.shapes import describe_circle, describe_line, describe_side
from kinegrade.worked.positions.vectors import describe_vector, negate, write_way


def say_place(step: Step, instance: Instance) -> Message:
    """Where the point of a step lies."""
    point = instance.letter(step.point)
    match step.tree:
        case Name(name):
            return Message("description.coincides", point=point, other=instance.letter(name))
        case Call(function, arguments):
            return _say_construction(step, function, arguments, instance)
        case Operation(sign="+" | "-" as sign, left=Name(base), right=right):
            vector = {"+": right, "-": negate(right, instance)}[sign]
            return Message(
                "description.displaced",
                point=point,
                base=instance.letter(base),
                vector=describe_vector(vector, instance),
            )
        case Number() | Operation():
            return _say_coordinates(step, instance)
        case _:
            assert_never(step.tree)


def _say_construction(
    step: Step, function: str, arguments: tuple[Expression, ...], instance: Instance
) -> Message:
    """Where a point lies by the construction of that name."""
    point = instance.letter(step.point)
    match function, arguments:
        case "polar", (centre, radius, angle):
            return _say_polar(point, (centre, radius, angle), instance)
        case "midpoint", (Name(first), Name(second)):
            ends = {"first": instance.letter(first), "second": instance.letter(second)}
            return Message("description.midpoint", point=point, **ends)
        case "toward", (start, end, distance):
            return _say_reached(point, (start, end, distance), instance)
        case "foot", (source, Call() as line):
            return Message(
                "description.foot",
                point=point,
                source=instance.text(source),
                line=describe_line(line, instance),
            )
        case "meet", (Call() as first, Call() as second, *branch):
            return _say_meeting(step, (first, second), branch, instance)
        case _:
            return _say_coordinates(step, instance)


def _say_polar(
    point: str, parts: tuple[Expression, Expression, Expression], instance: Instance
) -> Message:
    way = find_polar_way(parts, instance)
    named = {"point": point, "centre": way.centre, "radius": way.distance}
    if way.heading is not None:
        return Message(f"description.towards-{way.heading}", **named)
    if way.against:
        return Message("description.polar-against", **named, angle=way.angle)
    return Message("description.polar", **named, angle=way.angle)


def _say_reached(
    point: str, parts: tuple[Expression, Expression, Expression], instance: Instance
) -> Message:
    """A point at a distance from one point towards another, or along a vector."""
    start, end, distance = parts
    size, against = write_positive(distance, instance)
    named = {"point": point, "start": instance.text(start), "distance": size}
    match end:
        case Name():
            ray = "on-opposite-ray" if against else "on-ray"
            return Message(f"description.{ray}", **named, end=instance.text(end))
        case Number() | Operation() | Call():
            vector = write_way(start, end, instance)
            way = describe_vector(negate(vector, instance) if against else vector, instance)
            return Message("description.along-vector", **named, vector=way)
        case _:
            assert_never(end)


def _say_meeting(
    step: Step, shapes: tuple[Call, Call], branch: list[Expression], instance: Instance
) -> Message:
    """The point in which two lines, a line and a circle, or two circles meet."""
    point = instance.letter(step.point)
    lines = [shape for shape in shapes if shape.function == "line"]
    circles = [shape for shape in shapes if shape.function == "circle"]
    if len(circles) == 2:
        return _say_circles(step.point, shapes, instance)
    if len(lines) == 2:
        first, second = (describe_line(line, instance) for line in lines)
        return Message("description.lines-meet", point=point, first=first, second=second)
    named = {
        "line": describe_line(lines[0], instance),
        "circle": describe_circle(circles[0], instance),
    }
    side = describe_side(branch[0], instance) if branch else None
    if side is None:
        return Message("description.line-touches-circle", point=point, **named)
    return Message("description.line-meets-circle", point=point, side=side, **named)


def _say_circles(point: str, circles: tuple[Call, Call], instance: Instance) -> Message:
    first, second = (list_parts(circle)[0] for circle in circles)
    side: Literal["left", "right"] = (
        "left" if turns_left(point, first, second, instance) else "right"
    )
    return Message(
        f"description.circles-meet-{side}",
        point=instance.letter(point),
        first=describe_circle(circles[0], instance),
        second=describe_circle(circles[1], instance),
        start=instance.text(first),
        end=instance.text(second),
    )


def _say_coordinates(step: Step, instance: Instance) -> Message:
    """The coordinates of a point as its construction gives them."""
    x, y = instance.axes.pair(step.tree) or (ZERO, ZERO)
    point = instance.letter(step.point)
    if (x, y) == (ZERO, ZERO):
        return Message("description.origin", point=point)
    return Message("description.coordinates", point=point, x=instance.text(x), y=instance.text(y))
