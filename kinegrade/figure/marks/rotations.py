"""Rotations as curved arrows about a pivot, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import pi

from kinegrade.figure.joints.drivers import TurningBody, find_given_motion
from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import Mark, chords
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_along_arc
from kinegrade.figure.plane import angle_of, length, mean, shorter_way
from kinegrade.figure.scene import THIN, Bow, Primitive
from kinegrade.figure.symbols import draw_curved_arrow
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import TURN, Sense, Turning

_RADII = (5.0, 6.5, 8.0, 10.0)  # millimetres, of the arrow of a rotation about its pivot
_ARC = 6.5  # millimetres, length of that arrow
_TWELFTHS = tuple(index * pi / 6 for index in range(12))
_ASTRAY = 2.5  # demerit of each radian between the arrow and the body
# Millimetres about a pivot within which the arrow of a rotation keeps clear of letters
_LETTERED = 8.0


def add_rotation(
    layout: Layout, mechanism: Mechanism, hint: Turning, drawing: Drawing, named: Iterable[Wish]
) -> Layout:
    """The layout with an arrow about the pivot of a body, the preferred one close to it, where the
    body leaves it; it keeps clear of the letters `named` that are still to be written there.
    """
    centre = _find_pivot(mechanism, hint.body, drawing)
    close = [wish for wish in named if length(Vector(*wish.spots[0]) - centre) < _LETTERED]
    sense = hint.sense or _find_imposed_sense(mechanism, hint.body)
    crank = _find_crank_direction(mechanism, hint.body, centre, drawing)
    outside = [rim.radius + 2.0 for rim in drawing.rims if rim.body == hint.body]
    radii = (*_RADII, *outside)
    arrows = list_turning_arrows(hint.symbol, sense, centre, radii, crank, astray=_ASTRAY)
    return layout.marked(arrows, layout.written(close).labels)


def list_turning_arrows(
    symbol: str,
    sense: Sense,
    centre: Vector,
    radii: Sequence[float],
    toward: float,
    *,
    astray: float,
) -> list[Mark]:
    """Curved arrows about a centre, of each radius (millimetres, the preferred one first) and in
    twelve directions; `astray` is the demerit of each radian away from the direction `toward`.
    """
    found: list[Mark] = []
    for radius in radii:
        span = _ARC / radius * TURN[sense]
        for angle in _TWELFTHS:
            bow = Bow(centre, radius, angle - span / 2, span, THIN)
            demerit = 1.5 * abs(radius - radii[0]) + astray * abs(shorter_way(angle - toward))
            found.append(_TurningArrow(bow, symbol, demerit))
    return found


@dataclass(frozen=True)
class _TurningArrow:
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


def _find_pivot(mechanism: Mechanism, body: str, drawing: Drawing) -> Vector:
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
