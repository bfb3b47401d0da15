"""What one joint contributes to a drawing, as plain values in the unit of the mechanism.

The layers of `figure/mechanism` ask these values and never which joint it was; `table.py` makes
them, one entry for each joint.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from msgspec import Struct

from kinegrade.figure.plane import angle_of, shorter_way
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

Kind = Literal["wheel", "gear", "slot", "cam", "edge"]
Use = Literal["link", "broad", "slot", "bar", "face", "rack", "jaw"]
Strand = tuple[Vector, Vector]  # a straight part of a belt, from rim to rim
_BEYOND = 0.65  # radians that an arc goes on beyond its last contact
NO_BACK = Vector(0.0, 0.0)


class Rim(Struct, frozen=True):
    """A circle of a body; `ring` when the material lies outside; `touch` is the contact point.

    The kind "edge" is a circle that belongs to no joint, like that of a flange. A gear has a tooth
    at `tooth` on its pitch circle. Of a track with `contacts` only the arc around these is drawn.
    """

    body: str
    centre: str
    at: Vector
    radius: float
    kind: Kind
    ring: bool
    touch: Vector
    tooth: Vector
    contacts: tuple[Vector, ...] = ()

    def find_arc(self) -> tuple[float, float] | None:
        """The angle at which the arc begins that is drawn, and how far it goes; None for all."""
        if not self.contacts:
            return None
        first = angle_of(self.contacts[0] - self.at)
        beside = [shorter_way(angle_of(at - self.at) - first) for at in self.contacts]
        return first + min(beside) - _BEYOND, max(beside) - min(beside) + 2 * _BEYOND


class Feature(Struct, frozen=True):
    """A line of a moving body with the point on it where another body acts; `back` as for a Bar."""

    body: str
    line: Line
    action: Vector
    use: Use
    back: Vector = NO_BACK


class Foot(Struct, frozen=True):
    """Where a round body stands on a straight track of the ground; `away` leads into the ground."""

    line: Line
    contact: Vector
    away: Vector
    radius: float
    toothed: bool


class Guide(Struct, frozen=True):
    """A straight guide of the ground, with the place of `body` in it; `along` is a unit vector."""

    body: str
    at: Vector
    along: Vector


class Hanging(Struct, frozen=True):
    """A rope along a line of its body, from where it leaves a wheel to its end; `loaded` when a
    load hangs there.
    """

    body: str
    line: Line
    start: Vector
    end: Vector
    loaded: bool


class Symbol(Struct, frozen=True):
    """What a joint adds to each layer; nothing by default.

    - `point`: the marked point at which the joint is; `pinned` when it is an open circle, `fixed`
      when it stands on the ground; `turning` are the bodies that share it;
    - `edge`: a body whose point runs on the rim of another;
    - `translating`: a body that the joint keeps from turning against the ground;
    - `rims`, `features`, `foot`, `guide`: circles, lines of bodies, a track and a guide;
    - `strands`: the straight parts of a belt; `hanging`: a rope;
    - `sleeve`, `block`: where one is, with the unit vector along which it slides; `carrier` is the
      body of which a sleeve is a part.
    """

    point: str | None = None
    pinned: bool = False
    fixed: bool = False
    turning: tuple[str, ...] = ()
    edge: str | None = None
    translating: str | None = None
    rims: tuple[Rim, ...] = ()
    features: tuple[Feature, ...] = ()
    foot: Foot | None = None
    guide: Guide | None = None
    strands: tuple[Strand, ...] = ()
    hanging: Hanging | None = None
    sleeve: Line | None = None
    block: Line | None = None
    carrier: str | None = None


def is_particle(mechanism: Mechanism, name: str) -> bool:
    """Whether a body is a particle: a bare pin wherever it slides."""
    return any(body.name == name and body.particle for body in mechanism.bodies)


def find_fixed_pins(symbols: Sequence[Symbol]) -> list[str]:
    """The points fixed to the ground: its pins, and those about which it guides a moving line."""
    return list(dict.fromkeys(joint.point for joint in symbols if joint.fixed and joint.point))


def find_fixed_pin(symbols: Sequence[Symbol], body: str) -> str | None:
    """The first point about which a body turns on the ground; None when it turns about none."""
    pins = (symbol.point for symbol in symbols if symbol.fixed and body in symbol.turning)
    return next(pins, None)


def find_pins(mechanism: Mechanism, symbols: Sequence[Symbol]) -> frozenset[Vector]:
    """Where the mechanism has pins."""
    names = (joint.point for joint in symbols if joint.point and joint.pinned)
    return frozenset(mechanism.points[name] for name in names)
