"""Everything drawn so far, as lines and rings, to determine what a rectangle laid over it would
cover.

Costs are whole numbers, so that a sum does not depend on the order of its terms, and things that
merely touch do not count, by a margin far above rounding: every machine draws the same figure.

Few things are near any one place, and one of the first places tried is usually free: checking those
few in plain numbers takes less time than computing with arrays of all.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain, pairwise
from math import inf
from typing import assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.placing.crossing import (
    Boxed,
    any_meets_line,
    any_meets_ring,
    crosses_box,
    encircles_box,
    invert_step,
    make_boxed_strip,
)
from kinegrade.figure.plane import unit
from kinegrade.figure.scene import (
    BOLD,
    THIN,
    TOOTHED,
    Bow,
    Disc,
    Label,
    Outline,
    Primitive,
    Strokes,
)
from kinegrade.figure.teeth import TOOTH_ROOT, TOOTH_TIP
from kinegrade.mechanics.vector import Vector

Segment = tuple[Vector, Vector]
Point = tuple[float, float]
Bounds = tuple[float, float, float, float]  # left, bottom, right, top

COST_LABEL, COST_BOLD, COST_FIRM, COST_THIN = 1000.0, 100.0, 10.0, 4.0
# Millimetres to be kept free on either side of a mark; less for thin lines
_ROOM, _SHARED_ROOM = (0.8, 0.6)
_CORNER = 1.5  # times half its width: how far a pen's corners reach at any angle, and a little more


class Obstacles(Struct, frozen=True):
    """Lines and rings, each after its bounding box (left, bottom, right, top); never changed, only
    extended.

    A line has x, y of its start, the steps dx, dy to its end, their negative inverses, half of its
    pen's width and its cost. A ring has x, y, inner radius, outer radius and cost.
    """

    lines: Sequence[Boxed]
    rings: Sequence[Boxed]

    @staticmethod
    def of(primitives: Iterable[Primitive]) -> Obstacles:
        """The primitives as obstacles."""
        return Obstacles((), ()).with_drawn(primitives)

    def with_drawn(self, primitives: Iterable[Primitive]) -> Obstacles:
        """These obstacles and more."""
        lines: list[Boxed] = []
        rings: list[Boxed] = []
        for primitive in primitives:
            match primitive:
                case Label():
                    lines.extend(_label(primitive))
                case Disc():
                    rings.append(_make_ring(primitive))
                case Strokes() | Outline() | Bow():
                    lines.extend(_make_segments(primitive))
                case _:
                    assert_never(primitive)
        return Obstacles((*self.lines, *lines), (*self.rings, *rings))

    def near(self, box: Bounds) -> Obstacles:
        """The obstacles that may reach into a box."""
        return Obstacles(_find_near(self.lines, box), _find_near(self.rings, box))

    def firm(self) -> Obstacles:
        """Those of them that are more than thin lines, without letters."""
        lines = [each for each in self.lines if COST_THIN < each[4][-1] < COST_LABEL]
        return Obstacles(lines, self.rings)

    def outlines(self) -> Obstacles:
        """Those that are firm, but for teeth."""
        firm = self.firm()
        return replace(firm, lines=[each for each in firm.lines if each[4][-2] <= BOLD.width / 2])

    def under_box(
        self, x: float, y: float, width: float, height: float, enough: float = inf
    ) -> float:
        """The sum of the costs that an upright box about a centre covers; zero when it is free. Not
        all are counted once they are `enough`.
        """
        wide, high, total = width / 2, height / 2, 0.0
        left, bottom, right, top = x - wide, y - high, x + wide, y + high
        for low_x, low_y, high_x, high_y, line in self.lines:
            if low_x <= right and high_x >= left and low_y <= top and high_y >= bottom:
                start_x, start_y, _, _, pace_x, pace_y, pen, cost = line
                across = (start_x - x, pace_x, wide + pen)
                if crosses_box(across, (start_y - y, pace_y, high + pen)):
                    total += cost
                    if total >= enough:
                        return total
        for low_x, low_y, high_x, high_y, ring in self.rings:
            if low_x <= right and high_x >= left and low_y <= top and high_y >= bottom:
                centre_x, centre_y, inner, outer, cost = ring
                if encircles_box(centre_x - x, centre_y - y, (wide, high), inner, outer):
                    total += cost
        return total

    def along(self, path: Sequence[Segment], shared: bool, enough: float = inf) -> float:
        """The cost of drawing something thin along straight pieces.

        Whatever the path meets counts once; where lines may be shared, a thin line on the axis of a
        piece does not count. Not all are counted once they are `enough`.
        """
        if not path or not (self.lines or self.rings):
            return 0.0
        half = _SHARED_ROOM if shared else _ROOM
        across, upward = zip(*chain.from_iterable(path), strict=True)
        box = (min(across) - half, min(upward) - half, max(across) + half, max(upward) + half)
        lines, rings = _find_near(self.lines, box), _find_near(self.rings, box)
        if not lines and not rings:
            return 0.0
        strips = [make_boxed_strip(start, end, half) for start, end in path]
        total = 0.0
        for boxed in lines:
            cost = boxed[4][-1]
            if any_meets_line(strips, boxed, shared and cost <= COST_THIN):
                total += cost
                if total >= enough:
                    return total
        for boxed in rings:
            if any_meets_ring(strips, boxed):
                total += boxed[4][-1]
        return total


NOTHING = Obstacles((), ())


def _find_near(things: Sequence[Boxed], box: Bounds) -> list[Boxed]:
    """The lines or rings whose boxes meet a box."""
    left, bottom, right, top = box
    return [
        thing
        for thing in things
        if thing[0] <= right and thing[2] >= left and thing[1] <= top and thing[3] >= bottom
    ]


def _label(label: Label) -> list[Boxed]:
    """A label's box as its longer middle line, with a pen as wide as the box is narrow, and its
    diagonals.

    The middle line is exact against upright boxes; the diagonals reach the corners for strips at an
    angle.
    """
    (x, y), wide, high = label.centre, label.width / 2, label.height / 2
    half = min(wide, high)
    reaches = ((wide - half, high - half, half), (wide, high, 0.0), (wide, -high, 0.0))
    return [
        _make_line((x - across, y - upward), (x + across, y + upward), pen, COST_LABEL)
        for across, upward, pen in reaches
    ]


def _make_line(start: Point, end: Point, pen: float, cost: float) -> Boxed:
    (x, y), (to_x, to_y) = start, end
    left, right = (x, to_x) if x < to_x else (to_x, x)
    bottom, top = (y, to_y) if y < to_y else (to_y, y)
    dx, dy = to_x - x, to_y - y
    reach = _CORNER * pen
    return (
        left - reach,
        bottom - reach,
        right + reach,
        top + reach,
        (x, y, dx, dy, invert_step(dx), invert_step(dy), pen, cost),
    )


def _make_ring(disc: Disc) -> Boxed:
    """A small filled disc counts as a whole, a larger one only by its line."""
    pen = disc.pen.width / 2 if disc.pen else 0.0
    solid = disc.fill in ("black", "white") and disc.radius < 3
    cost = COST_BOLD if solid or pen >= BOLD.width / 2 else COST_FIRM
    (x, y), outer = disc.centre, disc.radius + pen
    inner = 0.0 if solid else max(disc.radius - pen, 0.0)
    return (x - outer, y - outer, x + outer, y + outer, (x, y, inner, outer, cost))


def _make_segments(primitive: Strokes | Outline | Bow) -> list[Boxed]:
    if isinstance(primitive, Outline) and primitive.pen == TOOTHED:
        return _make_band(primitive.corners)
    if isinstance(primitive, Outline) and primitive.pen is None and primitive.fill != "black":
        return []  # a ground, whose edge is drawn over it
    width = primitive.pen.width if primitive.pen else 0.0
    cost = COST_BOLD if width >= BOLD.width else COST_FIRM if width > THIN.width else COST_THIN
    return [_make_line(start, end, width / 2, cost) for start, end in _split(primitive)]


def _make_band(contour: Sequence[Vector]) -> list[Boxed]:
    """Teeth as a band of their height along the middles of their flanks: a quarter as many lines as
    they have, and no place between them; with the back of a rack.
    """
    flanks = [(contour[place] + contour[place + 1]) / 2 for place in range(0, len(contour), 4)]
    band = [_make_stripe(*step) for step in pairwise((*flanks, flanks[0]))]
    back = _make_line(contour[-1], contour[0], TOOTHED.width / 2, COST_FIRM)
    return [*band, back]


def _make_stripe(start: Vector, end: Vector) -> Boxed:
    """A piece of such a band, as high as teeth at any angle: an upright box is widened by the pen
    along both axes.
    """
    across = unit(end - start).turned()
    half = (TOOTH_TIP + TOOTH_ROOT) / 2 / (abs(across.x) + abs(across.y))
    return _make_line(start, end, half, COST_FIRM)


def _split(primitive: Strokes | Outline | Bow) -> Iterable[Segment]:
    match primitive:
        case Strokes():
            return primitive.lines
        case Bow():
            return pairwise(primitive.path())
        case Outline(corners=path, closed=closed):
            closing = path[:1] if closed else ()
            return zip(path, path[1:] + closing, strict=False)
        case _:
            assert_never(primitive)
