"""Where the things of a mechanism are in an instance, and how they go."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal, assert_never

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import length
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.nouns import Nouns, Thing

STILL = 1e-9  # m/s or rad/s: less is what doubles leave
Kind = Literal["wheel", "slider", "guide", "load", "crank"]


@dataclass(frozen=True)
class Part:
    """What words may stand for: points, the bodies that turn, or the fixed lines of guides; a wheel
    goes where its centre goes.
    """

    points: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()
    is_guide: bool = False
    centres: tuple[str, ...] = ()

    def list_places(self, each: Solution) -> list[Vector]:
        """Where its points are."""
        return [each.doubles.points[name] for name in self.points]

    def list_rates(self, each: Solution) -> list[float]:
        """How fast its bodies turn, rad/s counter-clockwise."""
        if not each.template.scheme.drivers:
            return []  # a pose
        return [float(each.doubles.omega(name)) for name in self.bodies]

    def list_velocities(self, each: Solution) -> list[Vector]:
        """How its points move, as points of each body that has them."""
        scheme = each.template.scheme
        bodies = scheme.bodies if scheme.drivers else ()
        return [
            each.doubles.velocity(point, body.name)
            for point in self.centres or self.points
            for body in bodies
            if point in body.points and (body.name in self.bodies or not self.bodies)
        ]


@dataclass(frozen=True)
class Parts:
    """The parts of a template, by what words name."""

    template: Template
    nouns: Nouns = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "nouns", Nouns(self.template))

    def find_part(self, thing: Thing) -> Part:
        """What a thing of the statement is."""
        return self.find_body(thing.body) if thing.body else self.find_points(thing.points)

    def find_points(self, names: Iterable[str]) -> Part:
        """A point, or the points of a line, and the bodies that have them."""
        points = tuple(dict.fromkeys(names))
        bodies = self.nouns.list_bodies(Thing(points=frozenset(points)))
        return Part(points, tuple(bodies or self._list_bodies_at(points)))

    def find_body(self, name: str) -> Part:
        """A body with its own points."""
        scheme = self.template.scheme
        own = [point for each in scheme.bodies if each.name == name for point in each.points]
        named = {
            point
            for joint in scheme.joints
            if joint.body == name and joint.circle
            for point in find_names(joint.circle)
        }
        centres = tuple(point for point in own if point in named)
        return Part(tuple(own), (name,), centres=centres)

    def _list_bodies_at(self, points: Sequence[str]) -> list[str]:
        """The bodies that have one point, the ones that turn about it where there are some."""
        bodies = self.template.scheme.bodies
        return [each.name for each in bodies if {*points} <= {*each.points}]

    def find_numbered(self, number: str) -> list[Part]:
        """The bodies whose labels have a number: gear 2."""
        labels = self.template.figure.labels
        return [
            self.find_body(each.name)
            for each in self.template.scheme.bodies
            if number in (labels.get(each.name) or "").replace(",", " ").split()
        ]

    def find_kind(self, kind: Kind) -> list[Part]:
        """What a noun may be that the statement gives no letter to, by its kind."""
        scheme = self.template.scheme
        match kind:
            case "guide":
                return [Part(is_guide=True)]
            case "wheel":
                names = [joint.body for joint in scheme.joints if joint.circle]
                on = [(joint.of, joint.on) for joint in scheme.joints]
                names += [body for body, shape in on if shape and shape.function == "circle"]
                names += [each.body for each in self.template.figure.circles]
            case "slider":
                slides = [joint for joint in scheme.joints if joint.on and not joint.circle]
                return [Part((joint.point,), (joint.body,)) for joint in slides if joint.point]
            case "load":
                names = [each.name for each in scheme.bodies if len(each.points) == 1]
            case "crank":
                names = [each.body for each in scheme.drivers if each.stated.TURNS]
            case _:
                assert_never(kind)
        return [self.find_body(name) for name in dict.fromkeys(names) if name != GROUND]


def list_guides(each: Solution) -> Iterator[Line]:
    """The lines of the ground on which points slide and wheels roll in an instance."""
    joints = each.assembly.mechanism.map(float).joints
    for sentence, joint in zip(each.template.scheme.joints, joints, strict=True):
        if GROUND in {sentence.of, sentence.body}:
            yield from joint.list_lines()


def is_moving(each: Solution, point: str) -> bool:
    """Whether a point moves as one of all bodies that have it."""
    speeds = [length(step) for step in Part((point,)).list_velocities(each)]
    return min(speeds, default=0.0) > STILL
