"""The arrows of imposed motions: what the drivers say of them, and which of them there are."""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from kinegrade.figure.joints.drivers import MovingPoint, TurningBody, find_given_motion
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints, Moving, Sense, Turning


def drop_still(mechanism: Mechanism, hints: FigureHints) -> FigureHints:
    """The hints without the arrows of what a driver holds at zero."""
    return replace(
        hints, arrows=tuple(arrow for arrow in hints.arrows if not _is_still(mechanism, arrow))
    )


def _is_still(mechanism: Mechanism, arrow: Turning | Moving) -> bool:
    match arrow:
        case Turning(sense=None):
            turning = _find_turning(mechanism, arrow)
            return turning is not None and turning.sense is None
        case Moving(along=None):
            moving = _find_moving(mechanism, arrow)
            return moving is not None and moving.toward is None
        case Turning() | Moving():
            return False
        case _:
            assert_never(arrow)


def find_imposed_sense(mechanism: Mechanism, arrow: Turning) -> Sense:
    """The sense in which a driver turns the body; counter-clockwise when none does."""
    turning = _find_turning(mechanism, arrow)
    return (turning.sense if turning else None) or "ccw"


def find_imposed_direction(mechanism: Mechanism, arrow: Moving) -> Vector:
    """The direction of the rate that a driver gives the point; to the right when none does."""
    moving = _find_moving(mechanism, arrow)
    return (moving.toward if moving else None) or Vector(1.0, 0.0)


def _find_turning(mechanism: Mechanism, arrow: Turning) -> TurningBody | None:
    for driver in mechanism.drivers:
        motion = find_given_motion(mechanism.points, driver, arrow.level)
        if isinstance(motion, TurningBody) and (motion.body, motion.of) == (arrow.body, arrow.of):
            return motion
    return None


def _find_moving(mechanism: Mechanism, arrow: Moving) -> MovingPoint | None:
    drivers = mechanism.drivers if arrow.driver is None else (mechanism.drivers[arrow.driver],)
    for driver in drivers:
        motion = find_given_motion(mechanism.points, driver, arrow.level)
        if isinstance(motion, MovingPoint) and motion.point == arrow.point:
            return motion
    return None
