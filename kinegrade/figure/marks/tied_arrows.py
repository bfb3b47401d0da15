"""The arrow of a bar that turns among round bodies, which could own it as well: its tail on the
bar, or within a ring ahead of the disc at the end of the bar, on the circle on which that is
carried round.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from math import asin, copysign

from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.turning_arrow import TurningArrow
from kinegrade.figure.marks.turning_radii import ROOMY
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.plane import NEAR, angle_of, length, polar
from kinegrade.figure.scene import THIN, Bow, Strokes
from kinegrade.figure.teeth import TOOTH_TIP
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Turning

# Radii, and millimetres from a tail to the pin at the end of the bar
_RADII, _SHORT_OF_PIN = tuple(5.0 + 1.5 * step for step in range(24)), 3.0
_FARTHER_OUT = 0.1  # demerit of each millimetre farther out
# Shares of the usual length of an arrow on a bar, and the demerits of shorter ones
_SHARES = (1.0, 0.0), (0.8, 2.0)
# Demerit of an arrow out of a disc about the pivot that has room for it, far from that
_OUT_OF_DISC = 12.0
# Millimetres between two arrows on a bar, and the demerit of the first where the second has no room
_ROOM, _IN_THE_WAY = 6.5, 8.0
# Millimetres between an arrow and the disc of another body, and those from the disc at the end of
# a bar to the tail of an arrow ahead of it
_OFF_DISC, _AHEAD = 1.0, 2.0
_HATCHED = 3.0  # millimetres within the rim of a fixed disc that its hatching takes
# Millimetres between the circle of that disc's centre and the arrow, and the demerit of each
_SHIFTS, _SHIFTED = (0.0, 1.5, -1.5, 3.0, -3.0), 0.3
# Demerit of an arrow whose tail is so many millimetres from where a line meets the bar, or less
_MEETS, _AT_TAIL = 12.0, 2.0
_CROSSES = 2.0  # demerit of what a crossed line costs
_STATIONS = 0.2  # radians between the points of an arrow that are looked at
_ONWARD, _FARTHER_ON = (0.0, 0.4, 0.8, 1.2, 1.6), 5.0  # radians farther ahead, demerit of each
_OFF_BAR = 12.0  # demerit of an arrow ahead of a disc: one on the bar is at its pivot


def list_tied_arrows(
    hint: Turning, centre: Vector, shaft: float, drawing: Drawing, *, followed: bool = False
) -> list[TurningArrow]:
    """Arrows about a centre, so many millimetres long, positive counter-clockwise, that show which
    bar turns; none where no other body is a circle about the centre. One that is `followed` by
    another of its bar leaves that room.
    """
    others = [rim for rim in drawing.rims if rim.body != hint.body]
    if not any(length(rim.at - centre) < NEAR for rim in others):
        return []
    bars = (part for part in drawing.parts if isinstance(part, Bar) and part.body == hint.body)
    ends = (end for bar in bars for end in (bar.start, bar.end))
    steps = [end - centre for end in ends if length(end - centre) > NEAR]
    discs = [rim for rim in others if not rim.ring and length(rim.at - centre) > NEAR]
    about = [
        rim.radius - _HATCHED * (rim.body == GROUND)
        for rim in others
        if not rim.ring and length(rim.at - centre) < NEAR
    ]
    roomy = [size for size in about if size > ROOMY]
    tied: Iterable[TurningArrow] = _list_on_bars(hint, centre, shaft, steps, roomy)
    if followed:
        tied = [replace(arrow, demerit=arrow.demerit + _rate_room(arrow)) for arrow in tied]
    within = any(rim.ring and length(rim.at - centre) < NEAR for rim in others)
    turning = turns_among_bodies(hint, centre, drawing)
    ahead = _list_ahead(hint, centre, shaft, steps, discs) if within and turning else ()
    lines = (part for part in drawing.primitives if isinstance(part, Strokes) and part.pen == THIN)
    thin = Obstacles.of(lines)
    return [
        replace(arrow, demerit=arrow.demerit + _rate_crossings(arrow, thin))
        for arrow in (*tied, *ahead)
        if not _touches(arrow.bow, discs)
    ]


def turns_among_bodies(hint: Turning, centre: Vector, drawing: Drawing) -> bool:
    """Whether a circle of another body that may turn as well is about the centre of an arrow."""
    others = (rim for rim in drawing.rims if rim.body not in (hint.body, GROUND))
    return any(length(rim.at - centre) < NEAR for rim in others)


def _rate_crossings(arrow: TurningArrow, thin: Obstacles) -> float:
    """How much worse an arrow is for the thin lines, like those of belts, that it crosses, or that
    meet its bar at its tail.
    """
    along = polar(arrow.bow.start)
    tail = arrow.bow.centre + along * arrow.bow.radius
    beside = ((tail - along * _AT_TAIL, tail + along * _AT_TAIL),)
    meets = arrow.tied and thin.along(beside, shared=True) > 0
    return _CROSSES * thin.along(arrow.path(), arrow.shared) + _MEETS * meets


def _rate_room(arrow: TurningArrow) -> float:
    """The demerit of an arrow that is neither at its pivot nor clear of one there."""
    return _IN_THE_WAY * (_RADII[0] < arrow.bow.radius < _RADII[0] + _ROOM)


def _list_on_bars(
    hint: Turning,
    centre: Vector,
    shaft: float,
    steps: Iterable[Vector],
    discs: Sequence[float],
) -> Iterator[TurningArrow]:
    """Arrows with their tails on a bar, rather in the discs of those radii about the pivot."""
    for step in steps:
        for radius, (share, worse) in product(_RADII, _SHARES):
            if radius < length(step) - _SHORT_OF_PIN:
                bow = Bow(centre, radius, angle_of(step), share * shaft / radius, THIN)
                out = _OUT_OF_DISC * any(radius > disc - _OFF_DISC for disc in discs)
                yield TurningArrow(bow, hint, worse + _FARTHER_OUT * radius + out, tied=True)


def _list_ahead(
    hint: Turning, centre: Vector, shaft: float, steps: Iterable[Vector], discs: Sequence[Rim]
) -> Iterator[TurningArrow]:
    """Arrows ahead of the disc at the end of a bar, on the circle of its centre."""
    for step in steps:
        for disc in (disc for disc in discs if length(disc.at - centre - step) < NEAR):
            gap = 2 * asin(min(1.0, (disc.radius + TOOTH_TIP + _AHEAD) / (2 * length(step))))
            for onward in _ONWARD:
                start = angle_of(step) + copysign(gap + onward, shaft)
                for shift in _SHIFTS:
                    radius = length(step) + shift
                    bow = Bow(centre, radius, start, shaft / radius, THIN)
                    demerit = _OFF_BAR + _SHIFTED * abs(shift) + _FARTHER_ON * onward
                    yield TurningArrow(bow, hint, demerit)


def _touches(bow: Bow, discs: Iterable[Rim]) -> bool:
    """Whether an arrow is in a disc or close to it, as if that turned."""
    points = bow.path(_STATIONS)
    return any(length(at - disc.at) < disc.radius + _OFF_DISC for disc in discs for at in points)
