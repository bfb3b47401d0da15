"""What a label on a tactile sheet names, and where it may stand."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.figure.tactile.piece import Piece
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.hints import BodyFrame, Projection


@dataclass(frozen=True)
class PointName:
    """The letter of a point."""

    symbol: str


@dataclass(frozen=True)
class BodyLabel:
    """The name of a body."""

    body: str
    symbol: str


@dataclass(frozen=True)
class AxesNames:
    """Two axes; those of a body have a frame."""

    x: str
    y: str
    frame: BodyFrame | None = None


@dataclass(frozen=True)
class LengthName:
    """A distance between two points, along a side of the paper or from one to the other."""

    symbol: str
    start: str
    end: str
    along: Projection | None


@dataclass(frozen=True)
class AngleName:
    """An angle at a point."""

    symbol: str
    at: str


@dataclass(frozen=True)
class RadiusName:
    """The radius of a circle about a point."""

    symbol: str
    centre: str


@dataclass(frozen=True)
class TurningName:
    """The rotation of a body."""

    symbol: str
    level: Level


@dataclass(frozen=True)
class MovingName:
    """The motion of a point."""

    symbol: str
    point: str
    level: Level


Subject = (
    PointName
    | BodyLabel
    | AxesNames
    | LengthName
    | AngleName
    | RadiusName
    | TurningName
    | MovingName
)


@dataclass(frozen=True)
class Named:
    """What labels name, and how it may be drawn."""

    subject: Subject
    piece: Piece
