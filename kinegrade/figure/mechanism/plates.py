"""Bodies that are plates: the polygon of their points, and the outward side of its edges."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from msgspec import Struct

from kinegrade.figure.plane import collinear, hull, on_line
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.vector import Vector

RULED_EDGE = 1.5  # millimetres of a ruled plate beyond its edges


class Plate(Struct, frozen=True):
    """A body with three or more marked points that are not in line; corners counter-clockwise.

    It is `rounded` about the pins at its corners where all of them are pins and no edge of it
    matters. Where it is `ruled`, an axis of its frame runs along an edge: it reaches beyond its
    edges, which are thin lines on it.
    """

    body: str
    corners: tuple[Vector, ...]
    rounded: bool = False
    ruled: bool = False


def find_plate(body: Body, points: Sequence[Vector], shapes: Mapping[str, str]) -> Plate | None:
    """The plate that a body with these points forms; None for rods and for bodies of fewer
    points.
    """
    if len(points) < 3 or shapes.get(body.name) == "bent" or collinear(points):
        return None
    return Plate(body.name, hull(points))


def find_outward_direction(plate: Plate, line: Line) -> Vector | None:
    """The direction (of any length) that leaves a plate across its edge on the line; None when no
    edge lies there.
    """
    for start, end in pairwise((*plate.corners, plate.corners[0])):
        if on_line(start, line) and on_line(end, line):
            return -(end - start).turned()
    return None
