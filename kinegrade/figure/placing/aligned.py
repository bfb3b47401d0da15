"""Whether a thin line runs on from another one, as if the two were one."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import THIN, Primitive, Strokes

_LEAST = 2.5  # millimetres: a shorter line is hatching, or an arm of a cross
_LEAN = 0.18  # sine of the angle from which on two lines are seen to differ in direction
_ASIDE, _BEYOND = 1.0, 3.5  # millimetres beside the line, and past its ends, that are its own


def list_thin_lines(drawn: Iterable[Primitive]) -> tuple[Segment, ...]:
    """The thin lines that are long enough for another one to run on from them."""
    thin = (each for each in drawn if isinstance(each, Strokes) and each.pen == THIN)
    lines = (line for strokes in thin for line in strokes.lines)
    return tuple(line for line in lines if length(line[1] - line[0]) > _LEAST)


def runs_on(line: Segment, others: Iterable[Segment]) -> bool:
    """Whether a line lies on another one, or begins near its end in its direction."""
    start, end = line
    toward, size = unit(end - start), length(end - start)
    for one, other in others:
        if abs(unit(other - one).cross(toward)) < _LEAN:
            steps = (one - start, other - start)
            aside = min(abs(step.cross(toward)) for step in steps)
            near, far = sorted(step.dot(toward) for step in steps)
            if aside < _ASIDE and near < size + _BEYOND and far > -_BEYOND:
                return True
    return False
