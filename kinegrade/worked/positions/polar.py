"""Inclinations in sentences: of a point at a distance from a centre in a direction, and of a line
that makes a marked angle with another one.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations
from math import degrees
from typing import Literal, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names, walk
from kinegrade.language.message import Message
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.problem.template.hints import Angle as Mark
from kinegrade.worked.formulas.leaves import count_quarter_turns
from kinegrade.worked.formulas.measures import bearing, is_zero
from kinegrade.worked.formulas.symbols import join_letters, name_point, read_symbol
from kinegrade.worked.positions.algebra import TWO, ZERO, is_negated, minus, plus
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.marked_angles import find_marked_given
from kinegrade.worked.positions.right_angles import split_right_angles
from kinegrade.worked.positions.stated_angles import find_stated_tree

_Heading = Literal["x", "y", "minus-x", "minus-y"]
_RIGHT, _CLOSE, _DIGITS = 90.0, 1e-6, 15
_AXIS_NAMES = {0.0: Message("solution.projection-x"), 90.0: Message("solution.projection-y")}
_WAYS = (
    Message("solution.points-up-right"),
    Message("solution.points-up-left"),
    Message("solution.points-down-left"),
    Message("solution.points-down-right"),
)
_HEADINGS: tuple[_Heading, ...] = ("x", "y", "minus-x", "minus-y")  # by quarter turns


@dataclass(frozen=True)
class PolarWay:
    """From a centre along an axis, where `heading` names it, else in the direction of an angle or,
    `against` it, in the opposite one; distances are positive.
    """

    centre: str
    distance: str
    angle: str
    heading: _Heading | None
    against: bool


def find_polar_way(
    parts: tuple[Expression, Expression, Expression], instance: Instance
) -> PolarWay:
    """Distance and direction from a centre; a negative distance becomes one in the opposite
    direction.
    """
    centre, radius, angle = parts
    quarters = count_quarter_turns(angle)
    distance, against = write_positive(radius, instance)
    return PolarWay(
        instance.text(centre),
        distance,
        instance.text(_put_positive_first(_add_right_angles(angle)), degrees=True),
        None if quarters is None else _HEADINGS[(quarters + 2 * against) % 4],
        against,
    )


def describe_inclination(
    point: str, place: tuple[Expression, Expression, Expression], instance: Instance
) -> Message | None:
    """Which acute angle the line from the centre makes with an axis, and to where it points; None
    where it lies along one, or its angle is not made of letters.
    """
    centre, radius, angle = place
    points = instance.case.motion.points
    lettered = not any(isinstance(part, Call) for part in walk(angle))
    if not isinstance(centre, Name) or not {centre.name, point} <= points.keys() or not lettered:
        return None
    _, rest, quarters = split_right_angles(angle)
    axis = quarters % 2 * _RIGHT
    found = _find_inclination((centre.name, point), rest, instance, axis)
    if found is None:
        return None
    told, way = found
    line, back = (
        instance.case.text(join_letters(map(name_point, ends)))
        for ends in ((centre.name, point), (point, centre.name))
    )
    distance, axis_name = write_positive(radius, instance)[0], _AXIS_NAMES[axis]
    if distance in (line, back):
        named = {"line": line, "angle": told}
        return Message("solution.line-inclined", **named, axis=axis_name, way=way)
    return Message(
        "solution.polar-inclined",
        point=instance.letter(point),
        centre=instance.text(centre),
        radius=distance,
        line=line,
        angle=told,
        axis=axis_name,
        way=way,
    )


def derive_inclination(angle: Expression, instance: Instance) -> Message | None:
    """How the angle of a line with the x axis follows from that of another line and the angle that
    the figure marks between the two; None where it marks none of which the angle is made.
    """
    derived = (
        _derive_by_mark(angle, mark, sides, instance)
        for mark in instance.case.template.figure.angles
        for sides in permutations((mark.start, mark.end))
    )
    return next(filter(None, derived), None)


def _derive_by_mark(
    angle: Expression, mark: Mark, sides: tuple[str, ...], instance: Instance
) -> Message | None:
    """The same by one mark, from the line through its first side to that through the second."""
    case, (known, other) = instance.case, sides
    given = find_marked_given(mark, case)
    if given is None or not {mark.at, *sides} <= case.motion.points.keys():
        return None
    stated = find_stated_tree((mark.at, known), case)
    if stated is None or {given, *find_names(stated[1])} != {*find_names(angle)}:
        return None
    first = _find_inclination((mark.at, known), stated[1], instance)
    second = _find_inclination((mark.at, other), angle, instance)
    if first is None or second is None:
        return None
    return Message(
        "solution.inclined-from-corner",
        known=_write_letters((mark.at, known), instance),
        first=first[0],
        towards=first[1],
        corner=_write_letters((known, mark.at, other), instance),
        given=case.text(read_symbol(mark.symbol)),
        line=_write_letters((mark.at, other), instance),
        angle=second[0],
        way=second[1],
        axis=_AXIS_NAMES[0.0],
    )


def _find_inclination(
    ends: tuple[str, str], angle: Expression, instance: Instance, axis: float = 0.0
) -> tuple[str, Message] | None:
    """The acute angle in letters that a line makes with an axis, by its degrees, and to where it
    points.
    """
    start, end = (instance.case.motion.points[point] for point in ends)
    heading = bearing(end - start)
    told = _find_acute(angle, abs((heading - axis + _RIGHT) % (2 * _RIGHT) - _RIGHT), instance)
    if told is None or not heading % _RIGHT:
        return None
    return told, _WAYS[int(heading // _RIGHT)]


def _write_letters(points: tuple[str, ...], instance: Instance) -> str:
    return instance.case.text(join_letters(map(instance.case.naming.letter, points)))


def _find_acute(angle: Expression, size: float, instance: Instance) -> str | None:
    """An angle in letters that has a size in degrees, up to its sign and half a turn."""
    half = Name("pi")
    for one in (angle, minus(ZERO, angle), minus(half, angle), minus(angle, half)):
        value = degrees(float(write_decimal(instance.value(one), _DIGITS)))
        if abs(value - size) < _CLOSE:
            return instance.text(one, degrees=True)
    return None


def find_parallelogram(
    point: str, place: tuple[Expression, Expression], instance: Instance
) -> Message | None:
    """That a point forms a parallelogram with its centre and the two points whose distance its
    radius is called by; None where the radius is not called so.
    """
    centre, radius = place
    points = instance.case.motion.points
    if not isinstance(centre, Name) or not isinstance(radius, Name) or point not in points:
        return None
    side = points[point] - points[centre.name]
    others = [name for name in points if name not in (point, centre.name)]
    for start, end in permutations(others, 2):
        letters = join_letters(map(name_point, (start, end)))
        back = join_letters(map(name_point, (end, start)))
        called = instance.symbols[radius.name] in (letters, back)
        if called and is_zero(points[end] - points[start] - side):
            corners = (centre.name, point, end, start)
            places = zip(("first", "second", "third", "fourth"), corners, strict=True)
            named = {place: instance.letter(corner) for place, corner in places}
            return Message("solution.parallelogram", **named)
    return None


def write_positive(distance: Expression, instance: Instance) -> tuple[str, bool]:
    """A distance without its sign, and whether it counts the other way."""
    against = instance.sign(distance) < 0
    return instance.text(minus(ZERO, distance) if against else distance), against


def _add_right_angles(angle: Expression) -> Expression:
    """An angle with several right angles as one with their sum in front."""
    several = sum(part == Name("pi") for part in walk(angle)) > 1
    sign, rest, quarters = split_right_angles(angle)
    if not several or quarters == 0:
        return angle
    right = Operation("*", Number(quarters), Operation("/", Name("pi"), TWO))
    return plus(right, rest) if sign > 0 else minus(right, rest)


def _put_positive_first(angle: Expression) -> Expression:
    """An angle whose sum does not begin with a minus sign where it need not."""
    match angle:
        case Operation("+", left, right) if is_negated(left):
            return minus(right, left.right)
        case Operation("+" | "-" as sign, left, right):
            return Operation(sign, _put_positive_first(left), right)
        case Number() | Name() | Operation() | Call():
            return angle
        case _:
            assert_never(angle)
