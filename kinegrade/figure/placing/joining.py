"""Whether what is drawn joins two points by a straight line, and other points divide it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from kinegrade.figure.placing.crossing import SAME_AXIS, resolve
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.plane import NEAR, length, nearest_of
from kinegrade.mechanics.vector import Vector

Join = Literal["none", "part", "whole"]


def find_join(drawn: Obstacles, start: Vector, end: Vector, gap: float) -> Join:
    """Whether a straight line is drawn between two points, to within a gap (millimetres) at either
    end, or they lie on a longer one.
    """
    size = length(end - start)
    join: Join = "none"
    if size < 2 * gap:
        return join
    toward = (end - start) / size
    at = start + toward * gap  # a line that begins within the gap passes here, and so does a longer
    for _, _, _, _, (x, y, dx, dy, *_) in drawn.near((*at, *at)).lines:
        near, near_off = resolve(x - start.x, y - start.y, *toward)
        far, far_off = resolve(x + dx - start.x, y + dy - start.y, *toward)
        on_axis = abs(near_off) < SAME_AXIS and abs(far_off) < SAME_AXIS
        before, beyond = -min(near, far), max(near, far) - size
        if on_axis and abs(before) <= gap and abs(beyond) <= gap:
            return "whole"
        if on_axis and min(before, beyond) >= -gap:
            join = "part"
    return join


def divides(start: Vector, end: Vector, others: Iterable[Vector]) -> bool:
    """Whether one of the other points divides the line, so that a letter beside it could mean only
    a part of it.
    """
    return any(
        length(point - nearest_of(point, start, end)) < NEAR
        and length(point - start) > NEAR < length(point - end)
        for point in others
    )


def part_line(drawn: Obstacles, one: Segment, other: Segment, gap: float) -> bool:
    """Whether two segments are the two parts of one straight line that is drawn."""
    for start, middle in (one, one[::-1]):
        for end, meeting in (other, other[::-1]):
            if length(meeting - middle) < NEAR and divides(start, end, [middle]):
                return find_join(drawn, start, end, gap) == "whole"
    return False
