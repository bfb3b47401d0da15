"""The common point of two circles: it is found in the triangle of their centres and the point."""

from __future__ import annotations

from typing import Literal

from kinegrade.expressions.tree import Call, Expression, Name, Operation
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.document import Block, Display
from kinegrade.worked.findings import Seen
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.formula import Function
from kinegrade.worked.formulas.symbols import name_corner
from kinegrade.worked.positions.algebra import (
    TWO,
    ZERO,
    Pair,
    cross,
    minus,
    over,
    plus,
    square,
    times,
)
from kinegrade.worked.positions.axes import length_of
from kinegrade.worked.positions.instance import DEGREE, METRE, PURE, Instance
from kinegrade.worked.positions.shapes import describe_circle
from kinegrade.worked.senses import name_rotation_sense

_NOTHING: Pair = (ZERO, ZERO)


def explain_circles(
    point: str, circles: tuple[Call, Call], instance: Instance
) -> tuple[Block, ...]:
    """The third corner of a triangle with known sides, by the law of cosines."""
    (first, radius), (second, opposite) = (circle.arguments for circle in circles)
    name, start, end = (instance.text(corner) for corner in (Name(point), first, second))
    left = turns_left(point, first, second, instance)
    axis, towards = Call("distance", (first, second)), Call("direction", (first, second))
    cosine = _solve_for_cosine(radius, opposite, axis)
    corner = instance.free("corner")
    angle = instance.value(Call("acos", (cosine,)))
    opened = instance.named(corner, _name_corner((second, first, Name(point)), instance), angle)
    turned = (plus if left else minus)(towards, Name(corner))
    seen = Seen(turned, corner, opened.symbols[corner], angle)
    instance.case.findings.seen[first, Name(point)] = seen
    placed = Call("polar", (first, radius, turned))
    sense = name_rotation_sense(left)
    return (
        instance.say(_describe_triangle(point, circles, left, instance)),
        Display(_solve_triangle(axis, cosine, corner, opened)),
        instance.say(
            Message("solution.triangle-side", point=name, first=start, second=end, sense=sense),
        ),
        Display(
            (
                *opened.equation(opened.formula(towards), towards, DEGREE),
                *opened.coordinates(point, opened.axes.pair(placed) or _NOTHING),
            )
        ),
    )


def _name_corner(points: tuple[Expression, ...], instance: Instance) -> Symbol:
    """The angle at the second of three points, each as its letters."""
    rows = (instance.formula(point).print() for point in points)
    return name_corner(Symbol(row) for row in rows)


def _describe_triangle(
    point: str, circles: tuple[Call, Call], left: bool, instance: Instance
) -> Message:
    """Where the common point of two circles lies, and what the triangle of the centres gives."""
    name = instance.letter(point)
    start, end = (instance.text(circle.arguments[0]) for circle in circles)
    side: Literal["left", "right"] = "left" if left else "right"
    place = Message(
        f"solution.circles-meet-{side}",
        point=name,
        first=describe_circle(circles[0], instance),
        second=describe_circle(circles[1], instance),
        start=start,
        end=end,
    )
    triangle = Message("solution.triangle", point=name, first=start, second=end)
    return Message("solution.sentences", first=place, next=triangle)


def _solve_for_cosine(radius: Expression, opposite: Expression, axis: Expression) -> Expression:
    """The law of cosines, solved for the cosine of the angle between `radius` and `axis`."""
    above = minus(plus(square(radius), square(axis)), square(opposite))
    return over(above, times(times(TWO, radius), axis))


def _solve_triangle(
    axis: Call, cosine: Expression, corner: str, instance: Instance
) -> tuple[Row, ...]:
    """The side between the centres, the cosine, and the angle."""
    vector = instance.axes.pair(Operation("-", axis.arguments[1], axis.arguments[0])) or _NOTHING
    angle = instance.symbols[corner]
    instance.note_distance(axis)
    return (
        *instance.equation(
            instance.formula(axis), length_of(Call("", vector), instance.axes), METRE
        ),
        *instance.equation(Function("cos", angle), cosine, PURE),
        *instance.equation(angle, Name(corner), DEGREE),
    )


def turns_left(point: str, first: Expression, second: Expression, instance: Instance) -> bool:
    """Whether a point lies to the left of the directed line from the first to the second."""
    axes = instance.axes
    axis, arm = (
        axes.pair(Operation("-", second, first)),
        axes.pair(Operation("-", Name(point), first)),
    )
    return instance.sign(cross(axis or _NOTHING, arm or _NOTHING)) >= 0
