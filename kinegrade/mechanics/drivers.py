"""The drivers: what is imposed on the mechanism, each with its velocity and its acceleration."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Rotation:
    """Rotation of `body` relative to the body `of`: rad/s and rad/s^2, counter-clockwise
    positive.
    """

    body: str
    velocity: Any
    acceleration: Any
    of: str = GROUND


@dataclass(frozen=True)
class Component:
    """Motion of `point` of `body` along the unit vector `direction`, relative to the body `of`: m/s
    and m/s^2.

    For a point that moves on a straight path this is its motion along the path.
    """

    point: str
    body: str
    direction: Vector
    velocity: Any
    acceleration: Any
    of: str = GROUND


@dataclass(frozen=True)
class Circulation:
    """Motion of `point` of `body` along its circular path about the fixed point `centre`.

    Velocity in m/s and tangential acceleration in m/s^2, counter-clockwise about the centre
    positive.
    """

    point: str
    body: str
    centre: str
    velocity: Any
    acceleration: Any


Driver = Rotation | Component | Circulation
