"""Where the extension lines of a dimension begin: beyond what is drawn at their points, and at the
end of a bar that runs in their direction, as the bar shows it up to there.
"""

from __future__ import annotations

from msgspec import Struct

from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.plates import RULED_EDGE, Plate, find_outward_direction
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, find_half_width, list_ways
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.figure.scene import BOLD
from kinegrade.figure.symbols.sliding import measure_in_sleeve
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector

_LEAVING = 1.6  # millimetres from a point to its extension line, where nothing is in the way
# Millimetres around a point in which its support is, in steps, and from there to the line
_SUPPORT, _PROBES, _OUTSIDE = (7.0, 10, 0.5)
# Millimetres of the width in which a line meets a body, and hatching, with more than a gap of it
_MEETS, _HATCHED = 0.2, 1.6
_BODY = 2.9  # millimetres around a point in which the broad body or the sleeve is that it is on
_ALONG = 1e-3  # sine of the angle between a line and a bar that runs along it
# Millimetres between a line and a bar that leaves its point beside it, and to where the line may
# begin therefore: not nearer than where bars have left it usually, nor too far to see whose it is
_OFF_BAR, _NEAR_BY, _FAR_OFF = 0.7, 4.2, 12.0


class Around(Struct, frozen=True):
    """What there is about a dimension: the mechanism, its supports and guides, its bars, its half
    pins, which sit in sleeves, and its ruled plates.
    """

    drawn: Obstacles
    ground: Obstacles
    bars: tuple[Bar | Rod, ...] = ()
    half_pins: tuple[tuple[Vector, Vector], ...] = ()
    plates: tuple[Plate, ...] = ()

    @staticmethod
    def of(drawn: Obstacles, drawing: Drawing) -> Around:
        """A mechanism as obstacles and as it is drawn."""
        bars = tuple(
            part
            for part in drawing.parts
            if isinstance(part, Rod) or (isinstance(part, Bar) and part.use != "slot")
        )
        ruled = tuple(part for part in drawing.parts if isinstance(part, Plate) and part.ruled)
        return Around(drawn, Obstacles.of(drawing.ground), bars, drawing.half_pins, ruled)

    def find_half_width(self, start: Vector, end: Vector) -> float:
        """Half the width of the broad link that is pinned at both points, or what a ruled plate has
        beyond its edge from one to the other; 0 where there is none.
        """
        points = {start, end}
        if self.find_outward(start, end):
            return RULED_EDGE
        broad = (bar for bar in self.bars if isinstance(bar, Bar) and bar.use == "broad")
        return max(
            (find_half_width(bar) for bar in broad if {bar.start, bar.end} == points), default=0.0
        )

    def find_outward(self, start: Vector, end: Vector) -> Vector | None:
        """The direction out of a ruled plate across its edge between two points; None where there
        is none.
        """
        for plate in self.plates:
            if {start, end} <= set(plate.corners):
                return find_outward_direction(plate, Line(start, end - start))
        return None


class Gap(Struct, frozen=True):
    """Millimetres from a point to where its extension line begins, and of those the ones in which
    nothing leads there.
    """

    reach: float
    hidden: float = 0.0

    @property
    def close(self) -> bool:
        """Whether it is not more than what the body takes that the point is on."""
        return self.reach <= _BODY + _OUTSIDE


def find_gap(point: Vector, away: Vector, around: Around) -> Gap:
    """Where an extension line begins: beyond the broad body that the point is on, beyond a support
    that stands there, at the end of a bar along it, and where a bar at a small angle has left it;
    what is drawn farther away it has to cross.
    """
    ways = [way for bar in around.bars for way in list_ways(bar, point) if way.dot(away) > 0]
    along = [length(way) for way in ways if abs(unit(way).cross(away)) < _ALONG]
    if along:
        return Gap(max(along) + _OUTSIDE)
    beside = [(BOLD.width / 2 + _OFF_BAR) / abs(unit(way).cross(away)) for way in ways]
    parting = [reach for reach in beside if _NEAR_BY < reach < _FAR_OFF]
    sides = (side for at, side in around.half_pins if length(at - point) < NEAR)
    corners = [
        end + _OUTSIDE for end in (measure_in_sleeve(away, side) for side in sides) if end > _BODY
    ]
    reach = max(_find_end_of_support(point, away, around), *parting, *corners, 0.0)
    return Gap(reach, 0.0 if reach <= _BODY + _OUTSIDE else reach - _LEAVING)


def _find_end_of_support(point: Vector, away: Vector, around: Around) -> float:
    """How far from a point the body and the support end that are there."""
    (x, y), last = point, _LEAVING
    box = (x - _SUPPORT, y - _SUPPORT, x + _SUPPORT, y + _SUPPORT)
    near, support = around.drawn.near(box), around.ground.near(box)
    pace = _SUPPORT / _PROBES
    for step in range(1, _PROBES + 1):
        reach = pace * step
        at = (x + away.x * reach, y + away.y * reach)
        in_way = near if reach < _BODY else support
        if in_way.under_box(*at, _MEETS, _MEETS) > 0:
            last = max(last, reach + _OUTSIDE)
        elif reach > _BODY and support.under_box(*at, _HATCHED, _HATCHED) > 0:
            last = max(last, reach - pace + _OUTSIDE)
    return last
