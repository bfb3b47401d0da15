"""Velocities and accelerations from the joints and the drives."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy

from tests.description.reader.deferred import Points
from tests.description.reader.description import Description
from tests.description.reader.motion import Motion, Pose
from tests.description.reader.series import Series
from tests.description.reader.vocabulary import GROUND

TOLERANCE = 1e-7


class NotMovable(ValueError):
    """Rates that contradict the joints, or do not determine what is asked."""


@dataclass(frozen=True)
class State:
    """Velocities and accelerations of the bodies, by their points at the origin."""

    velocities: dict[str, complex]
    turns: dict[str, float]
    accelerations: dict[str, complex]
    turn_changes: dict[str, float]

    def velocity(self, body: str, place: complex) -> complex:
        """The velocity of the point of the body that is at the place."""
        return self.velocities[body] + 1j * self.turns[body] * place

    def acceleration(self, body: str, place: complex) -> complex:
        """The acceleration of the point of the body that is at the place."""
        turning = 1j * self.turn_changes[body] - self.turns[body] ** 2
        return self.accelerations[body] + turning * place


@dataclass
class Mechanism:
    """The bodies at their places, ready to move."""

    description: Description
    points: Points
    scale: float = field(init=False)

    def __post_init__(self) -> None:
        sizes = [abs(place) for place in self.points.values() if abs(place) > 0]
        self.scale = max(sizes, default=1.0)
        self.bodies = list(self.description.words.bodies)
        self.bare = self.description.bare_points()

    def motion(
        self, first: numpy.ndarray, second: numpy.ndarray, value: numpy.ndarray | None = None
    ) -> Motion:
        """Bodies that move with these coefficients, three rows for each body."""
        value = numpy.zeros(3 * len(self.bodies)) if value is None else value
        poses = {}
        for place, body in enumerate(self.bodies):
            x, y, angle = (
                Series(value[line], first[line], second[line])
                for line in range(3 * place, 3 * place + 3)
            )
            poses[body] = Pose(x * self.scale, y * self.scale, angle)
        return Motion(poses)

    def equations(self, motion: Motion) -> list[Series]:
        """What must not change: by the joints, and as points have no direction."""
        found = [motion.of(body).angle for body in sorted(self.bare)]
        for joint in self.description.joints:
            found += joint.equations(self.points, motion)
        return found

    def driven(self, motion: Motion) -> list[Series]:
        """What changes at given rates."""
        return [drive.driven(self.points, motion) for drive in self.description.drives]

    def states(self) -> list[State]:
        """Motions that agree with all rates; more than one where some are left open."""
        system = self.system()
        random = numpy.random.default_rng(2)
        return [self.state(system, random) for _ in range(2 if system.open.size else 1)]

    def system(self) -> System:
        """The equations for the rates of the bodies."""
        return System(self.slopes(driven=True))

    def slopes(self, value: numpy.ndarray | None = None, driven: bool = False) -> numpy.ndarray:
        """How the equations depend on the rates, where the bodies are displaced by the values."""
        size = 3 * len(self.bodies)
        unit = self.motion(numpy.eye(size), numpy.zeros((size, size)), value)
        equations = [*self.equations(unit), *(self.driven(unit) if driven else [])]
        return numpy.array([row(one, size) for one in equations]).reshape(-1, size)

    def state(self, system: System, random: numpy.random.Generator) -> State:
        """One of the motions that agree with all rates."""
        drives = self.description.drives
        still = [0.0] * (system.rows - len(drives))
        first = system.solved([*still, *(drive.rate for drive in drives)], random)
        bent = self.motion(first, numpy.zeros(len(first)))
        bends = [2 * float(one.second) for one in [*self.equations(bent), *self.driven(bent)]]
        changes = numpy.array([*still, *(drive.change for drive in drives)])
        second = system.solved(list(changes - numpy.array(bends)), random)
        return self.named(first, second)

    def named(self, first: numpy.ndarray, second: numpy.ndarray) -> State:
        """The rates and their changes, by the bodies."""
        state = State({GROUND: 0j}, {GROUND: 0.0}, {GROUND: 0j}, {GROUND: 0.0})
        for place, body in enumerate(self.bodies):
            x, y, angle = (float(value) for value in first[3 * place : 3 * place + 3])
            state.velocities[body] = complex(x, y) * self.scale
            state.turns[body] = angle
            x, y, angle = (float(value) for value in second[3 * place : 3 * place + 3])
            state.accelerations[body] = complex(x, y) * self.scale
            state.turn_changes[body] = angle
        return state


def row(one: Series, size: int) -> numpy.ndarray:
    """The slopes of one equation."""
    return numpy.zeros(size) + one.first


class System:
    """Linear equations, whose rows are given the length one."""

    def __init__(self, slopes: numpy.ndarray) -> None:
        self.rows = len(slopes)
        self.lengths = numpy.maximum(numpy.linalg.norm(slopes, axis=1), 1e-300)
        self.slopes = slopes / self.lengths[:, None]
        _, sizes, directions = numpy.linalg.svd(self.slopes)
        rank = int(numpy.sum(sizes > TOLERANCE))
        self.open = directions[rank:]

    def solved(self, values: list[float], random: numpy.random.Generator) -> numpy.ndarray:
        """A solution, with arbitrary shares of what the equations leave open."""
        wanted = numpy.array(values) / self.lengths
        found = numpy.linalg.lstsq(self.slopes, wanted, rcond=TOLERANCE)[0]
        misfit = numpy.max(numpy.abs(self.slopes @ found - wanted), initial=0.0)
        if misfit > TOLERANCE * max(1.0, float(numpy.max(numpy.abs(wanted), initial=0.0))):
            raise NotMovable(f"the rates contradict the joints by {misfit:.3g}")
        if self.open.size:
            found = found + random.normal(size=len(self.open)) @ self.open
        return numpy.asarray(found)
