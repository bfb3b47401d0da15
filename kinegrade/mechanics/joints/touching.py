"""Whether circles touch what they run on: what contacts, rolling and meshing need of positions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import round_short, size
from kinegrade.mechanics.shapes import Circle, Line, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True)
class Touching:
    """A circle that touches a line or another circle; `inside` where one lies within the other."""

    circle: Circle
    on: Shape
    inside: bool

    def list_centres(self) -> tuple[str, ...]:
        """The centres of the circles."""
        shapes = (self.circle, self.on)
        return tuple(shape.centre for shape in shapes if isinstance(shape, Circle))

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the two do not touch."""
        radius, centre = self.circle.radius, self.circle.centre
        match self.on:
            case Circle(centre=other, radius=other_radius):
                if self.inside and arithmetic.is_zero(other_radius - radius):
                    yield Message("mechanics.same-radius")
                    return
                expected = other_radius - radius if self.inside else other_radius + radius
                yield from find_wrong_distance((centre, other), expected, points, arithmetic)
            case Line(point=point, direction=direction):
                across = direction.cross(points[centre] - point)
                if not arithmetic.is_zero(across * across - radius * radius * direction.squared()):
                    short = round_short(radius)
                    yield Message("mechanics.apart-from-line", centre=centre, radius=short)
            case _:
                assert_never(self.on)


def find_wrong_distance(
    ends: tuple[str, str], expected: Number, points: Mapping[str, Vector], arithmetic: Arithmetic
) -> Iterator[Message]:
    """That the distance of two points is not the expected one, m."""
    first, second = ends
    square = (points[first] - points[second]).squared()
    if not arithmetic.is_zero(square - expected * expected):
        yield Message(
            "mechanics.wrong-distance",
            first=first,
            second=second,
            distance=round_short(size(square) ** 0.5),
            needed=round_short(abs(expected)),
        )
