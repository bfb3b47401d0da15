"""What would seem to belong to the extension lines of dimensions: a letter beyond the end of one,
a line across one or along it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.place import Floats
from kinegrade.figure.plane import length, nearest_of, unit
from kinegrade.figure.scene import THIN, Strokes

# Millimetres beyond the end of a line, and beside it, that are its own
_AT_END, _ASIDE = 6.0, 1.5
_ONWARD = 2.5  # millimetres from the end of a leader that its letter takes
_ALONG, _NEAR = 0.09, 9.0  # sine of an angle, and millimetres, within which lines are parallel


def list_extension_lines(marks: Iterable[Mark]) -> Iterator[Segment]:
    """The extension lines of the dimensions among some marks."""
    for mark in marks:
        if isinstance(mark, DimensionLine):
            yield from mark.extensions


def rate_beyond_lines(places: Floats, half: float, lines: Iterable[Segment]) -> Floats:
    """For each place of a letter of `half` a size 1 where a line ends that leads to it, else 0."""
    found = np.zeros(len(places))
    for start, end in lines:
        steps, toward = places - np.array(end), unit(end - start)
        ahead, aside = steps @ np.array(toward), np.abs(steps @ np.array(toward.turned()))
        found = np.maximum(found, (ahead > 0) & (ahead < half + _AT_END) & (aside < _ASIDE))
    return found


def is_taken_for_one(line: Segment, lines: Iterable[Segment]) -> bool:
    """Whether a leader crosses one of some extension lines, with the letter at its end, or runs
    along it close by.
    """
    toward, others = unit(line[1] - line[0]), tuple(lines)
    onward = (line[0], line[1] + toward * _ONWARD)
    if Obstacles.of([Strokes(others, THIN)]).along((onward,), shared=False) > 0:
        return True
    return any(
        abs(toward.cross(unit(end - start))) < _ALONG
        and min(length(at - nearest_of(at, start, end)) for at in line) < _NEAR
        for start, end in others
    )
