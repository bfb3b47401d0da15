"""Given motions as arrows: curved about a pivot, straight at a point, each in several ways to choose from."""

from __future__ import annotations

from math import pi

import numpy as np

from kinegrade.figure.bars import Bar
from kinegrade.figure.layers import Drawing
from kinegrade.figure.mark import Mark, along_bow, direction, sampled
from kinegrade.figure.place import Wish, around, beside
from kinegrade.figure.plane import angle_of, length, mean, shorter_way, unit
from kinegrade.figure.rims import Rim
from kinegrade.figure.scene import THIN, Bow
from kinegrade.figure.symbols import PIN, arrow, curved_arrow
from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.hints import Moving, Turning

ARROW = 9.0  # millimetres, length of the arrow of a straight motion
TURNING_RADII = (5.0, 6.5, 8.0, 10.0)  # millimetres, of the arrow of a rotation about its pivot
TURNING_ARC = 6.5  # millimetres, length of that arrow
TWELFTHS = tuple(index * pi / 6 for index in range(12))


def turning_marks(mechanism: Mechanism, hint: Turning, drawing: Drawing) -> list[Mark]:
    centre = _pivot(mechanism, hint.body, drawing.rims)
    sense = 1.0 if (hint.sense or _imposed_sense(mechanism, hint.body)) == "ccw" else -1.0
    crank = _crank(mechanism, hint.body, centre, drawing)
    marks_found = []
    for radius in (*TURNING_RADII, *(rim.radius + 2.0 for rim in drawing.rims if rim.body == hint.body)):
        for angle in TWELFTHS:
            span = TURNING_ARC / radius * sense
            arc = curved_arrow(centre, radius, angle - span / 2, span)
            wish = Wish(hint.symbol, along_bow(centre, radius, angle - span / 2, span, hint.symbol))
            path = Bow(centre, radius, angle - span / 2, span, THIN).path()
            demerit = 2.0 * abs(radius - TURNING_RADII[0]) + 4.0 * abs(shorter_way(angle - crank))
            marks_found.append(Mark(arc, path, wish, demerit))
    return marks_found


def _crank(mechanism: Mechanism, body: str, centre: Vector, drawing: Drawing) -> float:
    """The direction in which a body extends from its pivot; up when it has none."""
    own = [mechanism.points[name] for name in mechanism.body(body).points]
    own += [end for part in drawing.parts if isinstance(part, Bar) and part.body == body for end in part.free]
    far = max(own, key=lambda point: length(point - centre))
    return angle_of(far - centre) if length(far - centre) > 1.0 else pi / 2


def _pivot(mechanism: Mechanism, body: str, found: tuple[Rim, ...]) -> Vector:
    """The fixed pin of the body, else the centre of its circle, else the middle of its points."""
    for joint in mechanism.joints:
        if isinstance(joint, Pin) and GROUND in joint.bodies and body in joint.bodies:
            return mechanism.points[joint.point]
    own = [rim.at for rim in found if rim.body == body]
    return own[0] if own else mean(mechanism.points[name] for name in mechanism.body(body).points)


def _imposed_sense(mechanism: Mechanism, body: str) -> str:
    for driver in mechanism.drivers:
        if isinstance(driver, Rotation) and driver.body == body:
            return "cw" if driver.velocity < 0 else "ccw"
    return "ccw"


def moving_marks(mechanism: Mechanism, hint: Moving) -> list[Mark]:
    point = mechanism.points[hint.point]
    toward = (
        unit(direction(mechanism.points, point, hint.along))
        if hint.along
        else _imposed(mechanism, hint.point)
    )
    across = toward.turned()
    starts = [point + toward * gap for gap in (PIN + 0.2, 3.4, 6.0)]
    starts += [
        point + across * (side * offset) + toward * shift
        for offset in (3.6, 5.0, 6.5)
        for shift in (0.0, -ARROW / 2, 3.0)
        for side in (1.0, -1.0)
    ]
    found: list[Mark] = []
    for start in starts:
        end = start + toward * ARROW
        spots = np.concatenate((beside(hint.symbol, start + toward * 3, end), around(hint.symbol, end)))
        demerit = 0.5 * len(found)
        found.append(Mark(arrow(start, end), sampled(start + toward, end), Wish(hint.symbol, spots), demerit))
    return found


def _imposed(mechanism: Mechanism, point: str) -> Vector:
    """The direction of the velocity that a driver gives the point; to the right when none does."""
    for driver in mechanism.drivers:
        if isinstance(driver, Component) and driver.point == point:
            return unit(driver.direction) * (-1.0 if driver.velocity < 0 else 1.0)
        if isinstance(driver, Circulation) and driver.point == point:
            around_centre = (mechanism.points[point] - mechanism.points[driver.centre]).turned()
            return unit(around_centre) * (-1.0 if driver.velocity < 0 else 1.0)
    return Vector(1.0, 0.0)
