"""Radii of circles: an arrow from the centre to the rim, or from outside for a small circle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

from kinegrade.errors import TemplateError, suggest
from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_around, list_spots_beside
from kinegrade.figure.plane import NEAR, angle_of, length, polar
from kinegrade.figure.scene import THIN, Primitive, Strokes
from kinegrade.figure.symbols import HEAD_LENGTH, draw_arrowhead
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Radius

_SMALL_RADIUS = 8.0  # millimetres: a smaller circle has its radius marked from outside
_PREFERRED = tuple(turn * pi for turn in (0.75, 0.25, -0.75, -0.25, 0.5, 1.0, 0.0, -0.5))
_ALONG_ARC = (0.12, 0.88, 0.2, 0.8, 0.28, 0.72, 0.36, 0.64)  # parts of an arc from its start
_SHIFTS = tuple(shift * pi / 24 for shift in (0, 2, -2))


def mark_radii(at: Mapping[str, Vector], found: tuple[Rim, ...], hint: Radius) -> list[Mark]:
    """The radius of a circle: for a cam to the contact, for other circles wherever there is room.

    Raises TemplateError when no circle of the mechanism has that centre.
    """
    rim = _find_rim(found, hint, at[hint.through] if hint.through else None)
    arc = rim.find_arc()
    angles = [turn + shift for shift in _SHIFTS for turn in _PREFERRED]
    if arc:
        angles = [arc[0] + share * arc[1] for share in _ALONG_ARC]
    if rim.kind == "cam":
        angles = [angle_of(rim.touch - rim.at)]
    way = _FromOutside if rim.radius < _SMALL_RADIUS else _FromCentre
    return [way(rim.at, rim.radius, polar(angle), hint.symbol) for angle in angles]


def _find_rim(found: tuple[Rim, ...], hint: Radius, through: Vector | None) -> Rim:
    """The circle that a hint means; circles that joints have come first."""
    for rim in sorted(found, key=lambda rim: rim.kind == "edge"):
        on_it = through is None or abs(length(through - rim.at) - rim.radius) < NEAR * (
            1 + rim.radius
        )
        if rim.centre == hint.centre and hint.of in (None, rim.body) and on_it:
            return rim
    near = suggest(hint.centre, {rim.centre for rim in found})
    what = Message("figure.no-such-circle", circle=_describe_circle(hint), hint=near)
    raise TemplateError(Fault("figure.radii", what))


def _describe_circle(hint: Radius) -> Message:
    centre = Quoted(hint.centre)
    match hint:
        case Radius(of=str() as body, through=str() as point):
            return Message(
                "figure.circle-of-through", body=Quoted(body), point=Quoted(point), centre=centre
            )
        case Radius(of=str() as body):
            return Message("figure.circle-of", body=Quoted(body), centre=centre)
        case Radius(through=str() as point):
            return Message("figure.circle-through", point=Quoted(point), centre=centre)
        case _:
            return Message("figure.circle-about", centre=centre)


@dataclass(frozen=True)
class _FromCentre:
    """An arrow from the centre to the rim."""

    centre: Vector
    radius: float
    toward: Vector
    symbol: str
    demerit: float = 0.0
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The middle of the arrow, which touches centre and rim in any case."""
        clear = min(3.0, self.radius / 2)
        return (
            (self.centre + self.toward * 2.0, self.centre + self.toward * (self.radius - clear)),
        )

    def wish(self) -> Wish:
        """Beside the arrow."""
        return Wish(self.symbol, list_spots_beside(self.symbol, self.centre, self._end()))

    def primitives(self) -> tuple[Primitive, ...]:
        """A thin line and its arrowhead."""
        shaft = (self.centre + self.toward * 1.3, self._end() - self.toward * HEAD_LENGTH * 0.8)
        return (Strokes((shaft,), THIN), draw_arrowhead(self._end(), self.toward))

    def _end(self) -> Vector:
        return self.centre + self.toward * self.radius


@dataclass(frozen=True)
class _FromOutside:
    """An arrow that points at the rim from outside, where there is no room inside."""

    centre: Vector
    radius: float
    toward: Vector
    symbol: str
    demerit: float = 0.0
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its tip."""
        return ((self._out(1.2), self._out(7.0)),)

    def wish(self) -> Wish:
        """Around the tail."""
        return Wish(self.symbol, list_spots_around(self.symbol, self._out(7.0), away=self.toward))

    def primitives(self) -> tuple[Primitive, ...]:
        """A thin line and its arrowhead."""
        shaft = (self._out(HEAD_LENGTH * 0.8), self._out(7.0))
        return (Strokes((shaft,), THIN), draw_arrowhead(self._out(0.0), -self.toward))

    def _out(self, gap: float) -> Vector:
        return self.centre + self.toward * (self.radius + gap)
