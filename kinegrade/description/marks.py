"""The marks of the figure in sentences, and on which side of another a point lies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, assert_never

from kinegrade.description.subject import Subject
from kinegrade.figure.marks.sweep import find_sweep
from kinegrade.figure.plane import angle_of
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Letter
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import SIDES, BodyFrame, Length, Side
from kinegrade.problem.template.hints import Angle as MarkedAngle

RightAngle = tuple[str, str, str]
Mark = Length | MarkedAngle | RightAngle
_Sector = Literal[
    "right", "upper-right", "above", "upper-left", "left", "lower-left", "below", "lower-right"
]
_SECTORS: dict[tuple[int, int], _Sector] = {
    (1, 0): "right",
    (1, 1): "upper-right",
    (0, 1): "above",
    (-1, 1): "upper-left",
    (-1, 0): "left",
    (-1, -1): "lower-left",
    (0, -1): "below",
    (1, -1): "lower-right",
}
TOWARDS: dict[Side, Vector] = {
    "right": Vector(1.0, 0.0),
    "up": Vector(0.0, 1.0),
    "left": Vector(-1.0, 0.0),
    "down": Vector(0.0, -1.0),
}
_SAME = 1e-9  # m
_WHERE = Message("typesetting.place-worked-solution")


def list_marks(subject: Subject) -> tuple[Mark, ...]:
    """The measures that the figure marks between points that are described; those by a length that
    only its ends name, such as k AB, come last.
    """
    lengths = sorted(subject.marks.lengths, key=lambda length: _names_points(length, subject))
    marks: tuple[Mark, ...] = (*subject.marks.right_angles, *subject.marks.angles, *lengths)
    return tuple(mark for mark in marks if set(list_ends(mark)) <= subject.points)


def _names_points(length: Length, subject: Subject) -> bool:
    """Whether a length is given by the distance of points that is no given itself."""
    symbol = read_math(length.symbol, _WHERE)
    if any(
        symbol == read_math(one.symbol, name) for name, one in subject.template.parameters.items()
    ):
        return False
    return any(isinstance(node, Letter) and node.name in subject.points for node in symbol)


def list_ends(mark: Mark) -> tuple[str, ...]:
    """The points of a mark."""
    match mark:
        case Length(start=start, end=end):
            return start, end
        case MarkedAngle(at=at, start=start, end=end):
            return tuple(name for name in (at, start, end) if name not in SIDES)
        case tuple():
            return mark
        case _:
            assert_never(mark)


def say_mark(mark: Mark, subject: Subject) -> Message:
    """What a mark says."""
    letter = subject.instance.letter
    match mark:
        case Length(symbol, start, end, along):
            named = {"start": letter(start), "end": letter(end), "symbol": symbol}
            if along is None:
                return Message("description.length", **named)
            return Message(f"description.length-{along}", **named)
        case MarkedAngle():
            return _say_angle(mark, subject)
        case (start, at, end):
            named = {"start": letter(start), "at": letter(at), "end": letter(end)}
            return Message("description.right-angle", **named)
        case _:
            assert_never(mark)


def _say_angle(angle: MarkedAngle, subject: Subject) -> Message:
    """An angle with the sense in which it is drawn."""
    first, second = (find_way(angle.at, end, subject.doubles) for end in (angle.start, angle.end))
    turns = find_sweep(angle, angle_of(second) - angle_of(first)) >= 0
    return Message(
        "description.angle",
        at=subject.instance.letter(angle.at),
        start=_name_way(angle.at, angle.start, subject),
        end=_name_way(angle.at, angle.end, subject),
        sense=Message("statement.counter-clockwise" if turns else "statement.clockwise"),
        symbol=angle.symbol,
    )


def find_way(at: str, end: str, points: Mapping[str, Vector]) -> Vector:
    """The way from a point to a side of the paper or to another point."""
    for side in SIDES:
        if side == end:
            return TOWARDS[side]
    return points[end] - points[at]


def _name_way(at: str, end: str, subject: Subject) -> Message:
    """A side of the paper or the way to a point, in prose."""
    for side in SIDES:
        if side == end:
            return Message(f"description.side-{side}")
    ends = {"at": subject.instance.letter(at), "end": subject.instance.letter(end)}
    return Message("description.toward-point", **ends)


def say_frame(frame: BodyFrame, subject: Subject) -> Message:
    """The axes fixed to a body at one of its points."""
    letter = subject.instance.letter
    match frame.along:
        case "x":
            axis = frame.x
        case "y":
            axis = frame.y
        case _:
            assert_never(frame.along)
    return Message(
        "description.frame",
        at=letter(frame.at),
        axis=axis,
        x=frame.x,
        y=frame.y,
        start=letter(frame.start),
        end=_name_end(frame.end, subject),
    )


def _name_end(end: str, subject: Subject) -> Message:
    for side in SIDES:
        if side == end:
            return Message(f"description.side-{side}")
    return Message("description.frame-point", point=subject.instance.letter(end))


def say_side(point: str, other: str, subject: Subject) -> Message | None:
    """On which side of another a point lies; None where it is in the same place."""
    apart = subject.doubles[point] - subject.doubles[other]
    sector = _SECTORS.get((_find_sign(apart.x), _find_sign(apart.y)))
    if sector is None:
        return None
    letter = subject.instance.letter
    return Message(f"description.place-{sector}", point=letter(point), other=letter(other))


def _find_sign(number: float) -> int:
    return (number > _SAME) - (number < -_SAME)
