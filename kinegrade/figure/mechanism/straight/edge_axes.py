"""Plates along an edge of which an axis of their frame runs: they reach beyond their edges, so that
the axis lies on them from its origin to its tip.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import permutations
from typing import assert_never

from msgspec.structs import replace

from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight.broad_links import list_axes
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Part, Rod, SlottedDisc
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import BodyFrame

_LONG = 19.0  # millimetres of an edge with room for an axis and its head


def has_room_for_axis(edge: float) -> bool:
    """Whether an axis ends on an edge of so many millimetres."""
    return edge > _LONG


def rule_plates(
    parts: Iterable[Part], at: Mapping[str, Vector], frames: Sequence[BodyFrame]
) -> tuple[Part, ...]:
    """The parts, of which plates with an axis along an edge are ruled."""
    axes = list_axes(at, frames)
    return tuple(_rule_plate(part, axes) for part in parts)


def _rule_plate(part: Part, axes: Sequence[tuple[Vector, Vector]]) -> Part:
    match part:
        case Plate():
            return replace(part, ruled=_has_axis_on_edge(part, axes))
        case Bar() | SlottedDisc() | GenevaWheel() | Rod():
            return part
        case _:
            assert_never(part)


def _has_axis_on_edge(plate: Plate, axes: Sequence[tuple[Vector, Vector]]) -> bool:
    """Whether one of some axes runs from a corner along a long edge of a plate."""
    return any(
        has_room_for_axis(length(end - start))
        and length(origin - start) < NEAR
        and length(axis - unit(end - start)) < NEAR
        for start, end in permutations(plate.corners, 2)
        for origin, axis in axes
    )
