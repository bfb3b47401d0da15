"""What decides where the arrow of a motion may stand, besides what is drawn under it."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.straight.moving_arrow import MovingArrow
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import COST_LABEL, Obstacles
from kinegrade.figure.plane import NEAR, length, polar
from kinegrade.figure.scene import THIN, Bow, Strokes
from kinegrade.mechanics.vector import Vector

# Demerits of an arrow that ends at a rim, as a radius would, and at the arc of an angle
_HEAD_AT_RIM, _HEAD_AT_ARC = 8.0, 8.0
_OFF_RIM = 1.2  # millimetres between a head and a rim that it would seem to end at
# Millimetres between a head and a thin line across it, as of an axis, which would seem to end a
# dimension there, and the demerit of less
_OFF_LINE, _HEAD_AT_LINE = 1.5, 50.0
_OVER_SIDE = 18.0  # demerit of a longer arrow that hides the side of an angle
_ACROSS_ARC = 12.0  # demerit of an arrow across the arc of an angle, which would seem to end there
# Demerits of an arrow on the far side of the rail on which its point slides, more where its line
# would slant through the hatching
_BEHIND, _SLANTED = 60.0, 4.0
# Demerit of an arrow beside the centre of a wheel, other points of which move otherwise, and the
# radius in millimetres from which on a circle is that of a wheel
_OFF_CENTRE, _WHEEL = 60.0, 2.0
_PAST_HATCHING = 1.4  # millimetres from a rail to the way past its hatching
_SAME = 1e-3  # between two unit vectors of one direction


class Surroundings(Struct, frozen=True):
    """Rails, the arcs of angles, those of them that begin `along` the motion, straight thin lines,
    rims, and what an arrow does not cross close to its point either: rims and labels.
    """

    rails: tuple[Rail, ...]
    angles: Obstacles
    along: Obstacles
    thin: Obstacles
    rims: Obstacles
    close: Obstacles

    @staticmethod
    def of(layout: Layout, rails: Sequence[Rail], at: Vector, toward: Vector) -> Surroundings:
        """What there is in a layout for an arrow from a point in a direction."""
        arcs = [line for line in layout.lines if isinstance(line, Bow) and line.pen == THIN]
        along = [arc for arc in arcs if _begins_along(arc, at, toward)]
        across = Obstacles.of(arc for arc in arcs if arc not in along)
        strokes = [line for line in layout.lines if isinstance(line, Strokes) and line.pen == THIN]
        thin = Obstacles.of(strokes)
        rims = Obstacles((), layout.obstacles.rings)
        labels = [line for line in layout.obstacles.lines if line[4][-1] >= COST_LABEL]
        close = Obstacles(labels, layout.obstacles.rings)
        return Surroundings(tuple(rails), across, Obstacles.of(along), thin, rims, close)

    def rate(self, arrow: MovingArrow) -> MovingArrow:
        """The arrow with its demerit here; the way to one in the ground is past the hatching, and
        straight through it.
        """
        worse, past, ground = 0.0, arrow.past, 0.0
        unseen, on_line = arrow.list_unseen(), arrow.is_ahead() and arrow.outward is None
        if self.angles.lines and self.angles.along((*unseen, *arrow.path()), arrow.shared) > 0:
            worse += _ACROSS_ARC
        worse += self.close.along(unseen, arrow.shared)
        if self.along.lines and arrow.short:
            worse += _OVER_SIDE
        elif self.along.lines and self.along.along((arrow.head(),), arrow.shared) > 0:
            worse += _HEAD_AT_ARC
        if on_line and self.thin.along((arrow.head(_OFF_LINE),), shared=True) > 0:
            worse += _HEAD_AT_LINE
        if self.rims.rings and self.rims.along((arrow.head(_OFF_RIM),), arrow.shared) > 0:
            worse += _HEAD_AT_RIM
        if not arrow.is_ahead() and self._is_centre(arrow.point):
            worse += _OFF_CENTRE
        for rail in self.rails:
            slides = length(rail.at - arrow.point) < NEAR
            if slides and (arrow.start - rail.at).dot(rail.side) > rail.level:
                worse += _BEHIND + _SLANTED * (not arrow.is_level())
                past, ground = max(past, rail.level + _PAST_HATCHING), rail.level
        if not worse and past == arrow.past:
            return arrow
        return replace(arrow, demerit=arrow.demerit + worse, past=past, ground=ground)

    def _is_centre(self, point: Vector) -> bool:
        """Whether a point is the centre of a wheel."""
        rings = (ring[4] for ring in self.rims.rings)
        return any(
            outer > _WHEEL and hypot(x - point.x, y - point.y) < NEAR for x, y, _, outer, _ in rings
        )


def _begins_along(arc: Bow, at: Vector, toward: Vector) -> bool:
    """Whether an arrow from the vertex of an angle runs along a side of it."""
    sides = (polar(arc.start), polar(arc.start + arc.sweep))
    at_vertex = length(arc.centre - at) < NEAR
    return at_vertex and any(length(side - toward) < _SAME for side in sides)
