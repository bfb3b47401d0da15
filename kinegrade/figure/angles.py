"""Angles: arcs of several radii, with thin lines to whatever side of the angle is not drawn as a bar."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import inf, pi

from kinegrade.figure.bars import Bar
from kinegrade.figure.layers import Drawing
from kinegrade.figure.mark import Mark, chords, direction
from kinegrade.figure.obstacles import Segment
from kinegrade.figure.place import Wish, along_bow
from kinegrade.figure.plane import NEAR, angle_of, length, on_line, polar, shorter_way
from kinegrade.figure.scene import THIN, Bow, Primitive, Strokes
from kinegrade.figure.symbols import HEAD_LENGTH, PIN, arrowhead
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.hints import Angle

SMALLEST_ANGLE = pi / 180  # an angle below one degree shows no arc
RADII = (7.0, 6.2, 5.5, 4.5, 8.5, 10.0, 12.0, 14.0)  # millimetres, the nicest first where there is room
SHARE = 0.45  # of the way to the next point on a side of the angle that an arc takes at best
BEYOND = 2.5  # millimetres a thin line towards a side of the paper goes on beyond the arc

Leg = tuple[float, float]  # direction in radians, and reach in millimetres (zero: as far as the arc needs)


def angle_marks(at: Mapping[str, Vector], hint: Angle, drawing: Drawing) -> Iterator[list[Mark]]:
    """Arcs of several radii; nothing when the angle is too small to be seen."""
    vertex = at[hint.at]
    start, end = (angle_of(direction(at, vertex, name)) for name in (hint.start, hint.end))
    sweep = shorter_way(end - start)
    if hint.sense is not None and abs(sweep) > SMALLEST_ANGLE:
        sweep = sweep % (2 * pi) if hint.sense == "ccw" else -((-sweep) % (2 * pi))
    legs = tuple(
        (angle, length(at[name] - vertex) if name in at else 0.0)
        for angle, name in ((start, hint.start), (end, hint.end))
        if name not in at or not _on_one_bar(vertex, at[name], drawing)
    )
    nicest = min(RADII[0], max(RADII[2], SHARE * _room(vertex, (start, end), at.values())))
    if abs(sweep) > SMALLEST_ANGLE:
        yield [
            AngleArc(Bow(vertex, radius, start, sweep, THIN), legs, hint, 0.6 * abs(radius - nicest))
            for radius in RADII
        ]


def _room(vertex: Vector, sides: tuple[float, float], points: Iterable[Vector]) -> float:
    """How far it is along the sides of an angle to the next point, which may have marks of its own."""
    steps = [(point - vertex, polar(side)) for point in points for side in sides]
    reaches = [step.dot(toward) for step, toward in steps if abs(step.cross(toward)) < NEAR]
    return min((reach for reach in reaches if reach > NEAR), default=inf)


def _on_one_bar(one: Vector, other: Vector, drawing: Drawing) -> bool:
    """Whether a bar is drawn through both points, so that no thin line is needed between them."""
    axes = [Line(part.start, part.end - part.start) for part in drawing.parts if isinstance(part, Bar)]
    return any(on_line(one, axis) and on_line(other, axis) for axis in axes)


@dataclass(frozen=True)
class AngleArc:
    """An arc, with an arrowhead when the sense matters, and the thin lines it needs for its sides."""

    bow: Bow
    legs: tuple[Leg, ...]
    hint: Angle
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arc; its sides are where they are."""
        return chords(self.bow)

    def wish(self) -> Wish:
        """Along the arc."""
        return along_bow(self.hint.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The sides, the arrowhead, the arc."""
        bow = self.bow
        sides = tuple(self._side(angle, reach) for angle, reach in self.legs)
        parts: tuple[Primitive, ...] = (Strokes(sides, THIN),) if sides else ()
        if self.hint.sense is not None and abs(bow.sweep) * bow.radius > 2 * HEAD_LENGTH:
            toward = polar(bow.start + bow.sweep)
            tangent = toward.turned() * (1.0 if bow.sweep > 0 else -1.0)
            parts += (arrowhead(bow.centre + toward * bow.radius, tangent),)
        return (*parts, bow)

    def _side(self, angle: float, reach: float) -> Segment:
        needed = self.bow.radius + (1.0 if reach else BEYOND)
        toward = polar(angle)
        return (self.bow.centre + toward * (PIN + 0.15), self.bow.centre + toward * max(reach, needed))
