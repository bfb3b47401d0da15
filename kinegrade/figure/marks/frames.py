"""Frames of reference: the axes x and y at their origin, or aside where only components are asked;
the axes of a body, as two arrows with their letters.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.drawn import find_block, find_edge, is_rigid, measure_drawn, meets_face
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight.broad_links import find_frame_place, measure_way
from kinegrade.figure.mechanism.straight.edge_axes import has_room_for_axis
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.figure.scene import THIN, Primitive, Strokes, find_common_box
from kinegrade.figure.symbols.arrows import HEAD_LENGTH, draw_arrowhead
from kinegrade.figure.symbols.pins import PIN
from kinegrade.figure.symbols.sliding import BLOCK_LENGTH
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, BodyFrame, FigureHints

_ORIGIN, _RIGHT = Vector(0.0, 0.0), Vector(1.0, 0.0)
# Millimetres, of the axes at the origin, of those of a body, and of those aside
_LENGTHS, _BODY_LENGTHS, _ASIDE = (
    (12.0, 14.5, 17.0, 20.0, 9.5, 24.0, 7.0),
    (12.0, 9.0, 14.0, 7.5),
    7.0,
)
_LEG_LENGTHS = (22.0, 25.0, 19.0)  # millimetres of an axis that is the leg of an angle
_BEYOND_LEG = 4.0  # millimetres of an axis beyond the point that gives the side of an angle
_BEYOND_TIP = 5.0  # millimetres of an axis beyond the arrow of a motion that lies on it
_BEYOND_BAR = (6.0, 7.5, 9.0)  # millimetres of an axis beyond the bar or the ground that it is on
_INWARD = 3.0  # share of the way into a plate, of the way from the tip on its edge to the letter
_ALONG_EDGE = (17.0, 20.0)  # further millimetres of an axis along an edge
_OUTSIDE = 6.0  # demerit of a letter beyond the outline of the plate on whose edge its axis lies
_BEFORE_BLOCK = 18.0  # millimetres before a block that have no room for an axis and its letter
_AT_ORIGIN = 3.0  # millimetres of an axis at its origin, where a pin and other axes are
_CLEAR = 3.0  # millimetres about that square that are free as well
_ROOM = 11.0  # millimetres, of the square that the axes aside take with their letters
_STATIONS = 7  # places along the height of a figure for the axes aside
_TIP = 4.5  # millimetres of an axis that should lie clear of everything

# The symbol of an axis, its origin, its direction and the lengths it may have
_NamedAxis = tuple[str, Vector, Vector, tuple[float, ...]]


def add_frames(
    layout: Layout,
    at: Mapping[str, Vector],
    hints: FigureHints,
    drawing: Drawing,
    sparing: Sequence[Primitive],
    *,
    likely: Sequence[Segment] = (),
) -> Layout:
    """The layout with the axes that stand at points: those of bodies, then x and y at the
    origin; their letters keep clear of lines that are still to come. An axis along a bar or the
    ground runs on beyond it, as does one to a block, however far that is where bodies have frames;
    along the long edge of a plate it lies on that, which is thin, along a long link on that, which
    is broad; one that is the leg of an angle reaches beyond its arc, one along
    the `likely` arrow of a motion beyond its tip.
    """
    axes = [
        axis for frame in hints.frames for axis in _name_axes(*find_frame_place(at, frame), frame)
    ]
    if hints.axes == "origin":
        axes += [("x", _ORIGIN, _RIGHT, _LENGTHS), ("y", _ORIGIN, _RIGHT.turned(), _LENGTHS)]
    for axis in axes:
        ways = _list_ways(at, hints, drawing, axis)
        layout = layout.marked([way.past(likely) for way in ways], sparing)
    return layout


def _list_ways(
    at: Mapping[str, Vector], hints: FigureHints, drawing: Drawing, axis: _NamedAxis
) -> list[FrameAxis]:
    """An axis in the lengths that it may have; on a long edge or a broad bar, so that it is seen
    to begin at its own origin.
    """
    symbol, origin, toward, usual = axis
    edge, outward = find_edge(origin, toward, drawing)
    if on := max(
        (measure_way(bar, origin, toward) for bar in _list_broad_bars(drawing)), default=0
    ):
        line = (origin + toward * PIN, origin + toward * (on - PIN))
        shafts = _list_axes(origin + toward * (on + PIN), toward, symbol, _BEYOND_BAR)
        return [replace(shaft, before=(line,)) for shaft in shafts]
    if has_room_for_axis(edge):
        sizes = (*usual, *(size for size in _ALONG_EDGE if size < edge - PIN))
        ways = _list_axes(origin + toward * PIN, toward, symbol, sizes)
        return [replace(way, inward=-outward) for way in ways]
    begins, ends = find_block(origin, toward, drawing)
    led = bool(hints.frames) or _has_line(at, hints, origin, origin + toward * ends)
    if begins and (begins < _BEFORE_BLOCK or led):
        line = (origin + toward * PIN, origin + toward * begins)
        shafts = _list_axes(origin + toward * ends, toward, symbol, _BEYOND_BAR)
        return [replace(shaft, before=(line,)) for shaft in shafts]
    leg = _measure_leg(at, hints.angles, origin, toward)
    long = (*(size for size in _LEG_LENGTHS if size > leg), leg + _BEYOND_LEG) if leg else ()
    drawn = measure_drawn(origin, toward, drawing)
    beyond = tuple(drawn + more - PIN for more in _BEYOND_BAR if drawn)
    sizes = (*(size for size in (*long, *usual) if size > drawn), *beyond)
    hidden = drawn if _is_point(at, origin + toward * drawn) else 0.0
    left = tuple(size - hidden for size in sizes)
    begins = hidden + (0.0 if is_rigid(origin, at, drawing) else PIN)
    ways = _list_axes(origin + toward * begins, toward, symbol, left)
    free = not leg and meets_face(origin, toward, drawing)
    return [replace(way, free=free) for way in ways]


def _list_broad_bars(drawing: Drawing) -> list[Bar]:
    return [part for part in drawing.parts if isinstance(part, Bar) and part.use == "broad"]


def _has_line(at: Mapping[str, Vector], hints: FigureHints, start: Vector, end: Vector) -> bool:
    """Whether a thin line, or the leg of an angle, leads from a point to a block that ends at
    another.
    """
    legs = ((angle.at, side) for angle in hints.angles for side in (angle.start, angle.end))
    lines = [(at[one], at[other]) for one, other in (*hints.lines, *legs) if {one, other} <= {*at}]
    return any(
        min(length(point - start) for point in line) < NEAR
        and min(length(point - end) for point in line) < BLOCK_LENGTH
        for line in lines
    )


def _is_point(at: Mapping[str, Vector], end: Vector) -> bool:
    """Whether a bar or an edge ends at a point, whose pin the axis does not cross."""
    return any(length(point - end) < NEAR for point in at.values())


def _name_axes(origin: Vector, along: Vector, frame: BodyFrame) -> tuple[_NamedAxis, _NamedAxis]:
    """The axes of a body's frame."""
    return (
        (frame.x, origin, along, _BODY_LENGTHS),
        (frame.y, origin, along.turned(), _BODY_LENGTHS),
    )


def _measure_leg(
    at: Mapping[str, Vector], angles: Iterable[Angle], origin: Vector, toward: Vector
) -> float:
    """How far, in millimetres, the point lies that gives the side of an angle along an axis; 0
    where the axis is no side, or one of the paper.
    """
    reaches = [0.0]
    for angle in angles:
        if length(at[angle.at] - origin) < NEAR:
            sides = [at[name] - origin for name in (angle.start, angle.end) if name in at]
            reaches += [length(side) for side in sides if length(unit(side) - toward) < NEAR]
    return max(reaches)


def add_axes_aside(layout: Layout, hints: FigureHints) -> Layout:
    """The layout with a small frame x, y where the hints want one: in a corner that is free, else
    outside everything at the lower left.
    """
    if hints.axes == "aside":
        corner = _find_free_corner(layout)
        for symbol, toward in (("x", _RIGHT), ("y", _RIGHT.turned())):
            layout = layout.marked([FrameAxis(corner, toward, _ASIDE, symbol, 0.0)])
    return layout


def _find_free_corner(layout: Layout) -> Vector:
    """Where the origin of a small frame has room for both axes and their letters."""
    box = find_common_box(layout.primitives)
    far = box.left + box.width - _ROOM, box.bottom + box.height - _ROOM
    middle, room = Vector(_ROOM / 2, _ROOM / 2), _ROOM + 2 * _CLEAR
    corners = [Vector(x, y) for y in (box.bottom, far[1]) for x in (box.left, far[0])]
    between = np.linspace(box.bottom, max(far[1], box.bottom), _STATIONS)[1:-1].tolist()
    sides = [Vector(x, y) for y in between for x in (box.left, far[0])]
    for corner in (*corners, *sides):
        if not layout.obstacles.under_box(*(corner + middle), room, room):
            return corner
    letter = _CLEAR + 1.0
    taken = layout.obstacles.under_box(box.left + letter / 2, box.bottom, letter, 2 * letter)
    return Vector(box.left - (_ROOM + _CLEAR / 2 if taken else _ASIDE), box.bottom)


def _list_axes(
    start: Vector, toward: Vector, symbol: str, lengths: tuple[float, ...]
) -> Iterator[FrameAxis]:
    """An axis in each length, the preferred one first."""
    for rank, size in enumerate(lengths):
        yield FrameAxis(start, toward, size, symbol, 0.5 * rank)


class FrameAxis(Struct, frozen=True):
    """A thin arrow with its letter at the tip; `before` is the part short of a block on it. On an
    edge of a plate, which is thin, the letter is rather `inward` of that.
    """

    start: Vector
    toward: Vector
    size: float
    symbol: str
    demerit: float
    before: tuple[Segment, ...] = ()
    free: bool = False
    inward: Vector | None = None
    shared: bool = True

    def past(self, arrows: Iterable[Segment]) -> FrameAxis:
        """The axis with its tip past those of arrows that lie on it."""
        reaches = [
            (end - self.start).dot(self.toward)
            for tail, end in arrows
            if max(abs((at - self.start).cross(self.toward)) for at in (tail, end)) < NEAR
            and unit(end - tail).dot(self.toward) > 0
        ]
        return replace(self, size=max([self.size, *(reach + _BEYOND_TIP for reach in reaches)]))

    def path(self) -> tuple[Segment, ...]:
        """The part before the tip, as the rest may run along a bar or over one; all that is clear
        of its origin where it has to be `free`.
        """
        if self.inward:
            return ()
        size = max(_TIP, self.size - _AT_ORIGIN) if self.free else _TIP
        return ((self.tip() - self.toward * size, self.tip()),)

    def wish(self) -> Wish:
        """Around the tip, beyond it first, or inside the plate."""
        if not self.inward:
            return Wish(self.symbol, list_spots_around(self.symbol, self.tip(), away=self.toward))
        away = self.toward + self.inward * _INWARD
        spots = list_spots_around(self.symbol, self.tip(), away=away)
        outside = (spots - np.array(self.tip())) @ np.array(self.inward) < 0
        return Wish(self.symbol, spots, demerits=_OUTSIDE * outside)

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead."""
        shaft = (self.start, self.tip() - self.toward * HEAD_LENGTH * 0.8)
        return (Strokes((*self.before, shaft), THIN), draw_arrowhead(self.tip(), self.toward))

    def tip(self) -> Vector:
        """Where its arrow ends."""
        return self.start + self.toward * self.size
