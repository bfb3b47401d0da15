"""Given motions as arrows: curved about a pivot or straight at a point, each with several
alternatives.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from kinegrade.figure.joints.drivers import MovingPoint, TurningBody, find_given_motion
from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.mark import Mark, chords, direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_along_arc, list_spots_beside
from kinegrade.figure.plane import angle_of, length, mean, shorter_way, unit
from kinegrade.figure.scene import THIN, Bow, Primitive
from kinegrade.figure.symbols import PIN, draw_arrow, draw_curved_arrow
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import TURN, Moving, Sense, Turning

_ARROW = 9.0  # millimetres, length of the arrow of a straight motion
_TURNING_RADII = (5.0, 6.5, 8.0, 10.0)  # millimetres, of the arrow of a rotation about its pivot
TURNING_ARC = 6.5  # millimetres, length of that arrow
TWELFTHS = tuple(index * pi / 6 for index in range(12))


def mark_rotations(mechanism: Mechanism, hint: Turning, drawing: Drawing) -> list[Mark]:
    """Arrows about the pivot of a body, the preferred one close to it, where the body leaves it."""
    centre = find_pivot(mechanism, hint.body, drawing)
    sense = TURN[hint.sense or _find_imposed_sense(mechanism, hint.body)]
    crank = _find_crank_direction(mechanism, hint.body, centre, drawing)
    found: list[Mark] = []
    for radius in (
        *_TURNING_RADII,
        *(rim.radius + 2.0 for rim in drawing.rims if rim.body == hint.body),
    ):
        span = TURNING_ARC / radius * sense
        for angle in TWELFTHS:
            demerit = 1.5 * abs(radius - _TURNING_RADII[0]) + 2.5 * abs(shorter_way(angle - crank))
            found.append(
                TurningArrow(
                    Bow(centre, radius, angle - span / 2, span, THIN), hint.symbol, demerit
                )
            )
    return found


@dataclass(frozen=True)
class TurningArrow:
    """A curved arrow along an arc."""

    bow: Bow
    symbol: str
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arc."""
        return chords(self.bow)

    def wish(self) -> Wish:
        """Along the arc."""
        return list_spots_along_arc(self.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc and its arrowhead."""
        return draw_curved_arrow(self.bow.centre, self.bow.radius, self.bow.start, self.bow.sweep)


def _find_crank_direction(
    mechanism: Mechanism, body: str, centre: Vector, drawing: Drawing
) -> float:
    """The direction in which a body extends from its pivot; up when it extends in none."""
    points = [mechanism.points[name] for name in mechanism.body(body).points]
    points += [
        end
        for part in drawing.parts
        if isinstance(part, Bar) and part.body == body
        for end in part.free
    ]
    far = max(points, key=lambda point: length(point - centre))
    return angle_of(far - centre) if length(far - centre) > 1.0 else pi / 2


def find_pivot(mechanism: Mechanism, body: str, drawing: Drawing) -> Vector:
    """Where a body's rotation is marked: its fixed pin, else its circle's centre, else the mean of
    its points.
    """
    pin = find_fixed_pin(drawing.symbols, body)
    if pin is not None:
        return mechanism.points[pin]
    for rim in drawing.rims:
        if rim.body == body:
            return rim.at
    return mean(mechanism.points[name] for name in mechanism.body(body).points)


def _find_imposed_sense(mechanism: Mechanism, body: str) -> Sense:
    """The sense in which a driver turns the body; counter-clockwise when none does."""
    for driver in mechanism.drivers:
        motion = find_given_motion(mechanism.points, driver)
        if isinstance(motion, TurningBody) and motion.body == body:
            return motion.sense
    return "ccw"


def mark_motions(mechanism: Mechanism, hint: Moving) -> list[Mark]:
    """Arrows in the direction of the motion: from the point, then beside it, first those clear of
    the mechanism.
    """
    point = mechanism.points[hint.point]
    toward = (
        unit(direction(mechanism.points, point, hint.along))
        if hint.along
        else _find_imposed_direction(mechanism, hint.point)
    )
    across = toward.turned()
    across = across if across.dot(mean(mechanism.points.values()) - point) <= 1e-6 else -across
    starts = [point + toward * gap for gap in (PIN + 0.2, 3.4, 6.0)]
    starts += [
        point + across * (side * offset) + toward * shift
        for offset in (3.6, 5.0, 6.5)
        for shift in (0.0, -_ARROW / 2, 3.0)
        for side in (1.0, -1.0)
    ]
    return [
        _MovingArrow(start, toward, hint.symbol, 0.5 * rank) for rank, start in enumerate(starts)
    ]


@dataclass(frozen=True)
class _MovingArrow:
    """A straight arrow from `start` in the direction `toward`."""

    start: Vector
    toward: Vector
    symbol: str
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its start."""
        return ((self.start + self.toward, self._end()),)

    def wish(self) -> Wish:
        """Beside the arrow, else around its tip."""
        shaft = list_spots_beside(self.symbol, self.start + self.toward * 3, self._end())
        return Wish(self.symbol, shaft, self._end())

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead."""
        return draw_arrow(self.start, self._end())

    def _end(self) -> Vector:
        return self.start + self.toward * _ARROW


def _find_imposed_direction(mechanism: Mechanism, point: str) -> Vector:
    """The direction of the velocity that a driver gives the point; to the right when none does."""
    for driver in mechanism.drivers:
        motion = find_given_motion(mechanism.points, driver)
        if isinstance(motion, MovingPoint) and motion.point == point:
            return motion.toward
    return Vector(1.0, 0.0)
