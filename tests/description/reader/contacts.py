"""Contacts of a circle with a line or with another circle: slipping and rolling."""

from __future__ import annotations

import math
from dataclasses import dataclass

from tests.description.reader.deferred import Deferred, Points
from tests.description.reader.geometry import Circle, Curve, Line, offset
from tests.description.reader.joints import Joint, distance_to_contact
from tests.description.reader.motion import Motion
from tests.description.reader.series import Series, turn_of


@dataclass(frozen=True)
class Contact(Joint):
    """A circle of a body that touches a curve of another one, and perhaps rolls on it."""

    circle: Deferred[Circle]
    body: str
    curve: Deferred[Curve]
    guide: str
    inside: bool
    rolls: bool

    @property
    def needs(self) -> frozenset[str]:
        return self.circle.needs | self.curve.needs

    def gaps(self, points: Points) -> list[float]:
        circle, curve = self.circle.at(points), self.curve.at(points)
        if isinstance(curve, Line):
            return [abs(offset(circle.centre, curve)) - circle.radius]
        return [distance_to_contact(circle, curve, self.inside)]

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        circle, curve = self.circle.at(points), self.curve.at(points)
        if isinstance(curve, Line):
            found = self.on_line(circle, curve, motion)
        else:
            found = self.on_circle(circle, curve, motion)
        return found if self.rolls else found[:1]

    def on_line(self, circle: Circle, line: Line, motion: Motion) -> list[Series]:
        """The distance from the line, and the way along it less what is rolled off."""
        wheel, track = motion.of(self.body), motion.of(self.guide)
        centre = wheel.carry(circle.centre)
        radius = math.copysign(circle.radius, offset(circle.centre, line))
        rolled = (wheel.angle - track.angle) * radius
        return [track.offset(centre, line), track.progress(centre, line) + rolled]

    def on_circle(self, circle: Circle, other: Circle, motion: Motion) -> list[Series]:
        """The distance of the centres, and the arcs rolled off on both circles."""
        wheel, track = motion.of(self.body), motion.of(self.guide)
        between = wheel.carry(circle.centre) - track.carry(other.centre)
        turn = turn_of(between, circle.centre - other.centre)
        sign = -1.0 if self.inside else 1.0
        arcs = (wheel.angle - turn) * circle.radius + (track.angle - turn) * (sign * other.radius)
        return [between.length(), arcs]
