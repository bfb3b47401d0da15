"""What a template's sentences give to make a joint or driver of, and what their patterns share."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

CIRCLE = r"(?P<circle>circle\(.+?\)) of (?P<body>\w+)"
ON_SHAPE = r"(?P<on>(?:line|circle)\(.+?\))"
OF = r"(?: of (?P<of>\w+))?"
INSIDE = r"(?P<inside> inside)?"


@dataclass(frozen=True)
class JointParts:
    """The parts of a joint's sentence by their names in its pattern, worked out at an instance's
    values; those that the sentence lacks are empty, `of` is then the ground.

    `options` are the words of the pattern's own that it has, such as `inside`.
    """

    point: str
    body: str
    of: str
    bodies: tuple[str, ...]
    circle: Any
    on: Any
    carrier: str
    options: frozenset[str]


@dataclass(frozen=True)
class DriverParts:
    """The parts of a driver's sentence likewise; `direction` is a unit vector, zero where the
    sentence names none.
    """

    point: str
    body: str
    of: str
    direction: Vector
    centre: str
    velocity: Number
    acceleration: Number
