"""Vectors as arrows: known ones solid with a filled head, unknown ones dashed with an open head, to
be distinguishable in black and white; arrows that would lie on one another are drawn side by side,
or one as an outline around the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Floats, Wish, list_spots_around, list_spots_beside
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import FIRM, Label, Outline, Pen, Primitive, Strokes
from kinegrade.mechanics.vector import Vector

_IN_PLACE = Vector(0.0, 0.0)
_HEAD_LENGTH, _HEAD_WIDTH = 2.4, 1.4  # millimetres: larger than the heads of dimensions
DASHED = Pen(0.3, "dashed")
_SOLID = Pen(0.3)
_HEAD_SHARE = 0.6  # of a short arrow that its head takes at most
_AROUND = 1.1  # millimetres from the line of an arrow to its outline around another
_WING = 0.8  # millimetres by which the head of an outline is wider on either side, and longer
_SLANTED = 0.35  # sine of the angle from which on an arrow is seen to have another direction
_SAME = 0.01  # millimetres within which two arrows start at one point
_HEADS_APART = 3.0  # millimetres between the tips of two arrows on one line
_CLOSE = 0.9  # millimetres: lines nearer than this over a stretch look like one
_STRETCH = 0.8  # millimetres that two lines may run close together
_NEARER = 0.3  # millimetres by which a symbol has to be nearer to its arrow than to any other
# Along a line, of its points whose distance from a symbol is measured
_SHARES = np.linspace(0.0, 1.0, 17)[:, None, None]
# Cost of a symbol that may be read as that of another arrow: more than covering a firm line
_MISTAKEN = 40.0


@dataclass(frozen=True)
class VectorArrow:
    """An arrow on paper, in millimetres, displaced by `aside` from its true position when another
    line lies there, or an outline `around` so many others that lie there.
    """

    symbol: str
    start: Vector
    end: Vector
    known: bool = True
    aside: Vector = _IN_PLACE
    around: int = 0

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
        start, tip = self.line
        toward, size = unit(tip - start), length(tip - start)
        head = min(_HEAD_LENGTH, _HEAD_SHARE * size)
        back, across = (
            tip - toward * head,
            toward.turned() * (head * _HEAD_WIDTH / _HEAD_LENGTH / 2),
        )
        corners = (tip, back + across, back - across)
        if self.known:
            return (
                Strokes(((start, back + toward * (0.2 * head)),), FIRM),
                Outline(corners, None, "black"),
            )
        return (Strokes(((start, back),), DASHED), Outline(corners, Pen(0.25), "white"))

    def _outline(self) -> Outline:
        start, tip = self.line
        (left, _), (right, _) = self.edges
        along, size = unit(tip - start), length(tip - start)
        back = along * max(size - _HEAD_LENGTH - _WING * self.around, (1 - _HEAD_SHARE) * size)
        wing = along.turned() * _WING
        corners = (left, left + back, left + back + wing, tip)
        others = (right + back - wing, right + back, right)
        return Outline((*corners, *others), _SOLID if self.known else DASHED)

    def wish_beside(self, others: Iterable[VectorArrow]) -> Wish:
        """The symbol beside the middle of the arrow, nearer to it than to any other."""
        start, end = self.line
        return self._wish(
            np.concatenate((list_spots_beside(self.symbol, start, end), self._about_tip())), others
        )

    def wish_at_tip(self, others: Iterable[VectorArrow]) -> Wish:
        """The symbol around the tip of the arrow, or beside its half near the tip, at last beside
        the other half, nearer to it than to any other.
        """
        start, end = self.line
        middle, about = (start + end) / 2, self._about_tip()
        near, far = (
            list_spots_beside(self.symbol, *half, gaps=(0.5, 1.4))
            for half in ((middle, end), (start, middle))
        )
        return self._wish(np.concatenate((about[:8], near, about[8:], far)), others)

    def foresee_symbol(self) -> Label:
        """The symbol at the first of its places around the tip."""
        return Wish(self.symbol, self._about_tip()).label_at(0)

    def _about_tip(self) -> Floats:
        start, end = self.line
        return list_spots_around(self.symbol, end, away=end - start)

    def _wish(self, spots: Floats, others: Iterable[VectorArrow]) -> Wish:
        lines = [line for other in others if other is not self for line in self._find_rest(other)]
        return Wish(
            self.symbol,
            spots,
            None,
            _MISTAKEN * rate_nearness_to_lines(self.symbol, spots, self.edges, lines),
        )

    def _find_rest(self, other: VectorArrow) -> tuple[Segment, ...]:
        """The lines of another arrow; of one that goes on where this one ends, its last part."""
        (start, tip), (_, end) = self.line, other.line
        longer = length(end - start) > length(tip - start) and not self.around + other.around
        if longer and self.shares_start(other) and look_like_one(self.line, other.line):
            return (((tip + end) / 2, end),)
        return other.edges


def rate_nearness_to_lines(
    symbol: str, spots: Floats, own: Sequence[Segment], others: Sequence[Segment]
) -> Floats:
    """For each spot 1 where a symbol would stand about as near to another line as to its `own`,
    else 0.
    """
    if not others:
        return np.zeros(len(spots))
    half = np.array(measure_symbol(symbol)) / 2
    mine, theirs = (measure_distances(spots, half, lines) for lines in (own, others))
    return np.asarray(theirs < mine + _NEARER, dtype=float)


def measure_distances(spots: Floats, half: Floats, lines: Sequence[Segment]) -> Floats:
    """The distances from boxes about the spots to the nearest of the lines, each line sampled as a
    row of points.
    """
    starts, ends = (np.array(corners) for corners in zip(*lines, strict=True))
    rows = starts + _SHARES * (ends - starts)
    off = [
        np.maximum(np.abs(spots[:, axis, None] - rows[..., axis].ravel()) - half[axis], 0.0)
        for axis in (0, 1)
    ]
    return np.asarray(np.sqrt((off[0] ** 2 + off[1] ** 2).min(axis=1)))


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
