"""Mechanisms that differ only in size and speed have one figure, and a class's papers contain many
of them.

A figure is to scale, but the scale is chosen to fill the paper, so it shows shape alone; of given
motions it shows only the sense, and not even that where an arrow's hint fixes it. What it shows is
normalised here so that similar mechanisms are equal.
"""

from __future__ import annotations

from dataclasses import dataclass, field, is_dataclass
from typing import Any, assert_never

from kinegrade.figure.joints.drivers import find_motor, reduce_to_sense
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.plane import unit
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints, Moving, Turning

# Of a mechanism of unit size: far above rounding of floats, far below what a printer shows
_DECIMALS = 10


@dataclass(frozen=True)
class Subject:
    """What a figure shows: a mechanism of unit size with its hints; two are equal when their texts
    are.
    """

    text: str
    mechanism: Mechanism = field(compare=False)
    hints: FigureHints = field(compare=False)


def normalise_subject(mechanism: Mechanism, hints: FigureHints) -> tuple[Subject, float]:
    """The subject of a mechanism's figure, and the mechanism's size in metres."""
    size = max((abs(number) for number in _list_lengths(mechanism)), default=0.0) or 1.0
    scaled = scale_to_paper(mechanism, 1 / size)
    arrows_follow = any(map(_follows_driver, hints.arrows))
    shown = Mechanism(
        {name: _drop_last_bits(point) for name, point in scaled.points.items()},
        scaled.bodies,
        tuple(map(_drop_last_bits, scaled.joints)),
        tuple(
            _drop_last_bits(reduce_to_sense(driver))
            for driver in scaled.drivers
            if arrows_follow or find_motor(driver)
        ),
    )
    return Subject(repr((shown, hints)), shown, hints), size


def _list_lengths(mechanism: Mechanism) -> list[float]:
    """All coordinates, and the radii of all circles."""
    radii = [circle.radius for joint in mechanism.joints for circle in joint.list_circles()]
    return radii + [number for point in mechanism.points.values() for number in point]


def _drop_last_bits(part: Any) -> Any:
    """A vector, line, circle or joint without the last bits of its numbers; directions of unit
    length.
    """
    if isinstance(part, float):
        return round(part, _DECIMALS)
    if isinstance(part, Vector):
        return Vector(round(part.x, _DECIMALS) + 0.0, round(part.y, _DECIMALS) + 0.0)
    if isinstance(part, Line):
        return Line(_drop_last_bits(part.point), _drop_last_bits(unit(part.direction)))
    if is_dataclass(part) and not isinstance(part, type):
        return type(part)(**{name: _drop_last_bits(value) for name, value in vars(part).items()})
    if isinstance(part, str | bool | tuple):
        return part  # names and marks
    raise TypeError(f"a figure cannot be compared with another by {part!r}")


def _follows_driver(arrow: Turning | Moving) -> bool:
    """Whether an arrow takes its sense from the imposed motion."""
    match arrow:
        case Turning(sense=sense):
            return sense is None
        case Moving(along=along):
            return along is None
        case _:
            assert_never(arrow)
