"""Vectors as arrows: known ones solid with a filled head, unknown ones dashed with an open head, to
be distinguishable in black and white; arrows that would lie on one another are drawn side by side,
or one as an outline around the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import DASHED, FIRM, OPEN, Outline, Pen, Primitive, Strokes
from kinegrade.mechanics.vector import Vector

_IN_PLACE = Vector(0.0, 0.0)
_HEAD_LENGTH = 2.4  # millimetres: larger than the heads of dimensions
_HEAD_SLENDER = 0.29  # half the width of a head, as a share of its length
_HEAD_LEAST = 0.35  # millimetres, that of a small head: more than the line
_SOLID = Pen(0.3)
_HEAD_SHARE = 0.6  # of a short arrow that its head takes at most
_AROUND = 1.1  # millimetres from the line of an arrow to its outline around another
_WING = 0.8  # millimetres by which the head of an outline is wider on either side, and longer
# Of a short arrow that a head at one of its ends may be as long as, and millimetres of the least
_SPARED, _SMALLEST_HEAD = 0.6, 0.8
_AT_TIP = 0.05  # millimetres within which the ends of two arrows coincide
_SLANTED = 0.35  # sine of the angle from which on an arrow is seen to have another direction
_SAME = 0.01  # millimetres within which two arrows start at one point
_ON_LINE = 0.35  # millimetres from its line within which the tip of another arrow is on it
_HEADS_APART = 3.0  # millimetres between the tips of two arrows on one line
_CLOSE = 0.9  # millimetres: lines nearer than this over a stretch look like one
_STRETCH = 0.8  # millimetres that two lines may run close together


@dataclass(frozen=True)
class VectorArrow:
    """An arrow on paper, in millimetres, displaced by `aside` from its true position when another
    line lies there, or an outline `around` so many others that lie there; its `head` has that
    length at most.
    """

    symbol: str
    start: Vector
    end: Vector
    known: bool = True
    aside: Vector = _IN_PLACE
    around: int = 0
    head: float = _HEAD_LENGTH

    @property
    def line(self) -> Segment:
        """The straight line that is drawn, or the middle of the outline."""
        return (self.start + self.aside, self.end + self.aside)

    @property
    def edges(self) -> tuple[Segment, ...]:
        """The lines beside which its symbol stands: the shaft, or both sides of the outline."""
        if not self.around:
            return (self.line,)
        start, tip = self.line
        across = unit(tip - start).turned() * (_AROUND * self.around)
        return ((start + across, tip + across), (start - across, tip - across))

    @property
    def head_corners(self) -> tuple[Vector, Vector, Vector]:
        """The tip, and the corners of the head behind it."""
        start, tip = self.line
        toward = unit(tip - start)
        head = min(self.head, _HEAD_SHARE * length(tip - start))
        half = max(head * _HEAD_SLENDER, _HEAD_LEAST)
        back, across = tip - toward * head, toward.turned() * half
        return (tip, back + across, back - across)

    def goes_on_from(self, other: VectorArrow) -> bool:
        """Whether an arrow leads from the start of another one over its tip."""
        (start, tip), (begin, end) = self.line, other.line
        if self.around or other.around or length(begin - start) > _SAME:
            return False
        way, step = tip - start, end - start
        beyond = length(way) > length(step) and way.dot(step) > 0
        return beyond and abs(unit(way).cross(step)) < _ON_LINE

    def shares_start(self, other: VectorArrow) -> bool:
        """Whether another arrow on one line with this one starts where it does, and has its head
        elsewhere on that line.
        """
        (start, tip), (begin, end) = self.line, other.line
        return length(begin - start) < _SAME and length(end - tip) > _HEADS_APART

    def primitives(self) -> tuple[Primitive, ...]:
        """Shaft and head; the head is open where the vector is unknown."""
        if self.around:
            return (self._outline(),)
        corners = self.head_corners
        (start, tip), back = self.line, (corners[1] + corners[2]) / 2
        if self.known:
            return (
                Strokes(((start, back + (tip - back) * 0.2),), FIRM),
                Outline(corners, None, "black"),
            )
        return (Strokes(((start, back),), DASHED), Outline(corners, OPEN, "white"))

    def _outline(self) -> Outline:
        start, tip = self.line
        (left, _), (right, _) = self.edges
        along, size = unit(tip - start), length(tip - start)
        back = along * max(size - _HEAD_LENGTH - _WING * self.around, (1 - _HEAD_SHARE) * size)
        wing = along.turned() * _WING
        corners = (left, left + back, left + back + wing, tip)
        others = (right + back - wing, right + back, right)
        return Outline((*corners, *others), _SOLID if self.known else DASHED)


def put_side_by_side(
    arrows: Iterable[VectorArrow], offsets: Sequence[float], *, nested: bool = False
) -> tuple[VectorArrow, ...]:
    """The arrows in order, each displaced by the first of the offsets at which it lies on no other
    arrow; where they may be `nested`, arrows of one point and direction stay there, if their tips
    are apart.

    Offsets are millimetres to the upper side of the arrow's line (to the right of a vertical one).
    """
    placed: list[VectorArrow] = []
    for arrow in arrows:
        upper = _find_upper_side(unit(arrow.end - arrow.start))
        ways = [replace(arrow, aside=upper * offset) for offset in (0.0, *offsets)]
        chosen = next((way for way in ways if _is_clear(way, placed, nested)), arrow)
        placed.append(chosen)
    return tuple(placed)


def spare_short(arrows: Sequence[VectorArrow]) -> tuple[VectorArrow, ...]:
    """The arrows, the heads so small that none covers a short arrow that starts or ends at its
    tip.
    """
    return tuple(replace(arrow, head=_find_head(arrow, arrows)) for arrow in arrows)


def _find_head(arrow: VectorArrow, arrows: Iterable[VectorArrow]) -> float:
    """The length of an arrow's head beside the others at its tip."""
    sizes = [
        _SPARED * _measure(other)
        for other in arrows
        if any(length(end - arrow.end) < _AT_TIP for end in (other.start, other.end))
    ]
    return min(_HEAD_LENGTH, max(_SMALLEST_HEAD, min(sizes)))


def put_around(arrows: Sequence[VectorArrow]) -> tuple[VectorArrow, ...]:
    """The arrows, all where they belong: each that lies on shorter ones is an outline around them,
    and drawn before them.
    """
    placed: dict[int, VectorArrow] = {}
    for place in sorted(range(len(arrows)), key=lambda at: round(_measure(arrows[at]), 6)):
        arrow = arrows[place]
        within = [one.around for one in placed.values() if _covers(arrow, one)]
        placed[place] = replace(arrow, around=max(within, default=-1) + 1)
    return tuple(sorted((placed[at] for at in range(len(arrows))), key=lambda one: -one.around))


def _covers(arrow: VectorArrow, other: VectorArrow) -> bool:
    """Whether two arrows look like one, and not only as the other is short."""
    slant = unit(arrow.end - arrow.start).cross(unit(other.end - other.start))
    return abs(slant) < _SLANTED and look_like_one(arrow.line, other.line)


def _measure(arrow: VectorArrow) -> float:
    return length(arrow.end - arrow.start)


def _is_clear(arrow: VectorArrow, others: Iterable[VectorArrow], nested: bool) -> bool:
    """Whether an arrow is told from all others."""
    return not any(
        look_like_one(arrow.line, other.line) and not (nested and arrow.shares_start(other))
        for other in others
    )


def _find_upper_side(along: Vector) -> Vector:
    across = along.turned()
    return -across if (round(across.y, 6), round(across.x, 6)) < (0.0, 0.0) else across


def look_like_one(one: Segment, other: Segment) -> bool:
    """Whether two lines run so close together over a stretch that they look like one."""
    longer, shorter = sorted((one, other), key=lambda line: -length(line[1] - line[0]))
    along = unit(longer[1] - longer[0])
    (first, off), (last, rise) = (_project_on_line(longer[0], along, point) for point in shorter)
    low, high = max(0.0, min(first, last)), min(length(longer[1] - longer[0]), max(first, last))
    if high - low <= _STRETCH or abs(last - first) < 1e-9:
        return False
    slope = (rise - off) / (last - first)
    return max(abs(off + slope * (at - first)) for at in (low, high)) < _CLOSE


def _project_on_line(origin: Vector, along: Vector, point: Vector) -> tuple[float, float]:
    """A point's coordinates along and across a line."""
    step = point - origin
    return step.dot(along), along.cross(step)
