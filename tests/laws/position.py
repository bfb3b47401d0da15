"""An independent model of a mechanism: positions alone, at 64 digits, and motion by differences of
positions.

Each body has three coordinates: how far it has moved and how far it has turned since the instant.
Each joint and each driver is a condition on positions at the time t, written from what it says and
from nothing that the package derives: a pin's points coincide, a wheel's arc equals the track's
arc, a driven angle is v t + a t^2/2. The conditions are solved at t = +-h by Newton's method with
the derivatives at t = 0, and central differences give the motion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, assert_never

import numpy as np
from flint import arb
from mpmath import acos, atan2, cos, mp, mpf, sin

from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Belt,
    Circle,
    Contact,
    Joint,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.surd import Surd, enclose

DIGITS = 64
STEP = "1e-13"  # s: the fourth derivative leaves 1e-26 of itself, rounding leaves 1e-58/1e-26
SOLVED = "1e-58"
TINY = "1e-30"
Place = tuple[Any, Any]
Pose = tuple[Any, Any, Any]  # how far the body has moved along x and y, and turned


def precise(number: Any) -> Any:
    """An exact number, a ball or a double as an mpf."""
    if isinstance(number, (Surd, PiMultiple)):
        return precise(enclose(number, 320))
    if isinstance(number, arb):
        mantissa, exponent = number.mid().man_exp()
        return mpf(int(mantissa)) * mpf(2) ** int(exponent)
    if isinstance(number, (int, float)):
        return mpf(number)
    return mpf(int(number.p)) / int(number.q)


def place(vector: Any) -> Place:
    """A vector as a pair of mpf."""
    return precise(vector.x), precise(vector.y)


def minus(first: Place, second: Place) -> Place:
    return first[0] - second[0], first[1] - second[1]


def dot(first: Place, second: Place) -> Any:
    return first[0] * second[0] + first[1] * second[1]


def cross(first: Place, second: Place) -> Any:
    return first[0] * second[1] - first[1] * second[0]


def turned(vector: Place, angle: Any) -> Place:
    c, s = cos(angle), sin(angle)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


def unit(vector: Place) -> Place:
    length = (vector[0] ** 2 + vector[1] ** 2) ** mpf("0.5")
    return vector[0] / length, vector[1] / length


@dataclass(frozen=True)
class Motion:
    """Velocities and accelerations by differences: of points of bodies, and of bodies' angles."""

    velocity: dict[tuple[str, str], Place]
    acceleration: dict[tuple[str, str], Place]
    omega: dict[str, Any]
    alpha: dict[str, Any]


class PositionModel:
    """The conditions of one mechanism on the poses of its bodies; call inside
    `mp.workdps(DIGITS)`.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.start = {name: place(point) for name, point in mechanism.points.items()}
        self.pivot = {body.name: self.start[body.points[0]] for body in mechanism.bodies}

    def poses(self, unknowns: list[Any]) -> dict[str, Pose]:
        """The pose of every body from the list of unknowns; a particle does not turn."""
        poses: dict[str, Pose] = {GROUND: (mpf(0), mpf(0), mpf(0))}
        rest = iter(unknowns)
        for body in self.mechanism.bodies:
            poses[body.name] = next(rest), next(rest), mpf(0) if body.particle else next(rest)
        return poses

    @property
    def count(self) -> int:
        return sum(2 if body.particle else 3 for body in self.mechanism.bodies)

    def moved(self, poses: dict[str, Pose], body: str, start: Place) -> Place:
        """Where a point of a body is now that was at `start`."""
        if body == GROUND:
            return start
        x, y, angle = poses[body]
        pivot = self.pivot[body]
        arm = turned(minus(start, pivot), angle)
        return pivot[0] + arm[0] + x, pivot[1] + arm[1] + y

    def seen(self, poses: dict[str, Pose], frame: str, now: Place) -> Place:
        """Where a point that is at `now` stands on the body `frame`, in coordinates of its first
        position.
        """
        if frame == GROUND:
            return now
        x, y, angle = poses[frame]
        pivot = self.pivot[frame]
        arm = turned((now[0] - pivot[0] - x, now[1] - pivot[1] - y), -angle)
        return pivot[0] + arm[0], pivot[1] + arm[1]

    def path(self, poses: dict[str, Pose], point: str, body: str, frame: str) -> Place:
        """Where a body's point is, seen from a frame."""
        return self.seen(poses, frame, self.moved(poses, body, self.start[point]))

    def conditions(self, unknowns: list[Any], time: Any) -> list[Any]:
        """What must be zero at the time."""
        poses = self.poses(unknowns)
        joints = [value for joint in self.mechanism.joints for value in self.joint(poses, joint)]
        return joints + [self.driver(poses, driver, time) for driver in self.mechanism.drivers]

    def joint(self, poses: dict[str, Pose], joint: Joint) -> Iterator[Any]:
        """A joint's conditions."""
        turn = {name: pose[2] for name, pose in poses.items()}
        match joint:
            case Pin(point, bodies):
                first = self.moved(poses, bodies[0], self.start[point])
                for body in bodies[1:]:
                    yield from minus(self.moved(poses, body, self.start[point]), first)
            case Slide(point, body, line, of):
                yield self.offset(line, self.path(poses, point, body, of))
            case Sleeve(body, line, of):
                origin = self.pivot.get(body, self.pivot.get(of))
                assert origin is not None
                now = self.seen(poses, of, self.moved(poses, body, origin))
                yield cross(unit(place(line.direction)), minus(now, origin))
                yield turn[body] - turn[of]
            case Arc(point, body, circle, of):
                yield self.distance(circle, self.path(poses, point, body, of)) - precise(
                    circle.radius
                )
            case Contact(body, circle, of, on, inside):
                yield self.touching(self.path(poses, circle.centre, body, of), circle, on, inside)
            case Roll(body, circle, of, on, inside):
                yield self.touching(self.path(poses, circle.centre, body, of), circle, on, inside)
                yield self.slip(
                    self.path(poses, circle.centre, body, of),
                    turn[body] - turn[of],
                    circle,
                    on,
                    inside,
                )
            case Mesh(body, circle, of, on, carrier, inside):
                own, other = turn[body] - turn[carrier], turn[of] - turn[carrier]
                sense = -1 if inside else 1
                yield precise(circle.radius) * own + sense * precise(on.radius) * other
            case Belt():
                yield self.run(poses, joint)
            case Parallel(body, of):
                yield turn[body] - turn[of]
            case _:
                assert_never(joint)

    def run(self, poses: dict[str, Pose], belt: Belt) -> Any:
        """How much longer the belt has become between a mark on one rim and a mark on the other:
        along the first rim to where the strand leaves it, along the strand, along the second rim.
        """
        first, second = belt.circle.centre, belt.on.centre
        start, now = [
            minus(
                self.moved(at, belt.of, self.start[second]),
                self.moved(at, belt.body, self.start[first]),
            )
            for at in (self.poses([mpf(0)] * self.count), poses)
        ]
        own, other = precise(belt.circle.radius), precise(belt.on.radius)
        opposite = own + other if belt.crossed else own - other
        strand = [(dot(arm, arm) - opposite**2) ** mpf("0.5") for arm in (start, now)]
        # the strand leaves at the right of the arm, where a belt that runs on turns the rim forwards
        leans = [acos(opposite / dot(arm, arm) ** mpf("0.5")) for arm in (start, now)]
        swept = atan2(cross(start, now), dot(start, now)) - (leans[1] - leans[0])
        left = own * (swept - poses[belt.body][2])
        right = other * (swept - poses[belt.of][2])
        return left + strand[1] - strand[0] + (right if belt.crossed else -right)

    def offset(self, line: Line, now: Place) -> Any:
        """The distance to the left of a directed line."""
        return cross(unit(place(line.direction)), minus(now, place(line.point)))

    def distance(self, circle: Circle, now: Place) -> Any:
        """The distance from a circle's centre."""
        arm = minus(now, self.start[circle.centre])
        return (arm[0] ** 2 + arm[1] ** 2) ** mpf("0.5")

    def touching(self, now: Place, circle: Circle, on: Line | Circle, inside: bool) -> Any:
        """Two profiles touch: the centre's distance from the line or from the other centre."""
        own = precise(circle.radius)
        if isinstance(on, Line):
            return abs(self.offset(on, now)) - own
        return self.distance(on, now) - abs(precise(on.radius) + (-own if inside else own))

    def slip(self, now: Place, turn: Any, circle: Circle, on: Line | Circle, inside: bool) -> Any:
        """Arc rolled off the wheel minus arc run along the track, seen from the track."""
        start, own = self.start[circle.centre], precise(circle.radius)
        if isinstance(on, Line):
            return dot(unit(place(on.direction)), minus(now, start)) + self.offset(on, start) * turn
        swept = self.swept(on.centre, start, now)
        return own * (swept - turn if inside else turn - swept) - precise(on.radius) * swept

    def swept(self, centre: str, start: Place, now: Place) -> Any:
        """The angle that the arm from a centre has swept."""
        first, second = minus(start, self.start[centre]), minus(now, self.start[centre])
        return atan2(cross(first, second), dot(first, second))

    def driver(self, poses: dict[str, Pose], driver: Driver, time: Any) -> Any:
        """A driver's condition: its coordinate is v t + a t^2/2."""
        imposed = precise(driver.velocity) * time + precise(driver.acceleration) * time**2 / 2
        match driver:
            case Rotation(body, _, _, of):
                return poses[body][2] - poses[of][2] - imposed
            case Component(point, body, direction, _, _, of):
                now = self.path(poses, point, body, of)
                return dot(place(direction), minus(now, self.start[point])) - imposed
            case Circulation(point, body, centre):
                start = self.start[point]
                arm = minus(start, self.start[centre])
                now = self.path(poses, point, body, GROUND)
                return dot(arm, arm) ** mpf("0.5") * self.swept(centre, start, now) - imposed

    @cached_property
    def derivatives(self) -> np.ndarray[Any, Any]:
        """The derivatives of the conditions at t = 0, as doubles."""
        zero = [mpf(0)] * self.count
        at_rest = self.conditions(zero, mpf(0))
        columns = []
        for index in range(self.count):
            moved = list(zero)
            moved[index] = mpf(TINY)
            columns.append(
                [
                    float((value - rest) / mpf(TINY))
                    for value, rest in zip(self.conditions(moved, mpf(0)), at_rest, strict=True)
                ]
            )
        return np.array(columns).T

    @cached_property
    def regularity(self) -> float:
        """The least over the greatest singular value: zero where the conditions leave a motion
        free.
        """
        if not self.count:
            return 1.0
        if not self.derivatives.size or self.derivatives.shape[0] < self.count:
            return 0.0
        sizes = np.linalg.svd(self.derivatives, compute_uv=False)
        return float(sizes[-1] / sizes[0])

    def solved(self, time: Any) -> dict[str, Pose]:
        """The poses at a small time. Raises ArithmeticError when the conditions cannot be met."""
        back = [[mpf(float(entry)) for entry in row] for row in np.linalg.pinv(self.derivatives)]
        unknowns = [mpf(0)] * self.count
        for _ in range(40):
            values = self.conditions(unknowns, time)
            if max(map(abs, values)) < mpf(SOLVED):
                return self.poses(unknowns)
            unknowns = [
                unknown - sum(entry * value for entry, value in zip(row, values, strict=True))
                for unknown, row in zip(unknowns, back, strict=True)
            ]
        raise ArithmeticError(f"the conditions on positions are not met: {max(map(abs, values))}")


def moving(mechanism: Mechanism) -> Motion:
    """The motion of every point and body by central differences of positions."""
    with mp.workdps(DIGITS):
        model, step = PositionModel(mechanism), mpf(STEP)
        before, after = model.solved(-step), model.solved(step)

        def rates(at: Callable[[dict[str, Pose]], Any], now: Any) -> tuple[Any, Any]:
            return (at(after) - at(before)) / (2 * step), (
                at(after) + at(before) - 2 * now
            ) / step**2

        motion = Motion({}, {}, {}, {})
        for body in mechanism.bodies:
            motion.omega[body.name], motion.alpha[body.name] = rates(
                lambda poses, b=body.name: poses[b][2], mpf(0)
            )
            for point in body.points:
                key, start = (point, body.name), model.start[point]
                parts = [
                    rates(
                        lambda poses, b=body.name, s=start, i=i: model.moved(poses, b, s)[i],
                        start[i],
                    )
                    for i in (0, 1)
                ]
                motion.velocity[key] = parts[0][0], parts[1][0]
                motion.acceleration[key] = parts[0][1], parts[1][1]
        return motion


def regularity(mechanism: Mechanism) -> float:
    """How far a mechanism is from a dead point or a loose body: 0 there, of the order of 0.01 to 1
    elsewhere.
    """
    with mp.workdps(DIGITS):
        return PositionModel(mechanism).regularity
