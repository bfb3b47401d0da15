"""Edges of plates along which an axis of their frame runs: thin ones, which are its shaft, so that
its head and its tip are seen.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import assert_never

from msgspec.structs import replace

from kinegrade.figure.mechanism.plates import Edge, Plate
from kinegrade.figure.mechanism.straight.broad_links import list_axes
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Part, Rod, SlottedDisc
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import BodyFrame

_LONG = 19.0  # millimetres of an edge with room for an axis and its head


def has_room_for_axis(edge: float) -> bool:
    """Whether an axis ends on an edge of so many millimetres."""
    return edge > _LONG


def thin_edges(
    parts: Iterable[Part], at: Mapping[str, Vector], frames: Sequence[BodyFrame]
) -> tuple[Part, ...]:
    """The parts, with the edges of plates that an axis runs along as thin ones."""
    axes = list_axes(at, frames)
    return tuple(_thin_edges_of(part, axes) for part in parts)


def _thin_edges_of(part: Part, axes: Sequence[tuple[Vector, Vector]]) -> Part:
    match part:
        case Plate():
            return replace(part, thin=tuple(_list_thin(part, axes)))
        case Bar() | SlottedDisc() | GenevaWheel() | Rod():
            return part
        case _:
            assert_never(part)


def _list_thin(plate: Plate, axes: Sequence[tuple[Vector, Vector]]) -> Iterator[Edge]:
    """The edges of a plate along which one of some axes runs from either end."""
    for start, end in pairwise((*plate.corners, plate.corners[0])):
        along = unit(end - start)
        ways = ((start, along), (end, -along))
        on_edge = any(
            length(origin - corner) < NEAR and length(axis - way) < NEAR
            for origin, axis in axes
            for corner, way in ways
        )
        if on_edge and has_room_for_axis(length(end - start)):
            yield start, end
