"""Angles: arcs of several radii, with thin lines along any side of the angle that is not drawn as a
bar.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import inf, pi

from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.mark import Mark, chords, direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.placing.wedge import list_spots_in_wedge, measure_narrow
from kinegrade.figure.plane import NEAR, angle_of, length, on_line, polar, shorter_way, unit
from kinegrade.figure.scene import THIN, Bow, Primitive, Strokes
from kinegrade.figure.symbols import PIN, draw_arc_head
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import TURN, Angle

_SMALLEST_ANGLE = pi / 180  # an angle below one degree shows no arc
# Millimetres, the preferred radius first
_RADII = (7.0, 6.2, 5.5, 4.5, 8.5, 10.0, 12.0, 14.0, 17.0, 20.0, 3.2)
_WIDEST = 17.0  # millimetres that are still preferred for a narrow angle
_SHARE = 0.45  # largest radius of an arc over the distance to the next point on a side
_LETTER = 1.8  # millimetres from an arc to the middle of its letter
_BEYOND = 2.5  # millimetres that a thin line along a side continues beyond the arc

_EXTENDED = 2.5  # demerit of an arc beyond the end of a bar, which needs a thin line to reach it
# Demerits of an arc that ends within so many millimetres of a point on a side
_ON_PIN, _ON_BLOCK = 12.0, 4.0
_PIN_ROOM, _BLOCK_ROOM = 1.6, 3.2
_TRIM = 1.5  # millimetres at either end of an arc where it meets its sides, as it should


def mark_angles(at: Mapping[str, Vector], hint: Angle, drawing: Drawing) -> Iterator[list[Mark]]:
    """Arcs of several radii; none when the angle is too small to be visible."""
    vertex = at[hint.at]
    legs = _draw_legs(at, hint, drawing)
    start, end = (leg.angle for leg in legs)
    sweep = shorter_way(end - start)
    if hint.sense is not None and abs(sweep) > _SMALLEST_ANGLE:
        turn = TURN[hint.sense]
        sweep = turn * ((turn * sweep) % (2 * pi))
    reaches = _measure_reaches(vertex, (start, end), at.values())
    nicest = min(_RADII[0], max(_RADII[3], _SHARE * min(reaches, default=inf)))
    narrow = measure_narrow(hint.symbol, Bow(vertex, nicest, start, sweep, THIN)) - _LETTER
    nicest = max(nicest, min(narrow, _WIDEST))
    if abs(sweep) > _SMALLEST_ANGLE:
        yield [
            _AngleArc(
                Bow(vertex, radius, start, sweep, THIN),
                legs,
                hint,
                _rate_demerit(radius, nicest, legs) + _rate_ends(radius, reaches),
            )
            for radius in _RADII
        ]


def draw_least_legs(
    at: Mapping[str, Vector], hint: Angle, drawing: Drawing
) -> tuple[Primitive, ...]:
    """The thin lines that the sides of an angle need in any case; labels written before the angle
    keep clear of them.
    """
    lines = tuple(
        line for leg in _draw_legs(at, hint, drawing) if (line := leg.line(at[hint.at], _RADII[3]))
    )
    return (Strokes(lines, THIN),) if lines else ()


def _draw_legs(at: Mapping[str, Vector], hint: Angle, drawing: Drawing) -> tuple[_Leg, ...]:
    vertex, legs = at[hint.at], []
    for name in (hint.start, hint.end):
        side = angle_of(direction(at, vertex, name))
        legs.append(
            _Leg(
                side,
                _measure_drawn(vertex, polar(side), drawing),
                length(at[name] - vertex) if name in at else 0.0,
            )
        )
    return tuple(legs)


@dataclass(frozen=True)
class _Leg:
    """A side of an angle: its direction, how far a bar is drawn along it, and how far away the
    point on it is (0 for none).
    """

    angle: float
    drawn: float
    reach: float

    def line(self, vertex: Vector, radius: float) -> Segment | None:
        """The thin line that an arc of this radius needs; None when the bar is long enough."""
        if radius < self.drawn + PIN:
            return None
        toward = polar(self.angle)
        needed = radius + (1.0 if self.reach else _BEYOND)
        far = needed if self.drawn else max(needed, self.reach)
        return vertex + toward * max(self.drawn, PIN + 0.15), vertex + toward * far


def _rate_demerit(radius: float, nicest: float, legs: Iterable[_Leg]) -> float:
    """The demerit grows with the distance from the preferred radius, and more where a bar has to be
    prolonged.
    """
    prolonged = sum(0 < leg.drawn < radius for leg in legs)
    return 0.6 * abs(radius - nicest) + _EXTENDED * prolonged


def _rate_ends(radius: float, reaches: Iterable[float]) -> float:
    """The demerit of an arc whose end lies on a pin, or on the block that may be there."""
    gap = min((abs(reach - radius) for reach in reaches), default=inf)
    return _ON_PIN if gap < _PIN_ROOM else _ON_BLOCK if gap < _BLOCK_ROOM else 0.0


def _measure_reaches(
    vertex: Vector, sides: tuple[float, float], points: Iterable[Vector]
) -> list[float]:
    """The distances along the sides of an angle to other points, which may have marks too."""
    steps = [(point - vertex, polar(side)) for point in points for side in sides]
    reaches = [step.dot(toward) for step, toward in steps if abs(step.cross(toward)) < NEAR]
    return [reach for reach in reaches if reach > NEAR]


def _measure_drawn(vertex: Vector, toward: Vector, drawing: Drawing) -> float:
    """How far a bar is drawn from a point on it in a direction; 0 when none is."""
    reaches = [0.0]
    for part in drawing.parts:
        if isinstance(part, Bar) and on_line(vertex, Line(part.start, part.end - part.start)):
            steps = [end - vertex for end in (part.start, part.end)]
            if (
                abs(unit(steps[0] - steps[1]).cross(toward)) < NEAR
                and min(step.dot(toward) for step in steps) < 1.0
            ):
                reaches += [step.dot(toward) for step in steps]
    return max(reaches)


@dataclass(frozen=True)
class _AngleArc:
    """An arc, with an arrowhead when the sense matters, and the thin lines its sides need."""

    bow: Bow
    legs: tuple[_Leg, ...]
    hint: Angle
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arc between its sides."""
        bow = self.bow
        inset = min(_TRIM / bow.radius, abs(bow.sweep) / 3)
        inset = inset if bow.sweep > 0 else -inset
        return chords(replace(bow, start=bow.start + inset, sweep=bow.sweep - 2 * inset))

    def wish(self) -> Wish:
        """Between the sides."""
        return list_spots_in_wedge(self.hint.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The sides, the arrowhead, the arc."""
        bow = self.bow
        sides = tuple(line for leg in self.legs if (line := leg.line(bow.centre, bow.radius)))
        parts: tuple[Primitive, ...] = (Strokes(sides, THIN),) if sides else ()
        if self.hint.sense or self.hint.signed:
            parts += (draw_arc_head(bow),)
        return (*parts, bow)
