"""How far a straight part of the mechanism, or bare ground, is drawn along a direction."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import NEAR, length, mean, on_line, unit
from kinegrade.figure.scene import Disc
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector

_LARGEST_PIN = 1.5  # millimetres of radius: larger white circles are the insides of rings
_BEGINS = 1.0  # millimetres from a point within which what is drawn has to begin


def measure_drawn(at: Vector, toward: Vector, drawing: Drawing) -> float:
    """How far, in millimetres, a bar, an edge of a plate or the ground is drawn from a point on it
    in a direction (a unit vector); 0 when none is.
    """
    reaches = [0.0]
    for start, end in _list_lines(drawing):
        steps = [(end - at).dot(toward), (start - at).dot(toward)]
        along = abs(unit(end - start).cross(toward)) < NEAR
        if along and min(steps) < _BEGINS and on_line(at, Line(start, end - start)):
            reaches += steps
    return max(reaches)


def measure_pin(at: Vector, drawing: Drawing) -> float:
    """The radius, in millimetres, of the open pin that is drawn at a point; 0 where none is."""
    discs = (part for part in drawing.primitives if isinstance(part, Disc) and part.fill == "white")
    pins = (disc for disc in discs if disc.radius < _LARGEST_PIN)
    return max((pin.radius for pin in pins if length(pin.centre - at) < NEAR), default=0.0)


def find_edge(at: Vector, toward: Vector, drawing: Drawing) -> tuple[float, Vector]:
    """The length in millimetres of the edge of a plate that leaves a corner in a direction (a unit
    vector), and the unit vector from the edge out of the plate; 0 when none does.
    """
    found = [(0.0, toward.turned())]
    for part in drawing.parts:
        if isinstance(part, Plate) and any(length(corner - at) < NEAR for corner in part.corners):
            steps = [corner - at for corner in part.corners]
            across = toward.turned()
            outward = -across if mean(part.corners).dot(across) > at.dot(across) else across
            reaches = [step.dot(toward) for step in steps if abs(step.cross(toward)) < NEAR]
            found.append((max(reaches, default=0.0), outward))
    return max(found, key=lambda edge: edge[0])


def is_rigid(at: Vector, points: Mapping[str, Vector], drawing: Drawing) -> bool:
    """Whether a point is the corner of a plate, at which there is no pin to keep clear of."""
    pins = (points[symbol.point] for symbol in drawing.symbols if symbol.point)
    plates = (part for part in drawing.parts if isinstance(part, Plate))
    corners = (corner for plate in plates for corner in plate.corners)
    return any(length(corner - at) < NEAR for corner in corners) and all(
        length(pin - at) > NEAR for pin in pins
    )


def find_block(at: Vector, toward: Vector, drawing: Drawing) -> tuple[float, float]:
    """How far, in millimetres, the block that slides along an axis begins and ends from a point on
    it in its direction (a unit vector); zeros when there is none.
    """
    for rail in drawing.rails:
        ahead = (rail.at - at).dot(toward)
        if rail.block and ahead > rail.block.length and on_line(rail.at, Line(at, toward)):
            size = rail.block.length if abs(rail.along.cross(toward)) < NEAR else rail.block.width
            return ahead - size / 2, ahead + size / 2
    return 0.0, 0.0


def meets_face(at: Vector, toward: Vector, drawing: Drawing) -> bool:
    """Whether the plate of a follower is across the way from a point in a direction."""
    return any(
        (part.start - at).cross(toward) * (part.end - at).cross(toward) < 0
        and (part.start - at).dot(toward) > 0
        for part in drawing.parts
        if isinstance(part, Bar) and part.use == "face"
    )


def _list_lines(drawing: Drawing) -> Iterator[Segment]:
    """The axes of bars, the edges of plates, and the ground on which bare ends slide."""
    for part in drawing.parts:
        if isinstance(part, Bar | Rod):
            yield part.start, part.end
        elif isinstance(part, Plate):
            yield from pairwise((*part.corners, part.corners[0]))
    for rail in drawing.rails:
        if rail.bare:
            yield rail.start, rail.end
