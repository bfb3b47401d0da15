"""What a template's author wants marked in the figure.

The shape of the mechanism itself is never a hint: it follows from bodies and joints.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector_equation import Level

Sense = Literal["ccw", "cw"]
Side = Literal["right", "up", "left", "down"]
Shape = Literal[
    "gear",
    "cam",
    "bent",
    "bar",
    "bare",
    "through",
    "cylinder",
    "arc",
    "rope",
    "load",
    "jaw",
    "disc",
    "geneva",
    "rack",
]
Projection = Literal["horizontal", "vertical"]
Axis = Literal["x", "y"]
Axes = Literal["origin", "aside"]

SENSES: tuple[Sense, ...] = ("ccw", "cw")
TURN: Mapping[Sense, float] = {"ccw": 1.0, "cw": -1.0}  # counter-clockwise is positive
SIDES: tuple[Side, ...] = ("right", "up", "left", "down")
SHAPES: tuple[Shape, ...] = get_args(Shape)
ROPES: tuple[Shape, ...] = ("rope", "load")
LEVELS: tuple[Level, ...] = ("velocity", "acceleration")
AXES: tuple[Axis, ...] = ("x", "y")
PLACES_OF_AXES: tuple[Axes, ...] = get_args(Axes)
PROJECTIONS: tuple[Projection, ...] = ("horizontal", "vertical")


@dataclass(frozen=True)
class Length:
    """A dimension between two points; along "horizontal" or "vertical" it is the projected
    distance; one that is `signed` may point the other way, and has bars about its symbol then.
    """

    symbol: str
    start: str
    end: str
    along: Projection | None = None
    signed: bool = False


@dataclass(frozen=True)
class Angle:
    """An angle at a point between two directions, each a side of the paper or another point.

    Drawn the shorter way, or in the given sense from `start` to `end`; where `least` is the least
    value drawn of a given beyond half a turn, as that is counted. An arrowhead shows the sense of
    one that is `signed`.
    """

    symbol: str
    at: str
    start: str
    end: str
    sense: Sense | None = None
    signed: bool = False
    least: float | None = None


@dataclass(frozen=True)
class Radius:
    """The radius of a circle about `centre`; `of` names its body, `through` a point on it, where
    several share it.
    """

    symbol: str
    centre: str
    of: str | None = None
    through: str | None = None


@dataclass(frozen=True)
class Rimmed:
    """A circle of a body that no joint knows of (the flange of a wheel), about one point through
    another.
    """

    body: str
    centre: str
    through: str


@dataclass(frozen=True)
class Turning:
    """A curved arrow about the pivot of a body, or about its pin on the body `of` that it turns
    relative to; without a sense it follows the sign of the imposed motion. In a solution it may be
    that of a rotation that is `sought`.
    """

    symbol: str
    body: str
    sense: Sense | None = None
    level: Level = "velocity"
    of: str = GROUND
    sought: bool = False


@dataclass(frozen=True)
class Moving:
    """A straight arrow at a point, towards a side or a point; else as the imposed motion has it:
    that of the `driver` of this number, or of the first that moves the point.
    """

    symbol: str
    point: str
    along: str | None = None
    level: Level = "velocity"
    driver: int | None = None


@dataclass(frozen=True)
class BodyFrame:
    """Two axes at a point of a body: the axis `along` points from `start` to `end`, a point or a
    side of the paper, and y is x turned through 90 degrees counter-clockwise.
    """

    x: str
    y: str
    at: str
    start: str
    end: str
    along: Axis = "x"


@dataclass(frozen=True)
class FigureHints:
    """Everything an author may ask of a figure.

    `labels` gives other text for a point, or text for a body ("ground": its fixed circle); None: no
    label. A point that is only constructed appears when it has a label. `lines` are thin, between
    two points; `right_angles` are marked at the second of three points. `shapes` overrides: "gear"
    (pitch circle), "cam" (a made-up profile, or one outline about `circles`), "bent" (a rod through
    its points in order, not a plate), "bar" (sliders run on it in sleeves, not in a slot), "bare"
    (pins slide in its slot, its ends on the ground, without blocks), "through" (a translating rod
    that goes on beyond its point), "cylinder" (one whose end is the piston in a closed cylinder),
    "jaw" (of a crusher, facing a fixed jaw), "arc" (a round track of which only the arc around its
    wheels is drawn), "rope" (what a wheel rolls on, from the wheel to its point), "load" (the same
    with a load at its point), "disc" (a disc about the first point, not a slotted bar), "geneva"
    (the slotted wheel of a Geneva drive), "rack" (a translating rod with teeth, whose gear is not
    in the figure). `supports` gives the side on which the support of a fixed pin stands; below it
    where nothing is said.
    """

    lengths: tuple[Length, ...] = ()
    angles: tuple[Angle, ...] = ()
    radii: tuple[Radius, ...] = ()
    circles: tuple[Rimmed, ...] = ()
    lines: tuple[tuple[str, str], ...] = ()
    right_angles: tuple[tuple[str, str, str], ...] = ()
    arrows: tuple[Turning | Moving, ...] = ()
    labels: Mapping[str, str | None] = field(default_factory=dict)
    shapes: Mapping[str, Shape] = field(default_factory=dict)
    supports: Mapping[str, Side] = field(default_factory=dict)
    frames: tuple[BodyFrame, ...] = ()
    axes: Axes | None = None
