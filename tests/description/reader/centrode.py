"""Poles, and the circle on which they lie while the mechanism moves."""

from __future__ import annotations

import numpy

from tests.description.reader.geometry import Circle, cross
from tests.description.reader.kinematics import Mechanism, NotMovable, System

SMALL = 1e-9
TURN = 0.02
PRECISION = 1e-13


class AtInfinity(ArithmeticError):
    """A point or a radius that is infinitely far or great."""


def pole(velocity: complex, turning: float, reach: float) -> complex:
    """The point at rest of a body that turns, by the velocity of its point at the origin."""
    if abs(turning) * reach <= SMALL * abs(velocity) or turning == 0:
        raise AtInfinity("a body that does not turn has no pole")
    return 1j * velocity / turning


def circle_through(points: list[complex]) -> Circle:
    """The circle through all the points, of which there are more than three."""
    first, second, third = points[0], points[len(points) // 2], points[-1]
    across, along = second - first, third - first
    area = 2 * cross(across, along)
    if abs(area) < SMALL * abs(across) * abs(along):
        raise AtInfinity("the poles lie on a straight line")
    centre = first + 1j * (across * abs(along) ** 2 - along * abs(across) ** 2) / area
    radius = abs(first - centre)
    if any(abs(abs(point - centre) - radius) > 1e-6 * radius for point in points):
        raise ValueError("the poles do not lie on a circle")
    return Circle(centre, radius)


def poles_on_the_way(mechanism: Mechanism, body: str) -> list[complex]:
    """The poles of a body at some places on its way, the present one in the middle."""
    size = 3 * len(mechanism.bodies)
    here = numpy.zeros(size)
    ways: list[list[complex]] = []
    for sense in (-1.0, 1.0):
        value, way, passed = here, heading(System(mechanism.slopes(here))), []
        way = way * sense
        for _ in range(3):
            passed.append(pole_at(mechanism, body, value, way))
            value = corrected(mechanism, value + TURN * way)
            ahead = heading(System(mechanism.slopes(value)))
            way = ahead if ahead @ way > 0 else -ahead
        ways.append(passed)
    return [*reversed(ways[0][1:]), *ways[1]]


def heading(system: System) -> numpy.ndarray:
    """The one direction in which the bodies can move, without their drives."""
    if len(system.open) != 1:
        raise NotMovable(f"{len(system.open)} motions are open where one should be")
    return numpy.asarray(system.open[0])


def pole_at(mechanism: Mechanism, body: str, value: numpy.ndarray, way: numpy.ndarray) -> complex:
    """The pole of the body at a place on its way."""
    line = 3 * mechanism.bodies.index(body)
    origin = complex(value[line], value[line + 1]) * mechanism.scale
    velocity = complex(way[line], way[line + 1]) * mechanism.scale
    return origin + pole(velocity, float(way[line + 2]), mechanism.scale)


def corrected(mechanism: Mechanism, value: numpy.ndarray) -> numpy.ndarray:
    """The nearest place at which all joints fit together again."""
    size = value.size
    still = numpy.zeros(size)

    def lengths(place: numpy.ndarray) -> numpy.ndarray:
        equations = mechanism.equations(mechanism.motion(still, still, place))
        return numpy.array([float(one.value) for one in equations])

    wanted = lengths(still)
    for _ in range(20):
        slopes = mechanism.slopes(value)
        step = numpy.linalg.lstsq(slopes, wanted - lengths(value), rcond=1e-10)[0]
        value = value + step
        if float(numpy.linalg.norm(step)) < PRECISION:
            return value
    raise NotMovable("the mechanism cannot move on")
