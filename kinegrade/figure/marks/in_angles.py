"""What lies in an angle that is marked, where a letter would seem to name it, and a line to be one
of its sides.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from kinegrade.figure.marks.angle_arc import AngleArc, LedAngleArc
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Floats
from kinegrade.figure.plane import polar

_BEYOND = 4.0  # millimetres beyond the arc of an angle that are still in it
_END = 0.3  # millimetres on either side of an arc that are its end
_STATIONS = np.array(((0.4,), (0.7,), (1.0,)))  # of a line that begins on a side


def list_arcs(marks: Iterable[Mark]) -> Iterator[AngleArc]:
    """The arcs of angles among some marks."""
    for mark in marks:
        if isinstance(mark, AngleArc):
            yield mark
        elif isinstance(mark, LedAngleArc):
            yield mark.arc


def list_arc_ends(marks: Iterable[Mark]) -> Iterator[Segment]:
    """Where the arcs of angles among some marks end: a piece of each side there."""
    for arc in list_arcs(marks):
        bow = arc.bow
        for angle in (bow.start, bow.start + bow.sweep):
            end, piece = bow.centre + polar(angle, bow.radius), polar(angle, _END)
            yield end - piece, end + piece


def rate_in_angles(places: Floats, arcs: Iterable[AngleArc]) -> Floats:
    """For each place 1 between the sides of an angle and not far beyond its arc, else 0."""
    found = np.zeros(len(places))
    for arc in arcs:
        bow, steps = arc.bow, places - np.array(arc.bow.centre)
        turned = (np.arctan2(steps[:, 1], steps[:, 0]) - bow.start) * np.sign(bow.sweep)
        within = turned % (2 * np.pi) < abs(bow.sweep)
        near = np.hypot(*steps.T) < bow.radius + _BEYOND
        found = np.maximum(found, within & near)
    return found


def lies_in_angle(line: Segment, arcs: Iterable[AngleArc]) -> bool:
    """Whether a line that may begin on a side of an angle goes on in one."""
    start, end = np.array(line)
    return bool(rate_in_angles(start + _STATIONS * (end - start), arcs).any())
