"""The table of drivers: what each shows of the motion it imposes, which is its sense and never its
amount.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import assert_never

from msgspec import Struct

from kinegrade.figure.plane import unit
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.hints import LEVELS, Sense

_SENSES: Mapping[float, Sense | None] = {1.0: "ccw", 0.0: None, -1.0: "cw"}


class TurningBody(Struct, frozen=True):
    """A body that is turned relative to another: its sense, None where the rate is zero."""

    body: str
    of: str
    sense: Sense | None


class MovingPoint(Struct, frozen=True):
    """A point that is moved in a direction, given by a unit vector; None where the rate is zero."""

    point: str
    toward: Vector | None


def find_given_motion(
    points: Mapping[str, Vector], driver: Driver, level: Level
) -> TurningBody | MovingPoint:
    """What the arrow of a driver's velocity or acceleration shows."""
    match driver:
        case Rotation():
            return TurningBody(driver.body, driver.of, _SENSES[_find_sign(driver, level)])
        case Component():
            return MovingPoint(driver.point, _point(driver.direction, _find_sign(driver, level)))
        case Circulation():
            around_centre = (points[driver.point] - points[driver.centre]).turned()
            return MovingPoint(driver.point, _point(around_centre, _find_sign(driver, level)))
        case _:
            assert_never(driver)


def find_motor(driver: Driver) -> tuple[str, str] | None:
    """The two moving bodies that a driver turns against each other, by a motor at their pin."""
    match driver:
        case Rotation(body=body, of=of):
            return None if of == GROUND else (body, of)
        case Component() | Circulation():
            return None
        case _:
            assert_never(driver)


def reduce_to_sense(driver: Driver) -> Driver:
    """The driver with rates of 1, 0 or -1, its direction of unit length."""
    match driver:
        case Component():
            return _reduce_rates(replace(driver, direction=unit(driver.direction)))
        case Rotation() | Circulation():
            return _reduce_rates(driver)
        case _:
            assert_never(driver)


def _reduce_rates(driver: Driver) -> Driver:
    velocity, acceleration = (_find_sign(driver, level) for level in LEVELS)
    return replace(driver, velocity=velocity, acceleration=acceleration)


def _point(direction: Vector, sign: float) -> Vector | None:
    return unit(direction) * sign if sign else None


def _find_sign(driver: Driver, level: Level) -> float:
    match level:
        case "velocity":
            rate = driver.velocity
        case "acceleration":
            rate = driver.acceleration
        case _:
            assert_never(level)
    return float((rate > 0) - (rate < 0))
