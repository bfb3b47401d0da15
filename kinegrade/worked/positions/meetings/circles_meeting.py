"""The common point of two circles: it is found in the triangle of their centres and the point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, assert_never

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.document import Block, Display
from kinegrade.worked.findings import Seen
from kinegrade.worked.formulas.atoms import Symbol, add_terms
from kinegrade.worked.formulas.equation import approximate, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import name_corner
from kinegrade.worked.positions.algebra import (
    TWO,
    ZERO,
    Pair,
    cross,
    is_negated,
    make_positive,
    minus,
    over,
    plus,
    square,
    times,
)
from kinegrade.worked.positions.instance import DEGREE, METRE, PURE, Instance
from kinegrade.worked.positions.right_angles import split_right_angles
from kinegrade.worked.positions.shapes import describe_circle
from kinegrade.worked.senses import name_rotation_sense

_NOTHING: Pair = (ZERO, ZERO)
STRAIGHT = Name("pi")
_SENSES: Mapping[str, int] = {"+": 1, "-": -1}


def explain_circles(
    point: str, circles: tuple[Call, Call], instance: Instance
) -> tuple[Block, ...]:
    """The third corner of a triangle with known sides, by the law of cosines."""
    (first, radius), (second, opposite) = (circle.arguments for circle in circles)
    name, start, end = (instance.text(corner) for corner in (Name(point), first, second))
    left = turns_left(point, first, second, instance)
    axis, side = Call("distance", (first, second)), _find_side(first, second, instance)
    cosine = _solve_for_cosine(radius, opposite, axis)
    corner = instance.free("corner")
    angle = instance.value(Call("acos", (cosine,)))
    opened = instance.named(corner, _name_corner((second, first, Name(point)), instance), angle)
    turned = _tidy((plus if left else minus)(side.direction, Name(corner)), opened)
    seen = Seen(turned, corner, opened.symbols[corner], angle)
    instance.case.findings.seen[first, Name(point)] = seen
    if isinstance(side.direction, Call):
        instance.case.findings.seen[first, second] = replace(seen, tree=side.direction)
    placed = Call("polar", (first, radius, turned))
    sense = name_rotation_sense(left)
    return (
        instance.say(_describe_triangle(point, circles, left, instance)),
        Display(_solve_triangle(axis, side, cosine, (corner, opened))),
        *_name_quadrant(side.direction, instance),
        instance.say(
            Message("solution.triangle-side", point=name, first=start, second=end, sense=sense),
        ),
        Display(
            (
                *find_direction(side.direction, opened),
                *_work_out_sum(turned, opened),
                *opened.coordinate_lines(point, opened.axes.pair(placed) or _NOTHING),
            )
        ),
    )


@dataclass(frozen=True)
class _Side:
    """The side between the centres: its length and its direction from the first one."""

    length: Expression
    direction: Expression


def _find_side(first: Expression, second: Expression, instance: Instance) -> _Side:
    """As it is given, where one centre is placed from the other one by distance and direction, or
    along the x axis; else by coordinates.
    """
    towards = _find_given_side(first, second, instance)
    back = _find_given_side(second, first, instance)
    if towards is not None:
        return towards
    if back is not None:
        return _Side(back.length, plus(back.direction, STRAIGHT))
    vector = instance.axes.pair(Operation("-", second, first)) or _NOTHING
    size = instance.measure(vector)
    if vector[1] == ZERO:
        return _Side(size, ZERO if instance.sign(vector[0]) > 0 else STRAIGHT)
    return _Side(size, Call("direction", (first, second)))


def find_direction(direction: Expression, instance: Instance) -> tuple[Row, ...]:
    """The direction from one point to another by coordinates, where it is not given."""
    if not isinstance(direction, Call):
        return ()
    start, end = direction.arguments
    x, y = instance.axes.pair(Operation("-", end, start)) or _NOTHING
    angle = instance.formula(direction)
    slope = () if x == ZERO else instance.equation(Function("tan", angle), over(y, x), PURE)
    return (*slope, *instance.equation(angle, direction, DEGREE))


def _name_quadrant(direction: Expression, instance: Instance) -> Iterator[Block]:
    """Where a direction by coordinates lies, of the two that have its tangent."""
    if isinstance(direction, Call):
        start, end = direction.arguments
        x, y = instance.axes.pair(Operation("-", end, start)) or _NOTHING
        ends = {"first": instance.text(start), "second": instance.text(end)}
        if instance.sign(x) < 0 < instance.sign(y):
            yield instance.say(Message("solution.leads-up-left", **ends))
        if instance.sign(x) < 0 and instance.sign(y) < 0:
            yield instance.say(Message("solution.leads-down-left", **ends))


def _work_out_sum(direction: Expression, instance: Instance) -> tuple[Row, ...]:
    """What the angle comes to whose sine and cosine follow, where it is a sum."""
    _, rest, _ = split_right_angles(direction)
    positive = make_positive(rest, instance.sign(rest))
    angle = rest if is_negated(positive) else positive
    terms = tuple(_list_terms(angle))
    if len(terms) == 1:
        return ()
    numbers = (_state_angle(term, instance).signed(sign) for sign, term in terms)
    value = _state_angle(angle, instance)
    links = (*equate(add_terms(numbers)), *approximate(value))
    return instance.lines(instance.formula(angle, True), links)


def _list_terms(angle: Expression) -> Iterator[tuple[int, Expression]]:
    """The terms of a sum with their signs."""
    match angle:
        case Operation(sign="+" | "-" as sign, left=left, right=right):
            yield from _list_terms(left)
            turned = _SENSES[sign]
            yield from ((turned * one, term) for one, term in _list_terms(right))
        case Operation() | Call() | Name() | Number():
            yield 1, angle
        case _:
            assert_never(angle)


def _state_angle(angle: Expression, instance: Instance) -> Formula:
    """An angle in degrees, rounded."""
    *_, rounded = state_quantity(instance.quantity(instance.value(angle), DEGREE))
    return rounded.right


def _find_given_side(start: Expression, end: Expression, instance: Instance) -> _Side | None:
    """The distance and direction by which the second point is placed from the first one."""
    for step in instance.steps:
        match step.tree:
            case Call("polar", (base, size, angle)):
                if (Name(step.point), base) == (end, start) and instance.sign(size) > 0:
                    return _Side(size, angle)
            case Number() | Name() | Operation() | Call():
                continue
            case _:
                assert_never(step.tree)
    return None


def _tidy(angle: Expression, instance: Instance) -> Expression:
    """A direction as right angles and a positive rest."""
    sign, rest, quarters = split_right_angles(angle)
    found = instance.sign(rest)
    sized = make_positive(rest, found)
    turned = over(times(read_expression(str(quarters)), STRAIGHT), TWO)
    return (plus if sign * found > 0 else minus)(turned, sized)


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
    axis: Call, side: _Side, cosine: Expression, opened: tuple[str, Instance]
) -> tuple[Row, ...]:
    """The side between the centres, the cosine, and the angle, which is named in the instance."""
    corner, instance = opened
    angle = instance.symbols[corner]
    instance.note_distance(axis)
    return (
        *instance.equation(instance.formula(axis), side.length, METRE),
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
