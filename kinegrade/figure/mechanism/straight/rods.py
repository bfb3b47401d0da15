"""Rods: bodies that translate in a straight guide of the ground."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.figure.joints.drivers import MovingPoint, find_given_motion
from kinegrade.figure.joints.symbol import Guide, Rim, Symbol
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, find_guided_rack, find_half_width
from kinegrade.figure.plane import NEAR, length, mean, nearest_of
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import LEVELS

_ROD = 14.0  # millimetres of a translating rod that are shown at least
_IN_CYLINDER = 18.0  # millimetres of one from its point to the ground of its cylinder at least
# millimetres a translating rod continues beyond its point when it has two free ends
_THROUGH = 11.0
_BESIDE_ARROW = 18.0  # of one beside which the arrow of its motion stands, before its guide
_SAME = 1e-3  # between two unit vectors of one direction
_GUIDE_ROOM = 7.0  # millimetres between the middle of a rod's guide and the edge of a bar or wheel


def find_rods(
    mechanism: Mechanism,
    shapes: Mapping[str, str],
    symbols: Sequence[Symbol],
    found: Sequence[Rim],
    bars: Sequence[Bar],
) -> Iterator[Rod]:
    """The translating rods, none for a rack, each pointing away from the other bodies and long
    enough to keep its guide clear of the bars and wheels.
    """
    circles = [rim.at for rim in found]
    for guide in find_guides_of_rods(symbols):
        if find_guided_rack(guide, bars):
            continue
        others = list_others(mechanism, guide)
        side = guide.along.dot(mean(others + circles) - guide.at)
        toward = guide.along * (-1.0 if side > 0.01 * _ROD else 1.0)
        cylinder = shapes.get(guide.body) == "cylinder"
        size = _IN_CYLINDER if cylinder else _ROD
        reach = size + _find_reach(guide.at, toward, size, bars, found)
        if not cylinder and _has_arrow_along(mechanism, guide, toward):
            reach = max(reach, _BESIDE_ARROW)
        start, end = guide.at, guide.at + toward * reach
        if shapes.get(guide.body) == "through":
            start = start - toward * _THROUGH
        free = () if cylinder else tuple(at for at in (end, start) if at != guide.at)
        yield Rod(guide.body, start, end, free, cylinder)


def _has_arrow_along(mechanism: Mechanism, guide: Guide, toward: Vector) -> bool:
    """Whether a point of a rod is driven in the direction in which the rod leaves it."""
    for driver in mechanism.drivers:
        for level in LEVELS:
            motion = find_given_motion(mechanism.points, driver, level)
            if isinstance(motion, MovingPoint) and motion.toward is not None:
                begins = length(mechanism.points[motion.point] - guide.at) < NEAR
                if begins and length(motion.toward - toward) < _SAME:
                    return True
    return False


def list_others(mechanism: Mechanism, guide: Guide) -> list[Vector]:
    """The points that are not on the body in a guide."""
    names = mechanism.body(guide.body).points
    return [at for name, at in mechanism.points.items() if name not in names]


def find_guides_of_rods(symbols: Sequence[Symbol]) -> Iterator[Guide]:
    """The guides whose body does not turn; of two for one body, the last."""
    level = {symbol.translating for symbol in symbols}
    guides = {symbol.guide.body: symbol.guide for symbol in symbols if symbol.guide}
    yield from (guide for guide in guides.values() if guide.body in level)


def _find_reach(
    start: Vector, toward: Vector, size: float, bars: Sequence[Bar], found: Sequence[Rim]
) -> float:
    """The millimetres by which a rod is longer than usual to keep its guide clear of all bars and
    of the wheels that move; none when no length does.
    """
    wheels = [rim for rim in found if rim.body != GROUND and not rim.ring]
    for more in range(0, 20, 2):
        guide = start + toward * (size - 5.0 + more)
        gaps = [_measure_gap(guide, bar) for bar in bars]
        gaps += [length(guide - wheel.at) - wheel.radius for wheel in wheels]
        if min(gaps, default=_GUIDE_ROOM) >= _GUIDE_ROOM:
            return more
    return 0


def _measure_gap(at: Vector, bar: Bar) -> float:
    """The distance from a point to the edge of a bar."""
    return length(at - nearest_of(at, bar.start, bar.end)) - find_half_width(bar)
