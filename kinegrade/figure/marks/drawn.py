"""How far a straight part of the mechanism, or bare ground, is drawn along a direction."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import NEAR, length, on_line, unit
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector

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


def measure_edge(at: Vector, toward: Vector, drawing: Drawing) -> float:
    """The length in millimetres of the edge of a plate that leaves a corner in a direction (a unit
    vector); 0 when none does.
    """
    plates = [part for part in drawing.parts if isinstance(part, Plate)]
    steps = [
        corner - at
        for plate in plates
        if any(length(corner - at) < NEAR for corner in plate.corners)
        for corner in plate.corners
    ]
    reaches = [step.dot(toward) for step in steps if abs(step.cross(toward)) < NEAR]
    return max(reaches, default=0.0)


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
