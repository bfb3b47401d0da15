"""Joints: what they ask of the positions, and what of the motion."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from tests.description.reader.deferred import Deferred, Points
from tests.description.reader.geometry import Circle, Line, offset
from tests.description.reader.motion import Motion
from tests.description.reader.series import Series


class Joint(ABC):
    """A joint of two bodies."""

    @property
    @abstractmethod
    def needs(self) -> frozenset[str]:
        """The points that must be known."""

    def gaps(self, points: Points) -> list[float]:
        """Lengths that vanish where the joint fits together."""
        return []

    @abstractmethod
    def equations(self, points: Points, motion: Motion) -> list[Series]:
        """Functions of time that must not change."""


@dataclass(frozen=True)
class Pin(Joint):
    """A point that belongs to two bodies."""

    point: Deferred[complex]
    first: str
    second: str

    @property
    def needs(self) -> frozenset[str]:
        return self.point.needs

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        place = self.point.at(points)
        apart = motion.of(self.first).carry(place) - motion.of(self.second).carry(place)
        return [apart.x, apart.y]


@dataclass(frozen=True)
class OnLine(Joint):
    """A point of a body that stays on a line of another one."""

    point: Deferred[complex]
    body: str
    line: Deferred[Line]
    guide: str

    @property
    def needs(self) -> frozenset[str]:
        return self.point.needs | self.line.needs

    def gaps(self, points: Points) -> list[float]:
        return [offset(self.point.at(points), self.line.at(points))]

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        point = motion.of(self.body).carry(self.point.at(points))
        return [motion.of(self.guide).offset(point, self.line.at(points))]


@dataclass(frozen=True)
class OnCircle(Joint):
    """A point of a body that stays on a circle of another one."""

    point: Deferred[complex]
    body: str
    circle: Deferred[Circle]
    guide: str

    @property
    def needs(self) -> frozenset[str]:
        return self.point.needs | self.circle.needs

    def gaps(self, points: Points) -> list[float]:
        circle = self.circle.at(points)
        return [abs(self.point.at(points) - circle.centre) - circle.radius]

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        point = motion.of(self.body).carry(self.point.at(points))
        centre = motion.of(self.guide).carry(self.circle.at(points).centre)
        return [(point - centre).length()]


@dataclass(frozen=True)
class SameTurn(Joint):
    """Two bodies that turn together."""

    first: str
    second: str

    @property
    def needs(self) -> frozenset[str]:
        return frozenset()

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        return [motion.of(self.first).angle - motion.of(self.second).angle]


@dataclass(frozen=True)
class Sleeve(Joint):
    """A body that slides through another one along a line and turns together with it."""

    rod: str
    sleeve: str
    line: Deferred[Line]

    @property
    def needs(self) -> frozenset[str]:
        return self.line.needs

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        line = self.line.at(points)
        point = motion.of(self.rod).carry(line.point)
        together = motion.of(self.rod).angle - motion.of(self.sleeve).angle
        return [motion.of(self.sleeve).offset(point, line), together]


@dataclass(frozen=True)
class Train(Joint):
    """Gears in mesh or pulleys with a belt, as seen from the body with both centres."""

    first: Deferred[Circle]
    driver: str
    second: Deferred[Circle]
    driven: str
    carrier: str
    same_sense: bool
    belt: bool

    @property
    def needs(self) -> frozenset[str]:
        return self.first.needs | self.second.needs

    def gaps(self, points: Points) -> list[float]:
        if self.belt:
            return []
        first, second = self.first.at(points), self.second.at(points)
        return [distance_to_contact(first, second, self.same_sense)]

    def equations(self, points: Points, motion: Motion) -> list[Series]:
        carrier = motion.of(self.carrier).angle
        first = (motion.of(self.driver).angle - carrier) * self.first.at(points).radius
        second = (motion.of(self.driven).angle - carrier) * self.second.at(points).radius
        return [first - second if self.same_sense else first + second]


def distance_to_contact(first: Circle, second: Circle, inside: bool) -> float:
    """How far the centres are from the distance at which the circles touch."""
    reach = first.radius - second.radius if inside else first.radius + second.radius
    return abs(first.centre - second.centre) - abs(reach)
