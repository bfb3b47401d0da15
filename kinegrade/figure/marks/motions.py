"""Given straight motions as arrows at a point, each with several alternatives."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.figure.marks.imposed import find_imposed_direction
from kinegrade.figure.placing.mark import Mark, direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_beside
from kinegrade.figure.plane import mean, unit
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import HEADS, PIN, draw_arrow
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

_ARROW = 9.0  # millimetres, length of the arrow of a straight motion


def mark_motions(mechanism: Mechanism, hint: Moving) -> list[Mark]:
    """Arrows in the direction of the motion: from the point, then beside it, first those clear of
    the mechanism.
    """
    point = mechanism.points[hint.point]
    toward = (
        unit(direction(mechanism.points, point, hint.along))
        if hint.along
        else find_imposed_direction(mechanism, hint)
    )
    across = toward.turned()
    across = across if across.dot(mean(mechanism.points.values()) - point) <= 1e-6 else -across
    starts = [point + toward * gap for gap in (PIN + 0.2, 3.4, 6.0, 8.6)]
    starts += [
        point + across * (side * offset) + toward * shift
        for offset in (3.6, 5.0, 6.5, 8.0)
        for shift in (0.0, -_ARROW / 2, 3.0)
        for side in (1.0, -1.0)
    ]
    return [_MovingArrow(start, toward, hint, 0.5 * rank) for rank, start in enumerate(starts)]


@dataclass(frozen=True)
class _MovingArrow:
    """A straight arrow from `start` in the direction `toward`."""

    start: Vector
    toward: Vector
    hint: Moving
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its start."""
        return ((self.start + self.toward, self._end()),)

    def wish(self) -> Wish:
        """Beside the arrow, else around its tip."""
        shaft = list_spots_beside(self.hint.symbol, self.start + self.toward * 3, self._end())
        return Wish(self.hint.symbol, shaft, self._end())

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead."""
        return draw_arrow(self.start, self._end(), HEADS[self.hint.level])

    def _end(self) -> Vector:
        return self.start + self.toward * _ARROW
