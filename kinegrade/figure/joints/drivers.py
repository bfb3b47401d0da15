"""The table of drivers: what each shows of the motion it imposes, which is its sense and never its
amount.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.figure.plane import unit
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Sense


@dataclass(frozen=True)
class TurningBody:
    """A body that is turned in a sense."""

    body: str
    sense: Sense


@dataclass(frozen=True)
class MovingPoint:
    """A point that is moved in a direction, given by a unit vector."""

    point: str
    toward: Vector


def find_given_motion(points: Mapping[str, Vector], driver: Driver) -> TurningBody | MovingPoint:
    """What the arrow of a driver shows."""
    match driver:
        case Rotation():
            return TurningBody(driver.body, "cw" if driver.velocity < 0 else "ccw")
        case Component():
            return MovingPoint(driver.point, unit(driver.direction) * _find_sign(driver))
        case Circulation():
            around_centre = (points[driver.point] - points[driver.centre]).turned()
            return MovingPoint(driver.point, unit(around_centre) * _find_sign(driver))
        case _:
            assert_never(driver)


def reduce_to_sense(driver: Driver) -> Driver:
    """The driver with a velocity of 1 or -1 and without acceleration, its direction of unit
    length.
    """
    match driver:
        case Component():
            along = unit(driver.direction)
            return replace(driver, velocity=_find_sign(driver), acceleration=0.0, direction=along)
        case Rotation() | Circulation():
            return replace(driver, velocity=_find_sign(driver), acceleration=0.0)
        case _:
            assert_never(driver)


def _find_sign(driver: Driver) -> float:
    return -1.0 if driver.velocity < 0 else 1.0
