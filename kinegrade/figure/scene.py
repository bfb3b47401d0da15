"""A drawing as plain values: the input of every back end (Typst, TikZ, a browser), which none may
change.

Millimetres on paper, x right, y up, origin at the lower left corner; angles in radians,
counter-clockwise positive. Primitives are listed from the bottom layer to the top.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from math import ceil, cos, sin
from typing import Literal, assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.mechanics.vector import Vector

Dash = Literal["solid", "dashed", "dash-dotted"]
Fill = Literal["none", "white", "grey", "black"]
Ink = Literal["black", "grey"]


class Pen(Struct, frozen=True):
    """A line style; `width` in millimetres; grey is what lies behind black arrows."""

    width: float
    dash: Dash = "solid"
    ink: Ink = "black"


BOLD = Pen(0.8)
FIRM = Pen(0.4)
TOOTHED = Pen(0.2)  # lighter than an outline, as its teeth are close
THIN = Pen(0.18)
DASHED = Pen(0.3, "dashed")  # of arrows of what is sought
OPEN = Pen(0.25)  # of their heads
PITCH = Pen(0.18, "dash-dotted")


class Strokes(Struct, frozen=True, tag=True):
    """Separate straight lines of one pen: a link, or hatching."""

    lines: tuple[tuple[Vector, Vector], ...]
    pen: Pen


class Outline(Struct, frozen=True, tag=True):
    """A polygon, or an open polyline."""

    corners: tuple[Vector, ...]
    pen: Pen | None
    fill: Fill = "none"
    closed: bool = True


class Disc(Struct, frozen=True, tag=True):
    """A full circle."""

    centre: Vector
    radius: float
    pen: Pen | None
    fill: Fill = "none"


class Bow(Struct, frozen=True, tag=True):
    """A circular arc from the angle `start` over the angle `sweep`."""

    centre: Vector
    radius: float
    start: float
    sweep: float
    pen: Pen

    def path(self, apart: float = 0.17) -> tuple[Vector, ...]:
        """Points along the arc, at most that many radians apart (0.17: 10 degrees)."""
        count = max(2, ceil(abs(self.sweep) / apart)) + 1
        x, y = self.centre
        angles = [self.start + self.sweep * index / (count - 1) for index in range(count)]
        return tuple(
            [Vector(x + self.radius * cos(turn), y + self.radius * sin(turn)) for turn in angles]
        )


class Label(Struct, frozen=True, tag=True):
    """A symbol in LaTeX math, centred in a box of the given size."""

    symbol: str
    centre: Vector
    width: float
    height: float


Primitive = Strokes | Outline | Disc | Bow | Label


class Box(Struct, frozen=True):
    """An upright rectangle."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """From left to right."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top."""
        return self.top - self.bottom


class Scene(Struct, frozen=True):
    """A finished drawing; `scale` is millimetres on paper per metre, and `crowded` are the symbols
    that found no good place, `astray` those that stand off from their points behind a wall,
    `claimed` those of lengths that are nearer to something else than to their own lines; `strain`
    is what marks cost that cross something firm.
    """

    width: float
    height: float
    scale: float
    primitives: tuple[Primitive, ...]
    crowded: tuple[str, ...] = ()
    strain: float = 0.0
    astray: tuple[str, ...] = ()
    claimed: tuple[str, ...] = ()

    @property
    def labels(self) -> tuple[Label, ...]:
        """The labels among the primitives."""
        return tuple(primitive for primitive in self.primitives if isinstance(primitive, Label))


def find_fill(primitive: Strokes | Outline | Disc | Bow) -> Fill:
    """The fill of a primitive; strokes and arcs have none."""
    match primitive:
        case Outline() | Disc():
            return primitive.fill
        case Strokes() | Bow():
            return "none"
        case _:
            assert_never(primitive)


def _make_box(centre: Vector, width: float, height: float) -> Box:
    """The box of that size about a centre."""
    return Box(
        centre.x - width / 2, centre.y - height / 2, centre.x + width / 2, centre.y + height / 2
    )


def find_box(primitive: Primitive) -> Box:
    """The smallest box around one primitive, its pen included."""
    match primitive:
        case Label():
            return _make_box(primitive.centre, primitive.width, primitive.height)
        case Disc():
            width = 2 * (primitive.radius + _find_half_width(primitive.pen))
            return _make_box(primitive.centre, width, width)
        case Strokes() | Outline() | Bow():
            half = _find_half_width(primitive.pen)
            across, upward = zip(*_find_corners(primitive), strict=True)
            return Box(
                min(across) - half, min(upward) - half, max(across) + half, max(upward) + half
            )
        case _:
            assert_never(primitive)


def _find_half_width(pen: Pen | None) -> float:
    return pen.width / 2 if pen else 0.0


def find_common_box(primitives: Iterable[Primitive]) -> Box:
    """The smallest box around all primitives."""
    boxes = [find_box(primitive) for primitive in primitives]
    lower = min(box.left for box in boxes), min(box.bottom for box in boxes)
    return Box(*lower, max(box.right for box in boxes), max(box.top for box in boxes))


def _find_corners(primitive: Strokes | Outline | Bow) -> tuple[Vector, ...]:
    """The points that a pen visits."""
    match primitive:
        case Strokes():
            return tuple(chain.from_iterable(primitive.lines))
        case Bow():
            return primitive.path()
        case Outline():
            return primitive.corners
        case _:
            assert_never(primitive)


def move(primitive: Primitive, by: Vector) -> Primitive:
    """The primitive translated by a vector."""
    match primitive:
        case Strokes():
            return Strokes(_move_lines(primitive.lines, by), primitive.pen)
        case Outline():
            return replace(primitive, corners=tuple(corner + by for corner in primitive.corners))
        case Disc() | Bow() | Label():
            return replace(primitive, centre=primitive.centre + by)
        case _:
            assert_never(primitive)


def _move_lines(
    lines: Sequence[tuple[Vector, Vector]], by: Vector
) -> tuple[tuple[Vector, Vector], ...]:
    x, y = by  # components at once: a scene has thousands of strokes
    moved_lines = [
        (Vector(start.x + x, start.y + y), Vector(end.x + x, end.y + y)) for start, end in lines
    ]
    return tuple(moved_lines)
