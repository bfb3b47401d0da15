"""The joints: each a small frozen value that says which bodies meet, where, and how.

Points are named; lines are values in the common frame at the instant (x right, y up). The ground is
the body `GROUND`. What a joint means for velocities and accelerations is stated in `relations`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.vector import Vector

GROUND = "ground"


@dataclass(frozen=True)
class Line:
    """A straight line through `point` along `direction` (any length but zero)."""

    point: Vector
    direction: Vector


@dataclass(frozen=True)
class Circle:
    """A circle about the named point `centre`; `radius` in metres, positive."""

    centre: str
    radius: Any


@dataclass(frozen=True)
class Pin:
    """Two or more bodies (the ground may be one) share `point`."""

    point: str
    bodies: tuple[str, ...]


@dataclass(frozen=True)
class Slide:
    """`point` of `body` stays on a straight line fixed in the body `of` (a guide, a slot, a sleeve
    about a pin).
    """

    point: str
    body: str
    line: Line
    of: str


@dataclass(frozen=True)
class Sleeve:
    """`body` slides along `line` in the body `of` and does not turn relative to it."""

    body: str
    line: Line
    of: str


@dataclass(frozen=True)
class Arc:
    """`point` of `body` stays on a circle fixed in the body `of`; the centre is a point of `of`."""

    point: str
    body: str
    circle: Circle
    of: str


@dataclass(frozen=True)
class Contact:
    """A circle of `body` touches a line or circle of the body `of` and may slide on it (smooth
    contact).

    `inside` is for two circles only: one lies within the other.
    """

    body: str
    circle: Circle
    of: str
    on: Line | Circle
    inside: bool = False


@dataclass(frozen=True)
class Roll:
    """A circle of `body` rolls without slipping on a line or circle of the body `of`; `inside` as
    for Contact.
    """

    body: str
    circle: Circle
    of: str
    on: Line | Circle
    inside: bool = False


@dataclass(frozen=True)
class Mesh:
    """Two gears with their centres on one `carrier`; `inside` when one of them is a ring gear
    around the other.
    """

    body: str
    circle: Circle
    of: str
    on: Circle
    carrier: str
    inside: bool = False


@dataclass(frozen=True)
class Parallel:
    """`body` does not turn relative to the body `of`; with the ground: it translates."""

    body: str
    of: str


Joint = Pin | Slide | Sleeve | Arc | Contact | Roll | Mesh | Parallel
