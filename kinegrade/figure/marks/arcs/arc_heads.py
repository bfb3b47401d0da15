"""The ends of arcs: a line through one; arrowheads that are lost among other lines, at a pin,
or across a line, so that the arc seems to end there.
"""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import length, nearest_of, parts, polar, unit
from kinegrade.figure.scene import Bow
from kinegrade.figure.symbols.arrows import draw_arc_head
from kinegrade.mechanics.vector import Vector

# Millimetres about the tip of a head to a pin and to the axis of a bar or the edge of a slot, and
# from a side to what is drawn along that
_OFF_PIN, _OFF_BAR, _ON_SIDE = 2.6, 1.8, 0.1
_OFF_LINE = 0.4  # millimetres between a head and a thin line that is no side of the angle
_AT_END = 0.9  # millimetres between an end of an arc and a line that spoils it
_ALONG = 0.02  # sine of the angle between a side and a line along it


def is_at_pin_or_bar(bow: Bow, pins: Iterable[Vector], bars: Iterable[Segment]) -> bool:
    """Whether the head at the end of an arc is at a pin, or where another bar crosses its side."""
    tip = bow.centre + polar(bow.start + bow.sweep, bow.radius)
    gaps = [length(nearest_of(tip, *line) - tip) for line in bars]
    crossed = any(_ON_SIDE < gap < _OFF_BAR for gap in gaps)
    return crossed or any(length(pin - tip) < _OFF_PIN for pin in pins)


def is_across_line(bow: Bow, lines: Iterable[Segment]) -> bool:
    """Whether the head at the end of an arc lies across a line that is no side of the angle."""
    tip, *back = draw_arc_head(bow).corners
    neck = (back[0] + back[1]) / 2
    sides = (polar(bow.start), polar(bow.start + bow.sweep))
    for start, end in lines:
        toward = unit(end - start)
        if all(abs(toward.cross(side)) > _ALONG for side in sides):
            gap = min(length(nearest_of(at, start, end) - at) for at in (tip, neck))
            if gap < _OFF_LINE or parts(start, end, tip, neck):
                return True
    return False


def is_ended_on(bow: Bow, lines: Iterable[Segment]) -> bool:
    """Whether one of some lines passes through an end of an arc, other than along its side."""
    ends = [polar(angle) for angle in (bow.start, bow.start + bow.sweep)]
    return any(
        abs(unit(end - start).cross(side)) > _ALONG
        and length(nearest_of(at, start, end) - at) < _AT_END
        for start, end in lines
        for side, at in ((side, bow.centre + side * bow.radius) for side in ends)
    )
