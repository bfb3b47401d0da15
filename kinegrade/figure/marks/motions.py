"""Given straight motions as arrows at a point, each with several alternatives."""

from __future__ import annotations

from dataclasses import dataclass, replace

from kinegrade.figure.marks.imposed import find_imposed_direction
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_beside
from kinegrade.figure.plane import length, mean, unit
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import HEADS, PIN, draw_arrow
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

_ARROW = 9.0  # millimetres, length of the arrow of a straight motion
# Millimetres from the point to the tail, with their demerits: at its pin, at the free face of its
# block, or beyond another arrow
_AHEAD = {PIN + 0.2: 0.0, 3.4: 0.5, 6.0: 2.5, 11.0: 4.5}
# Millimetres beside the line of motion, on the free side first, and along it to the tail
_OFFSETS = {3.6: 1.0, -3.6: 1.3, 5.0: 2.0, -5.0: 2.3, 6.5: 3.0, -6.5: 3.3, 8.0: 4.0, -8.0: 4.3}
_SHIFTS = {0.0: 0.0, 3.0: 0.5, -_ARROW / 2: 2.0, -_ARROW: 6.0}
_OPPOSED = 8.0  # demerit of an arrow that stands tail to tail with another beside its point
_LEAST_OFFSET = 1.0  # millimetres from which on an arrow stands beside its point
# Millimetres from a point within which an arrow may lie close to a bar, and sideways its block
_LEAVING, _BLOCK = 3.0, 2.0


def add_motion(layout: Layout, mechanism: Mechanism, hint: Moving) -> Layout:
    """The layout with an arrow in the direction of the motion; beside its point it keeps off the
    line of another one that goes the other way: the two would read as a dimension.
    """
    twins = [
        mark
        for mark in layout.marks
        if isinstance(mark, _MovingArrow) and mark.hint.point == hint.point
    ]
    return layout.marked(
        [
            replace(arrow, demerit=arrow.demerit + _OPPOSED * any(map(arrow.opposes, twins)))
            for arrow in _list_arrows(mechanism, hint)
        ]
    )


def _list_arrows(mechanism: Mechanism, hint: Moving) -> list[_MovingArrow]:
    """Arrows in the direction of the motion: from the point, then beside it, first those clear of
    the mechanism; never behind something.
    """
    point = mechanism.points[hint.point]
    toward = (
        unit(direction(mechanism.points, point, hint.along))
        if hint.along
        else find_imposed_direction(mechanism, hint)
    )
    across = toward.turned()
    across = across if across.dot(mean(mechanism.points.values()) - point) <= 1e-6 else -across
    ahead = [
        _MovingArrow(point + toward * gap, toward, hint, demerit, point)
        for gap, demerit in _AHEAD.items()
    ]
    beside = [
        _MovingArrow(point + across * offset + toward * shift, toward, hint, nearby + level, point)
        for offset, nearby in _OFFSETS.items()
        for shift, level in _SHIFTS.items()
    ]
    return [*ahead, *beside]


@dataclass(frozen=True)
class _MovingArrow:
    """A straight arrow from `start` in the direction `toward`."""

    start: Vector
    toward: Vector
    hint: Moving
    demerit: float
    point: Vector
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its start at the pin, which leaves the parts there; beside its point
        the way there as well, past a block: no wall or bar lies between.
        """
        away = (self.start + self._end()) / 2 - self.point
        aside = abs(away.dot(self.toward.turned()))
        if aside < _LEAST_OFFSET:
            near = max(0.0, _LEAVING - length(self.start - self.point))
            return ((self.start + self.toward * near, self._end()),)
        past = self.point + away * (_BLOCK / aside)
        return ((self.start, self._end()), (past, self.point + away))

    def opposes(self, other: _MovingArrow) -> bool:
        """Whether both stand beside their point on one line, in opposite senses."""
        across = self.toward.turned()
        off, aside = ((self.start - at).dot(across) for at in (other.start, self.point))
        on_line = abs(off) < _LEAST_OFFSET <= abs(aside)
        against: bool = self.toward.dot(other.toward) < 0
        return on_line and against

    def wish(self) -> Wish:
        """Beside the arrow, else around its tip."""
        shaft = list_spots_beside(self.hint.symbol, self.start + self.toward * 3, self._end())
        return Wish(self.hint.symbol, shaft, self._end())

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead."""
        return draw_arrow(self.start, self._end(), HEADS[self.hint.level])

    def _end(self) -> Vector:
        return self.start + self.toward * _ARROW
