"""The input of a mechanism: what its drivers move, as one coordinate."""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.laws import Law
from kinegrade.mechanics.relations.relation import Relation


@dataclass(frozen=True)
class Input:
    """What moves a mechanism: the displacement of its `leading` driver since the instant, rad or m.

    Other drivers go with it in proportion to the velocities that are given: `shares` are those of
    all relations, 0 for the joints'. `period` is a full turn of the leading one, None where it does
    not turn. `is_angle` tells radians from metres.
    """

    leading: Driver
    shares: tuple[float, ...]
    period: float | None
    is_angle: bool


def find_input(frames: Frames) -> Input | None:
    """The input of frames in doubles; None where nothing drives."""
    count = len(frames.mechanism.drivers)
    if not count:
        return None
    joints, driving = frames.relations[:-count], frames.relations[-count:]
    speeds = _measure_speeds(driving)
    number = next((number for number, speed in enumerate(speeds) if speed), 0)
    own = [speed / (speeds[number] or 1.0) for speed in speeds]
    own[number] = 1.0
    shares = (*(0.0 for _ in joints), *own)
    leading = frames.mechanism.drivers[number]
    period = _find_period(driving[number].source, frames, leading)
    return Input(leading, shares, period, leading.TURNS)


def _measure_speeds(driving: tuple[Relation, ...]) -> list[float]:
    """The velocities that are given; the accelerations where all begins at rest."""
    velocities = [float(relation.velocity) for relation in driving]
    return velocities if any(velocities) else [float(each.acceleration) for each in driving]


def _find_period(law: Law | None, frames: Frames, driver: Driver) -> float | None:
    """The full turn of a driver; None where it does not go round."""
    circle = law.find_imposed_circle() if law else None
    if circle:
        arm = frames.mechanism.points[circle[0]] - frames.mechanism.points[circle[1]]
        return math.tau * math.hypot(arm.x, arm.y)
    return math.tau if driver.TURNS else None
