"""A student's value, and how far a motion has to move until it is what is read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import copysign, isfinite

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector_equation import Level
from kinegrade.students.following.followed_terms import Place, Share

_SAME = 1e-9  # relative: how near a reading must come to the student's value
_NOTHING = 1e-9  # relative: what moves a reading by less does not move it
_ROUNDS = 8  # of the search for a value that is not linear in the rates, as a magnitude


@dataclass(frozen=True)
class OwnValue:
    """A student's value: `read` reads the quantity off a motion, `value` is the number that
    replaces it.

    `read` gives None where the motion does not determine the quantity. `place` is the body and
    point whose velocity or acceleration it is, `part` the share of a Coriolis or normal part; both
    None for angular and for relative motions.
    """

    read: Callable[[Motion], float | None]
    value: float
    level: Level
    place: Place | None = None
    part: Share | None = None

    def is_read(self, motion: Motion) -> bool:
        """Whether a motion has this value."""
        now = self.read(motion)
        return now is not None and abs(self.value - now) <= _SAME * abs(self.value)

    def is_kept(self, motion: Motion) -> bool:
        """Whether a motion that was moved to it still has it, be it as a magnitude that is
        reversed.
        """
        now = self.read(motion)
        return now is not None and self._misses(now) <= _SAME * abs(self.value)

    def _misses(self, now: float) -> float:
        """How far a reading is from the value; the magnitude of a reversed vector is never
        negative.
        """
        return abs(copysign(self.value, now) - now)

    def find_distance(
        self, now: float, move: Callable[[float], Motion], near: float
    ) -> float | None:
        """How far to move a motion, off which `now` is read, so that it has this value, None where
        that does not change it; `near` is a short way, by which the first step is found.
        """

        def read(distance: float) -> float:
            return self.read(move(distance)) or 0.0

        here, there = (0.0, now), (near, read(near))
        if abs(there[1] - here[1]) <= _NOTHING * max(abs(here[1]), abs(self.value)):
            return None
        target = self.value
        for _ in range(_ROUNDS):
            slope = (there[1] - here[1]) / (there[0] - here[0])
            if not slope:
                return None
            distance = there[0] + (target - there[1]) / slope
            here, there = there, (distance, read(distance))
            if not isfinite(there[1]):
                return None
            if self._misses(there[1]) <= _SAME * abs(self.value):
                return distance
            target = copysign(self.value, there[1])
        return None
