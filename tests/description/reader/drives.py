"""Drives: what moves at a given rate."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from tests.description.reader.deferred import Deferred, Points
from tests.description.reader.motion import Motion
from tests.description.reader.series import Series, turn_of


@dataclass(frozen=True)
class Drive(ABC):
    """A quantity that changes at a given rate, which itself changes at a given rate."""

    rate: float
    change: float

    @abstractmethod
    def driven(self, points: Points, motion: Motion) -> Series:
        """The quantity, as a function of time."""


@dataclass(frozen=True)
class Turning(Drive):
    """A body that turns, perhaps relative to another one."""

    body: str
    frame: str

    def driven(self, points: Points, motion: Motion) -> Series:
        return motion.of(self.body).angle - motion.of(self.frame).angle


@dataclass(frozen=True)
class Moving(Drive):
    """A point of a body that moves in a direction, perhaps relative to another body."""

    point: str
    body: str
    frame: str
    heading: Deferred[complex]

    def driven(self, points: Points, motion: Motion) -> Series:
        place, frame = points[self.point], motion.of(self.frame)
        way = motion.of(self.body).carry(place) - frame.carry(place)
        return frame.turn(self.heading.at(points)).dot(way)


@dataclass(frozen=True)
class Circling(Drive):
    """A point of a body that moves on a circle about a fixed point; the arc is driven."""

    point: str
    body: str
    centre: Deferred[complex]

    def driven(self, points: Points, motion: Motion) -> Series:
        place, centre = points[self.point], self.centre.at(points)
        way = motion.of(self.body).carry(place) - motion.of("ground").carry(centre)
        return turn_of(way, place - centre) * abs(place - centre)
