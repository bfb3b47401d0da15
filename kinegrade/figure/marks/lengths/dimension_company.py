"""What a dimension keeps off as a whole: letters, arrows, axes, ground, angles and others."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.frames import FrameAxis
from kinegrade.figure.marks.in_angles import list_arc_ends
from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.marks.lengths.measured_direction import find_measured_direction
from kinegrade.figure.marks.straight.motions import gather_arrows
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import CLAIMING, widen_labels
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import THIN, Bow, Outline, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Length

_ON_ARROW = 45.0  # demerit of a dimension across the arrow of a motion
_ON_AXIS = 12.0  # demerit of a dimension line across the axis of a frame
_ON_GROUND = 8.0  # demerit of a dimension across the hatching of the ground
_HEAD_ON_LINE = 16.0  # demerit of a dimension whose arrowhead lies on something
# Demerits of a dimension line close beside another, of one that is cut by an extension line, and of
# one that goes on from another one at another distance
_CLOSE, _CUT, _STAGGERED = 6.0, 12.0, 6.0
_ON_MARK = 8.0  # demerit of a dimension across the arc of an angle or the mark of a right one
_ON_END = 12.0  # further demerit of one through an end of such an arc, which is read there
# Demerit of an extension line that seems to begin at another point, and millimetres from that
_AT_OTHER, _BESIDE_POINT = 8.0, 2.2


class DimensionCompany(Struct, frozen=True):
    """What a dimension has to keep off as a whole: letters and what is about them, the arrows of
    motions, and with its line, other than with its extension lines, the axes of frames and all that
    is firm; with its arrowheads all that is drawn; the ground; the arcs and squares of angles, most
    of all the ends of arcs; earlier dimensions and other points.
    """

    written: Obstacles
    claimed: Obstacles
    arrows: Obstacles
    axes: Obstacles
    firm: Obstacles
    drawn: Obstacles
    ground: Obstacles
    angles: Obstacles
    ends: Obstacles
    earlier: tuple[DimensionLine, ...]
    others: tuple[Vector, ...]

    @staticmethod
    def of(layout: Layout, ground: Obstacles, others: tuple[Vector, ...]) -> DimensionCompany:
        """What there is in a layout."""
        return DimensionCompany(
            Obstacles.of(layout.labels),
            widen_labels(layout.labels),
            gather_arrows(layout.marks),
            Obstacles.of(_list_axes(layout)),
            layout.obstacles.firm(),
            layout.obstacles,
            ground,
            Obstacles.of(filter(_marks_angle, layout.lines)),
            Obstacles.of((Strokes(tuple(list_arc_ends(layout.marks)), THIN),)),
            tuple(mark for mark in layout.marks if isinstance(mark, DimensionLine)),
            others,
        )

    def rate(self, mark: DimensionLine) -> DimensionLine:
        """The dimension with its demerit here: it stands well apart from earlier ones, or goes on
        from one of them in its line, where their heads meet.
        """
        chain = [
            part for each in self.earlier if mark.goes_on_from(each) for part in each.primitives()
        ]
        goes_on = bool(chain)
        begins, path = mark.beginnings(), mark.path()
        worse = _CLOSE * sum(map(mark.crowds, self.earlier))
        worse += _CUT * sum(map(mark.cuts, self.earlier))
        worse += _STAGGERED * (not goes_on and any(map(mark.adjoins, self.earlier)))
        worse -= Obstacles.of(chain).along(path, mark.shared)
        worse += self.written.along(begins, mark.shared)
        worse += CLAIMING * (self.claimed.along(mark.whole(), mark.shared) > 0)
        worse += _ON_ARROW * (self.arrows.along(path, mark.shared) > 0)
        worse += _ON_AXIS * (self.axes.along(path[:1], mark.shared) > 0)
        worse += self.firm.along(path[:1], mark.shared)
        worse += _ON_GROUND * (self.ground.along(path, mark.shared) > 0)
        worse += _HEAD_ON_LINE * (not goes_on and self.drawn.along(mark.heads(), shared=False) > 0)
        worse += _ON_MARK * (self.angles.along((*begins, *path), mark.shared) > 0)
        worse += _ON_END * (self.ends.along((*begins, *path), mark.shared) > 0)
        worse += _AT_OTHER * any(mark.begins_at(point, _BESIDE_POINT) for point in self.others)
        first, last = (self.firm.along((head,), shared=False) > 0 for head in mark.heads())
        mark = replace(mark, on_edge=(first, last)) if first or last else mark
        return replace(mark, demerit=mark.demerit + worse) if worse else mark


def list_beside(at: Mapping[str, Vector], hint: Length) -> tuple[Vector, ...]:
    """The other points that extension lines of a length might seem to begin at."""
    start, end = at[hint.start], at[hint.end]
    measured = find_measured_direction(hint.along, start, end)
    return tuple(
        point
        for point in at.values()
        if min(abs((point - own).dot(measured)) for own in (start, end)) < _BESIDE_POINT
        and min(length(point - own) for own in (start, end)) > NEAR
    )


def _list_axes(layout: Layout) -> list[Primitive]:
    axes = [mark for mark in layout.marks if isinstance(mark, FrameAxis)]
    return [part for axis in axes for part in axis.primitives()]


def _marks_angle(part: Primitive) -> bool:
    """Whether something drawn is the arc of an angle, or the square of a right one."""
    return isinstance(part, Bow | Outline) and part.pen == THIN
