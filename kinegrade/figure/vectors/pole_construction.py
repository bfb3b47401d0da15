"""The construction of a velocity pole: the normals to velocities meet in it; arrows lead to a
distant pole, whose letter the caption has.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import pi

from kinegrade.figure.marks.body_names import add_body_names
from kinegrade.figure.marks.names import label_points
from kinegrade.figure.marks.turning.rotations import list_turning_arrows
from kinegrade.figure.marks.turning_arrow import TurningArrow
from kinegrade.figure.mechanism.fitting import Room, fit_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import angle_of, length, mean, on_line, unit
from kinegrade.figure.scene import THIN, Outline, Pen, Primitive, Scene, Strokes
from kinegrade.figure.symbols.arrows import draw_arrowhead
from kinegrade.figure.symbols.pins import draw_dot
from kinegrade.figure.vectors.arrows import VectorArrow
from kinegrade.figure.vectors.mechanism import PointArrow, add_arrows, add_symbols, place_arrows
from kinegrade.figure.vectors.plain_mechanism import PICTURE, BareMechanism, find_bold_lines
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints, Turning

NORMAL = Pen(0.22, "dashed")
TALL = Room(PICTURE.width, 52.0)  # of a picture with a pole
_FAR = 0.4  # of its full size that a mechanism keeps at least to have its pole in the picture
_POINTER = 20.0  # millimetres, of a normal towards a pole outside the picture
_BEYOND = 10.0  # millimetres of such a normal that show at least beyond a bar on which it lies
_SQUARE = 2.3  # millimetres, side of the mark of a right angle: beyond the circle of a pin
_TURNING_RADII = (4.5, 6.0, 7.5)  # millimetres, of the arrow of the rotation about the pole
_LEAST = 0.2  # millimetres: a point with so short an arrow still has its normal
_SAME = 1e-3  # millimetres within which two points coincide


@dataclass(frozen=True)
class Pole:
    """A velocity pole: its symbol (LaTeX math), and where it is (m)."""

    symbol: str
    at: Vector


def draw_pole_construction(
    mechanism: Mechanism,
    hints: FigureHints,
    pole: Pole,
    rays: Sequence[PointArrow],
    rotation: Turning | None = None,
) -> Scene:
    """The mechanism (floats, metres) with its letters, the velocities `rays` of points of one body,
    and its pole.

    A dashed normal leads from each point to the pole, with a right angle between it and the
    velocity; where all normals coincide, a dashed line through the tips of the velocities locates
    the pole on them. Normals to a pole outside the picture end in an arrowhead, and its symbol
    stands nowhere. A pole at the contact of a rolling wheel needs no rays. `rotation` is drawn as a
    curved arrow about a pole in the picture.

    Raises TemplateError for a hint about something that the mechanism does not have.
    """
    points = tuple(ray.at for ray in rays)
    plain = BareMechanism.of(mechanism, hints, points)
    whole = BareMechanism.of(mechanism, hints, (*points, pole.at))
    near = whole.first_scale(TALL) >= _FAR * plain.first_scale()
    shown, room = (whole, TALL) if near else (plain, PICTURE)
    construction = _Construction(pole, rays, rotation if near else None, near)
    scale = min(shown.first_scale(room), plain.first_scale())
    return fit_scene(lambda factor: construction.compose(shown, factor), scale, shown.span, room)


@dataclass(frozen=True)
class _Construction:
    pole: Pole
    rays: Sequence[PointArrow]
    rotation: Turning | None
    near: bool

    def compose(self, plain: BareMechanism, scale: float) -> Layout:
        """The normals under the velocities, then the letters, the symbols, the rotation, the names
        of bodies.
        """
        paper, drawing = plain.at(scale)
        placed = place_arrows(self.rays, scale, shortest=_LEAST)
        bars = tuple(find_bold_lines(drawing.primitives))
        layout = Layout.of((*drawing.primitives, *self.lines(placed, scale, bars)))
        layout = add_arrows(layout, placed, drawing).drawn(self.mark(paper, scale))
        layout = layout.written((*label_points(paper, plain.hints, drawing), *self.name(scale)))
        layout = add_symbols(layout, placed)
        if self.rotation:
            layout = layout.marked(_mark_rotation_about(self.place(scale), self.rotation, placed))
        return add_body_names(layout, paper, plain.hints, drawing)

    def place(self, scale: float) -> Vector:
        """The pole on paper."""
        return self.pole.at * scale

    def _normals(
        self, placed: Sequence[VectorArrow], scale: float, bars: Sequence[Segment]
    ) -> Iterator[tuple[VectorArrow, Vector]]:
        """Each velocity with the end of its normal on paper; `bars` are bold lines, on which no
        normal would be visible.
        """
        for arrow in placed:
            if length(self.place(scale) - arrow.start) > _SAME:
                way = unit(self.place(scale) - arrow.start)
                yield (
                    arrow,
                    self.place(scale) if self.near else _shorten_normal(arrow.start, way, bars),
                )

    def lines(
        self, placed: Sequence[VectorArrow], scale: float, bars: Sequence[Segment]
    ) -> tuple[Primitive, ...]:
        """The normals, the marks of right angles, the line through the tips of parallel
        velocities.
        """
        ways = list(self._normals(placed, scale, bars))
        if not ways:
            return ()
        dashes = [(arrow.start, end) for arrow, end in ways] + list(self._through_tips(ways, scale))
        marks = tuple(_draw_right_angle(arrow, end) for arrow, end in ways)
        heads = (
            ()
            if self.near
            else tuple(draw_arrowhead(end, unit(end - arrow.start)) for arrow, end in ways)
        )
        return (Strokes(tuple(dashes), NORMAL), *marks, *heads)

    def _through_tips(
        self, ways: Sequence[tuple[VectorArrow, Vector]], scale: float
    ) -> Iterator[Segment]:
        """The line through the pole and the tips of the velocities, where all normals coincide."""
        arrows = [arrow for arrow, _ in ways]
        ends = [arrow.end for arrow in arrows] + [self.place(scale)]
        if (
            self.near
            and len(arrows) > 1
            and all(_are_in_line(arrows[0], arrow) for arrow in arrows)
        ):
            yield max(combinations(ends, 2), key=lambda pair: length(pair[1] - pair[0]))

    def mark(self, paper: Mechanism, scale: float) -> tuple[Primitive, ...]:
        """The pole as a dot, unless a point of the mechanism is already drawn there."""
        if not self.near or any(
            length(at - self.place(scale)) < _SAME for at in paper.points.values()
        ):
            return ()
        return draw_dot(self.place(scale))

    def name(self, scale: float) -> Iterator[Wish]:
        """The symbol at the pole, where that is in the picture."""
        if self.near:
            yield Wish(self.pole.symbol, list_spots_around(self.pole.symbol, self.place(scale)))


def _are_in_line(one: VectorArrow, other: VectorArrow) -> bool:
    """Whether the normals to two velocities coincide."""
    along, apart = unit(one.end - one.start), other.start - one.start
    return bool(
        abs(along.cross(unit(other.end - other.start))) < _SAME and abs(along.dot(apart)) < _SAME
    )


def _shorten_normal(start: Vector, toward: Vector, bars: Sequence[Segment]) -> Vector:
    """The end of a normal towards a pole outside the picture: past the bars that lie on it."""
    on_it = [
        end
        for bar in bars
        if on_line(start, Line(bar[0], bar[1] - bar[0]))
        for end in bar
        if abs(toward.cross(end - start)) < _SAME
    ]
    reach: float = max([_POINTER, *(toward.dot(end - start) + _BEYOND for end in on_it)])
    tip: Vector = start + toward * reach
    return tip


def _draw_right_angle(arrow: VectorArrow, end: Vector) -> Outline:
    """The small square between a velocity and its normal."""
    one, other = (unit(tip - arrow.start) * _SQUARE for tip in (arrow.end, end))
    return Outline(
        (arrow.start + one, arrow.start + one + other, arrow.start + other), THIN, closed=False
    )


def _mark_rotation_about(
    centre: Vector, rotation: Turning, placed: Sequence[VectorArrow]
) -> list[TurningArrow]:
    """Curved arrows about the pole, towards the points whose velocities are drawn first."""
    toward = angle_of(mean(arrow.start for arrow in placed) - centre) if placed else pi / 2
    sense = rotation.sense or "ccw"
    return list_turning_arrows(rotation, sense, centre, _TURNING_RADII, toward, astray=1.0)
