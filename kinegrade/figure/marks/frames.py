"""Frames of reference: the axes x and y at their origin, or aside where only components are asked;
the axes of a body, as two arrows with their letters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import assert_never

from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import Mark, direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import unit
from kinegrade.figure.scene import THIN, Primitive, Strokes, find_common_box
from kinegrade.figure.symbols import HEAD_LENGTH, PIN, draw_arrowhead
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import BodyFrame, FigureHints

_ORIGIN, _RIGHT = Vector(0.0, 0.0), Vector(1.0, 0.0)
# Millimetres, of the axes at the origin, of those of a body, and of those aside
_LENGTHS, _BODY_LENGTHS, _ASIDE = (
    (12.0, 14.5, 17.0, 20.0, 9.5, 24.0),
    (12.0, 9.0, 14.0, 7.5),
    7.0,
)
_ASIDES = (0.0, 1.6, -1.6)  # millimetres, of an axis along a bar from the bar's middle
# For a millimetre aside: rather on the edge of a plate, from the origin, than beside it; a bar
# would hide the arrowhead
_BESIDE = 10.0
_ROOM = 11.0  # millimetres, of the square that the axes aside take with their letters
_TIP = 4.5  # millimetres of an axis that should lie clear of everything


def add_frames(
    layout: Layout, at: Mapping[str, Vector], hints: FigureHints, sparing: Sequence[Primitive]
) -> Layout:
    """The layout with the axes that stand at points: those of bodies, then x and y at the
    origin; their letters keep clear of lines that are still to come.
    """
    for frame in hints.frames:
        place, symbols = _find_place(at, frame), (frame.x, frame.y)
        layout = _add_frame(layout, place, symbols, _BODY_LENGTHS, sparing=sparing)
    if hints.axes == "origin":
        layout = _add_frame(layout, (_ORIGIN, _RIGHT), ("x", "y"), _LENGTHS, sparing=sparing)
    return layout


def add_axes_aside(layout: Layout, hints: FigureHints) -> Layout:
    """The layout with a small frame x, y where the hints want one: in a corner that is free, else
    outside everything at the lower left.
    """
    if hints.axes == "aside":
        corner = _find_free_corner(layout)
        layout = _add_frame(layout, (corner, _RIGHT), ("x", "y"), (_ASIDE,), gap=0.0)
    return layout


def _find_free_corner(layout: Layout) -> Vector:
    """Where the origin of a small frame has room for both axes and their letters."""
    box = find_common_box(layout.primitives)
    far = box.left + box.width - _ROOM, box.bottom + box.height - _ROOM
    middle = Vector(_ROOM / 2, _ROOM / 2)
    for corner in (Vector(x, y) for y in (box.bottom, far[1]) for x in (box.left, far[0])):
        if not layout.obstacles.under_box(*(corner + middle), _ROOM, _ROOM):
            return corner
    return Vector(box.left - _ASIDE, box.bottom)


def _find_place(at: Mapping[str, Vector], frame: BodyFrame) -> tuple[Vector, Vector]:
    """Where the origin of a body's frame is, and the direction of its x axis."""
    along = unit(direction(at, at[frame.start], frame.end))
    match frame.along:
        case "x":
            return at[frame.at], along
        case "y":
            return at[frame.at], -along.turned()
        case _:
            assert_never(frame.along)


def _add_frame(
    layout: Layout,
    place: tuple[Vector, Vector],
    symbols: tuple[str, str],
    lengths: tuple[float, ...],
    *,
    gap: float = PIN,
    sparing: Sequence[Primitive] = (),
) -> Layout:
    origin, along = place
    for symbol, toward in zip(symbols, (along, along.turned()), strict=True):
        axes = list(_list_axes(origin + toward * gap, toward, symbol, lengths))
        layout = layout.marked(axes, sparing)
    return layout


def _list_axes(
    start: Vector, toward: Vector, symbol: str, lengths: tuple[float, ...]
) -> Iterator[Mark]:
    """An axis in each length, the preferred one first; beside a bar that would hide it."""
    for aside in _ASIDES:
        for rank, size in enumerate(lengths):
            yield _Axis(
                start + toward.turned() * aside,
                toward,
                size,
                symbol,
                0.5 * rank + _BESIDE * abs(aside),
            )


@dataclass(frozen=True)
class _Axis:
    """A thin arrow with its letter at the tip."""

    start: Vector
    toward: Vector
    size: float
    symbol: str
    demerit: float
    shared: bool = True

    def path(self) -> tuple[Segment, ...]:
        """The part before the tip; the rest may run along a bar."""
        return ((self._tip() - self.toward * _TIP, self._tip()),)

    def wish(self) -> Wish:
        """Around the tip, beyond it first."""
        return Wish(self.symbol, list_spots_around(self.symbol, self._tip(), away=self.toward))

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead."""
        shaft = (self.start, self._tip() - self.toward * HEAD_LENGTH * 0.8)
        return (Strokes((shaft,), THIN), draw_arrowhead(self._tip(), self.toward))

    def _tip(self) -> Vector:
        return self.start + self.toward * self.size
