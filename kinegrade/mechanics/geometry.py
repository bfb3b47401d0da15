"""Constructions: points from points, lines and circles, with a named branch where there are two.

Configurations are constructed, never iterated, in any of the arithmetics. `make_constructions`
gives the functions that expressions in templates may call. Lengths in metres, angles
counter-clockwise from +x.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, assert_never

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.language.message import Fault, Message, Text, list_plainly
from kinegrade.mechanics.branches import BRANCHES, DIRECTED, Beside, Branch, measure_lead
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.rounded_text import write_decimal

_PLAIN = re.compile(r"-?[0-9]+(\.[0-9]+)?")  # without a power of ten


@dataclass(frozen=True)
class Round:
    """A circle about a point of the plane."""

    centre: Vector
    radius: Any


def make_constructions(
    arithmetic: Arithmetic, points: Mapping[str, Vector]
) -> dict[str, Callable[..., Any]]:
    """The constructions by name; `points` gives names for error messages and is read only when one
    is written.
    """
    build = Constructions(arithmetic, points)
    return {
        "": Vector,
        "polar": build.polar,
        "line": build.line,
        "circle": Round,
        "meet": build.meet,
        "foot": foot,
        "midpoint": lambda p, q: (p + q) / 2,
        "distance": build.distance,
        "toward": build.toward,
        "x": lambda p: p.x,
        "y": lambda p: p.y,
        "turned": lambda v: v.turned(),
        "left of": lambda p, q: Beside(q - p, "left"),
        "right of": lambda p, q: Beside(q - p, "right"),
        "direction": build.direction,
    }


@dataclass(frozen=True)
class Constructions:
    """The constructions that need an arithmetic: for roots, for sines, for distinguishing
    branches.
    """

    arithmetic: Arithmetic
    points: Mapping[str, Vector]

    def polar(self, centre: Vector, radius: Any, angle: Any) -> Vector:
        """The point at `radius` from `centre` in the direction `angle`."""
        arm: Vector = self.unit(angle) * radius
        return centre + arm

    def unit(self, angle: Any) -> Vector:
        """The unit vector in the direction `angle`."""
        return Vector(self.arithmetic.cos(angle), self.arithmetic.sin(angle))

    def line(self, point: Vector, toward: Any) -> Line:
        """The line through `point` and another point, or in the direction of an angle."""
        if not isinstance(point, Vector):
            raise TypeError("a line goes through a point")
        return Line(point, toward - point if isinstance(toward, Vector) else self.unit(toward))

    def distance(self, first: Vector, second: Any) -> Any:
        """The distance of a point from another point or from a line."""
        match second:
            case Line(point=point, direction=direction):
                length = self.arithmetic.sqrt(direction.squared())
                return abs(direction.cross(first - point)) / length
            case Vector():
                return self.arithmetic.sqrt((second - first).squared())
            case _:
                raise TypeError("a distance is that of a point or a line")

    def toward(self, start: Vector, end: Vector, distance: Any) -> Vector:
        """The point at `distance` from `start` towards `end`, or beyond it."""
        step: Vector = (end - start) * (distance / self.distance(start, end))
        return start + step

    def direction(self, start: Vector, end: Vector) -> Any:
        """The angle of the vector from `start` to `end`."""
        return self.arithmetic.arctangent(end.y - start.y, end.x - start.x)

    def meet(
        self, first: Line | Round, second: Line | Round, branch: Branch | None = None
    ) -> Vector:
        """The common point of two lines, or the one on the named side of a line and a circle or of
        two circles.

        right, left, upper, lower compare the two candidates, and so does the side of a directed
        line through two points; counterclockwise and clockwise, for two circles, say on which side
        of the directed line from the first centre to the second the point lies. Raises
        MechanismError when there is no common point, or when the name does not distinguish the two.
        """
        if isinstance(first, Line) and isinstance(second, Line):
            return self._lines(first, second)
        if not isinstance(branch, Beside) and branch not in BRANCHES:
            what = Message("mechanics.two-common-points")
            do = Message("mechanics.choose-branch", names=list_plainly((*BRANCHES, *DIRECTED)))
            raise ExpressionError(Fault("meet(...)", what, do=do))
        match first, second:
            case Round(), Round():
                return self._circles(first, second, branch)
            case Line(), Round():
                return self._line_circle(first, second, branch)
            case Round(), Line():
                return self._line_circle(second, first, branch)
            case _:
                raise TypeError("lines and circles meet")

    def _lines(self, first: Line, second: Line) -> Vector:
        across = first.direction.cross(second.direction)
        if self.arithmetic.is_zero(across):
            raise MechanismError(
                Message(
                    "mechanics.parallel-lines", first=self.name(first), second=self.name(second)
                )
            )
        share = (second.point - first.point).cross(second.direction) / across
        step: Vector = first.direction * share
        return first.point + step

    def _line_circle(self, line: Line, circle: Round, branch: Branch) -> Vector:
        nearest = foot(circle.centre, line)
        rest = circle.radius * circle.radius - (nearest - circle.centre).squared()
        half = line.direction * self._reach(rest / line.direction.squared(), circle, line)
        return self._pick(nearest + half, nearest - half, line.direction, circle.centre, branch)

    def _circles(self, first: Round, second: Round, branch: Branch) -> Vector:
        axis = second.centre - first.centre
        square = axis.squared()
        if self.arithmetic.is_zero(square):
            raise MechanismError(
                Message("mechanics.concentric", first=self.name(first), second=self.name(second))
            )
        share = (first.radius * first.radius - second.radius * second.radius + square) / (
            2 * square
        )
        middle = first.centre + axis * share
        rest = first.radius * first.radius / square - share * share
        half = axis.turned() * self._reach(rest, first, second)
        return self._pick(middle + half, middle - half, axis, first.centre, branch)

    def _reach(self, square: Any, circle: Round, other: Line | Round) -> Any:
        try:
            return self.arithmetic.sqrt(square)
        except ValueError:
            what = Message(
                "mechanics.out-of-reach", circle=self.name(circle), other=self.name(other)
            )
            raise MechanismError(what) from None

    def _pick(
        self, first: Vector, second: Vector, axis: Vector, origin: Vector, branch: Branch
    ) -> Vector:
        side = self.arithmetic.sign(measure_lead(first, second, axis, origin, branch))
        if (
            self.arithmetic.certified
            and side == 0
            and not self.arithmetic.is_zero((first - second).squared())
        ):
            what = Message("mechanics.undecided-branch", branch=str(branch))
            do = Message("mechanics.name-branch", names=list_plainly((*BRANCHES, *DIRECTED)))
            raise MechanismError(Fault("", what, do=do))
        first_wins = side >= 0
        choose = self.arithmetic.choose
        return Vector(choose(first_wins, first.x, second.x), choose(first_wins, first.y, second.y))

    def name(self, shape: Line | Round) -> Message:
        """A line or circle for an error message."""
        match shape:
            case Round(centre=centre, radius=radius):
                about = self._point_name(centre)
                return Message("mechanics.circle", centre=about, radius=round_short(radius))
            case Line(point=point, direction=direction):
                if self.arithmetic.is_zero(direction.y):
                    return Message("mechanics.level-line", height=round_short(point.y))
                if self.arithmetic.is_zero(direction.x):
                    return Message("mechanics.upright-line", place=round_short(point.x))
                return Message("mechanics.slanting-line", point=self._point_name(point))
            case _:
                assert_never(shape)

    def _point_name(self, point: Vector) -> Text:
        """The name of a point, or its coordinates."""
        for name, place in self.points.items():
            if place is point:
                return name
        return Message("mechanics.coordinates", x=round_short(point.x), y=round_short(point.y))


def foot(point: Vector, line: Line) -> Vector:
    """The foot of the perpendicular from `point` to `line`."""
    share = (point - line.point).dot(line.direction) / line.direction.squared()
    step: Vector = line.direction * share
    return line.point + step


def round_short(number: Any) -> Decimal | str:
    """A number of any arithmetic to four significant figures, for messages; as a text where it is
    so large or small that it is written with a power of ten.
    """
    written = f"{size(number):.4g}"
    return Decimal(written) if _PLAIN.fullmatch(written) else written


def size(number: Any) -> float:
    """A number of any arithmetic as a double; infinite where it exceeds the doubles."""
    return float(number) if isinstance(number, float) else float(write_decimal(number, 12))
