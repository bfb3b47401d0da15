"""What is asked, computed from positions and motion."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tests.description.reader.centrode import circle_through, pole
from tests.description.reader.deferred import Points
from tests.description.reader.geometry import (
    Circle,
    Curve,
    Line,
    beside,
    common_points,
    cross,
    dot,
    extreme,
    foot,
    line_between,
    line_towards,
    polar,
    toward,
    unit,
)
from tests.description.reader.kinematics import State
from tests.description.reader.names import plain
from tests.description.reader.quantity_words import Beside, Call, Constant, Name, Operation, Word
from tests.description.reader.vocabulary import GROUND, Vocabulary

Poles = Callable[[str], list[complex]]


def angle_from(first: complex, second: complex) -> float:
    """The angle from the first vector to the second, counter-clockwise."""
    return math.atan2(cross(first, second), dot(first, second))


def distance(point: complex, other: complex | Line) -> float:
    """The distance of a point from another point or from a line."""
    if isinstance(other, Line):
        return abs(point - foot(point, other))
    return abs(point - other)


def line(point: complex, goal: complex) -> Line:
    """The line through a point and another one, or in the direction of an angle."""
    if isinstance(goal, complex):
        return line_between(point, goal)
    return line_towards(point, goal)


def sided(first: Curve, second: Curve, side: str) -> complex:
    """The common point on the named side."""
    points = common_points(first, second)
    if side not in ("counterclockwise", "clockwise"):
        return extreme(points, side)
    looking = "left" if side == "counterclockwise" else "right"
    curves = sorted((first, second), key=lambda curve: not isinstance(curve, Line))
    if isinstance(curves[0], Line):
        start = second.centre if isinstance(second, Circle) else 0j
        start = first.centre if isinstance(first, Circle) else start
        return beside(points, start, start + curves[0].direction, looking)
    assert isinstance(first, Circle)
    assert isinstance(second, Circle)
    return beside(points, first.centre, second.centre, looking)


PLAIN: dict[str, Callable[..., Any]] = {
    "": complex,
    "polar": polar,
    "line": line,
    "circle": Circle,
    "foot": foot,
    "midpoint": lambda a, b: (a + b) / 2,
    "distance": distance,
    "toward": toward,
    "x": lambda vector: vector.real,
    "y": lambda vector: vector.imag,
    "turned": lambda vector: 1j * vector,
    "direction": lambda a, b: cmath.phase(b - a),
    "sqrt": math.sqrt,
    "abs": abs,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "magnitude": abs,
    "along": lambda vector, way: dot(unit(way), vector),
    "angle": angle_from,
    "between": lambda a, b: abs(angle_from(a, b)),
    "radius": lambda circle: circle.radius,
    "centre": lambda circle: circle.centre,
}


@dataclass(frozen=True)
class Answers:
    """Evaluates quantities at one state of motion."""

    words: Vocabulary
    points: Points
    state: Callable[[], State]
    poles: Poles

    def value(self, word: Word) -> Any:
        """The value of a quantity: a number, a vector, a line or a circle."""
        match word:
            case Constant():
                return word.value
            case Name():
                return self.named(word.text)
            case Operation():
                return self.operation(word)
            case Call():
                return self.call(word)
            case Beside():
                raise ValueError("a side stands where a quantity should")

    def named(self, text: str) -> complex | float:
        """A point or a number by its name."""
        name = plain(text)
        if name in self.points:
            return self.points[name]
        if name in self.words.numbers:
            return self.words.numbers[name]
        if name == "pi":
            return math.pi
        raise ValueError(f"name not known: {text}")

    def operation(self, word: Operation) -> Any:
        """A sum, a product or a power."""
        first, second = self.value(word.first), self.value(word.second)
        operations: dict[str, Callable[[Any, Any], Any]] = {
            "+": lambda a, b: a + b,
            "-": lambda a, b: a - b,
            "*": lambda a, b: a * b,
            "/": lambda a, b: a / b,
            "**": lambda a, b: a**b,
        }
        return operations[word.sign](first, second)

    def call(self, word: Call) -> Any:
        """A function, of the plane or of the motion."""
        if word.function == "meet":
            return self.meeting(word)
        if word.function in PLAIN:
            return PLAIN[word.function](*(self.value(part) for part in word.arguments))
        motion: dict[str, Callable[..., Any]] = {
            "velocity": self.velocity,
            "acceleration": self.acceleration,
            "omega": self.omega,
            "alpha": self.alpha,
            "relative_velocity": self.relative_velocity,
            "relative_acceleration": self.relative_acceleration,
            "coriolis": self.coriolis,
            "normal_acceleration": self.normal_acceleration,
            "tangential_acceleration": self.tangential_acceleration,
            "pole": self.pole,
            "circle_of_poles": self.circle_of_poles,
        }
        if word.function not in motion:
            raise ValueError(f"function not known: {word.function}")
        return motion[word.function](*word.arguments)

    def meeting(self, word: Call) -> complex:
        """The common point of two curves."""
        first, second = (self.value(part) for part in word.arguments[:2])
        match word.arguments[2:]:
            case ():
                return common_points(first, second)[0]
            case (Beside(side, start, end),):
                places = self.points[plain(start)], self.points[plain(end)]
                return beside(common_points(first, second), *places, side)
            case (Name(side),):
                return sided(first, second, side)
        raise ValueError("side not understood")

    def bodies(self, point: Word, body: Word | None) -> list[str]:
        """The body named, or those to which the point belongs."""
        if body is not None:
            return [self.body(body)]
        if not isinstance(point, Name):
            raise TypeError("the body of a constructed point is not told")
        found = self.words.bodies_with(plain(point.text))
        if not found:
            raise ValueError(f"the point {point.text} belongs to no body")
        return found

    def body(self, word: Word) -> str:
        """A body by its name."""
        if not isinstance(word, Name):
            raise TypeError(f"not a body: {word}")
        return self.words.body_called(word.text)

    def common(self, found: list[complex], point: Word) -> complex:
        """The one vector, the same for all the bodies of a point."""
        for other in found:
            if abs(other - found[0]) > 1e-6 * max(1e-6, abs(found[0]), abs(other)):
                raise ValueError(f"of which body {point} is taken is not told")
        return found[0]

    def velocity(self, point: Word, body: Word | None = None) -> complex:
        """The velocity of a point."""
        place, state = self.value(point), self.state()
        bodies = self.bodies(point, body)
        return self.common([state.velocity(one, place) for one in bodies], point)

    def acceleration(self, point: Word, body: Word | None = None) -> complex:
        """The acceleration of a point."""
        place, state = self.value(point), self.state()
        bodies = self.bodies(point, body)
        return self.common([state.acceleration(one, place) for one in bodies], point)

    def omega(self, body: Word, frame: Word | None = None) -> float:
        """The angular velocity of a body, or relative to another one."""
        turns = self.state().turns
        return turns[self.body(body)] - turns[self.body(frame) if frame else GROUND]

    def alpha(self, body: Word, frame: Word | None = None) -> float:
        """The angular acceleration of a body, or relative to another one."""
        changes = self.state().turn_changes
        return changes[self.body(body)] - changes[self.body(frame) if frame else GROUND]

    def relative_velocity(self, point: Word, body: Word, frame: Word) -> complex:
        """The velocity of a point of a body as seen from another one."""
        place, state = self.value(point), self.state()
        seen = state.velocity(self.body(frame), place)
        return state.velocity(self.body(body), place) - seen

    def relative_acceleration(self, point: Word, body: Word, frame: Word) -> complex:
        """The acceleration of a point of a body as seen from another one."""
        place, state = self.value(point), self.state()
        seen = state.acceleration(self.body(frame), place) + self.coriolis(point, body, frame)
        return state.acceleration(self.body(body), place) - seen

    def coriolis(self, point: Word, body: Word, frame: Word) -> complex:
        """The Coriolis acceleration of a point of a body in the frame of another one."""
        turning = self.state().turns[self.body(frame)]
        return 2j * turning * self.relative_velocity(point, body, frame)

    def normal_acceleration(self, point: Word, centre: Word, body: Word) -> complex:
        """The part towards the second point of the acceleration relative to it."""
        radius: complex = self.value(point) - self.value(centre)
        return -(self.omega(body) ** 2) * radius

    def tangential_acceleration(self, point: Word, centre: Word, body: Word) -> complex:
        """The part across the radius of the acceleration relative to the second point."""
        radius: complex = self.value(point) - self.value(centre)
        return 1j * self.alpha(body) * radius

    def pole(self, body: Word) -> complex:
        """The velocity pole of a body."""
        state, identifier = self.state(), self.body(body)
        reach = max((abs(place) for place in self.points.values()), default=1.0) or 1.0
        return pole(state.velocities[identifier], state.turns[identifier], reach)

    def circle_of_poles(self, body: Word, parameter: Word) -> Circle:
        """The circle on which the poles lie while the mechanism moves."""
        return circle_through(self.poles(self.body(body)))
