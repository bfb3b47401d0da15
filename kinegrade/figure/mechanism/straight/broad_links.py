"""Links along which an axis of their frame runs: broad, so that the axis is seen on them from its
origin on.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import assert_never

from msgspec.structs import replace

from kinegrade.figure.mechanism.straight_parts import Bar, Part, list_ways
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import BodyFrame

_LONG = 19.0  # millimetres of a link with room for an axis and its head


def find_frame_place(at: Mapping[str, Vector], frame: BodyFrame) -> tuple[Vector, Vector]:
    """Where the origin of a body's frame is, and the direction of its x axis."""
    along = unit(direction(at, at[frame.start], frame.end))
    match frame.along:
        case "x":
            return at[frame.at], along
        case "y":
            return at[frame.at], -along.turned()
        case _:
            assert_never(frame.along)


def list_axes(at: Mapping[str, Vector], frames: Sequence[BodyFrame]) -> list[tuple[Vector, Vector]]:
    """The origin and the direction of both axes of each frame."""
    return [
        (origin, axis)
        for origin, along in (find_frame_place(at, frame) for frame in frames)
        for axis in (along, along.turned())
    ]


def broaden_links(
    parts: Iterable[Part], at: Mapping[str, Vector], frames: Sequence[BodyFrame]
) -> tuple[Part, ...]:
    """The parts, of which long links with an axis on them are broad."""
    axes = list_axes(at, frames)
    return tuple(
        replace(part, use="broad")
        if isinstance(part, Bar)
        and part.use == "link"
        and any(measure_way(part, origin, axis) > _LONG for origin, axis in axes)
        else part
        for part in parts
    )


def measure_way(bar: Bar, origin: Vector, toward: Vector) -> float:
    """How far, in millimetres, a bar runs from a point on it in a direction (a unit vector); 0
    where it does not.
    """
    ways = (way for way in list_ways(bar, origin) if length(unit(way) - toward) < NEAR)
    return max(map(length, ways), default=0.0)
