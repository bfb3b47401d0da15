"""The sides of an angle: bars or the ground where these run along them, else thin lines."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.drawn import measure_drawn, measure_pin
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, is_slender
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import NEAR, angle_of, length, on_line, polar, unit
from kinegrade.figure.scene import BOLD, FIRM, THIN, Disc, Primitive, Strokes
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.figure.symbols.pins import PIN
from kinegrade.figure.symbols.sliding import BLOCK_IN_SLOT
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle

# Millimetres that a thin line along a side continues beyond the arc, and where a leader passes it
_BEYOND, SHORT = 2.5, 1.0
_DOUBLE = 1.2  # millimetres within which the ground and a line along it would look like one
LEFT = 4.2  # millimetres from a vertex in which its own bars leave beside a side
_LEAST_PART = 1.0  # millimetres of an axis that is seen as a line between two things that cover it
_OFF_AXIS = 0.4  # millimetres between an axis and the middle of the outline at which it stops
_AT_PIN = 0.15  # millimetres from the radius of a pin to where a line ends on the edge of it

Span = tuple[float, float]  # millimetres along a side from its vertex


class Side(Struct, frozen=True):
    """A side of an angle: its direction, how far a bar is drawn along it, how far away the point
    on it is (0 for none), whether the bar is so broad that its axis has to be drawn, how far
    outside the angle the ground runs that takes the place of a line, how far a line goes `beyond`
    the arc, how far the arrow of a motion is likely to hide it, how far the open pins reach
    that are where the bar ends and at the point on the side, between which millimetres the axis
    of a broad bar is `covered` by a pin or a block, and whether such a bar is `edged` by straight
    black lines.
    """

    angle: float
    drawn: float
    reach: float
    broad: bool
    lag: float
    beyond: float = _BEYOND
    hidden: float = 0.0
    pins: tuple[float, float] = (0.0, 0.0)
    covered: tuple[Span, ...] = ()
    edged: bool = False

    @property
    def half(self) -> float:
        """Half the width in millimetres of what is drawn along it."""
        return BAR_WIDTH / 2 if self.broad else (BOLD if self.drawn else THIN).width / 2

    def line(self, vertex: Vector, radius: float) -> Segment | None:
        """The thin line that an arc of this radius needs; None when the bar is long enough."""
        toward = polar(self.angle)
        if self.broad:
            return vertex + toward * (PIN + _AT_PIN), vertex + toward * (radius + self.beyond)
        if radius < self.drawn + PIN:
            return None
        needed = radius + (1.0 if self.reach else self.beyond)
        far = needed if self.drawn else max(needed, self.reach)
        far -= self.pins[1] if far == self.reach else 0.0
        return vertex + toward * max(
            self.drawn + self.pins[0], PIN + _AT_PIN
        ), vertex + toward * far

    def list_seen(self, vertex: Vector, radius: float) -> Iterator[Segment]:
        """The parts of its line that are not covered."""
        line = self.line(vertex, radius)
        if line is None:
            return
        if not self.covered:
            yield line
            return
        toward = polar(self.angle)
        begin, far = ((end - vertex).dot(toward) for end in line)
        for span in (*sorted(self.covered), (far, far)):
            first, last = span
            end = min(first, far)
            if end - begin > _LEAST_PART:
                yield vertex + toward * begin, vertex + toward * end
            begin = max(begin, last)


def find_sides(at: Mapping[str, Vector], hint: Angle, drawing: Drawing) -> tuple[Side, ...]:
    """The first and the last side of an angle."""
    vertex = at[hint.at]
    ways = [unit(direction(at, vertex, name)) for name in (hint.start, hint.end)]
    legs = []
    for name, way, other in zip((hint.start, hint.end), ways, reversed(ways), strict=True):
        ground, lag = _measure_ground(vertex, way, other, drawing)
        drawn = max(ground, measure_drawn(vertex, way, drawing))
        reach = length(at[name] - vertex) if name in at else 0.0
        pins = (
            _reach_pin(vertex + way * drawn, drawing),
            _reach_pin(vertex + way * reach, drawing),
        )
        bars = _find_broad_bars(vertex, way, drawing)
        broad, edged = bool(bars), any(bar.use != "rack" for bar in bars)
        covered = tuple(_list_covered(vertex, way, drawing)) if broad else ()
        side = Side(angle_of(way), drawn, reach, broad, lag, pins=pins, covered=covered)
        legs.append(replace(side, edged=edged))
    return tuple(legs)


def _list_covered(vertex: Vector, toward: Vector, drawing: Drawing) -> Iterator[Span]:
    """Where the open pins and the blocks on the axis of a broad bar are, but for the pin at its
    vertex, on whose edge its line begins.
    """
    axis = Line(vertex, toward)
    for at, half in _list_covering(drawing):
        if on_line(at, axis) and length(at - vertex) > NEAR:
            middle = (at - vertex).dot(toward)
            reach = half + _OFF_AXIS
            yield middle - reach, middle + reach


def _list_covering(drawing: Drawing) -> Iterator[tuple[Vector, float]]:
    """The middles of open pins and of blocks in slots, with half their sizes."""
    for part in drawing.primitives:
        if isinstance(part, Disc) and part.fill == "white":
            yield part.centre, part.radius
    for symbol in drawing.symbols:
        if symbol.block:
            yield symbol.block.point, BLOCK_IN_SLOT / 2


def _reach_pin(at: Vector, drawing: Drawing) -> float:
    """How far, in millimetres, a line on a pin stays from its middle; 0 where there is no pin."""
    radius = measure_pin(at, drawing)
    return radius + _AT_PIN if radius else 0.0


def hide_sides(
    sides: Iterable[Side], vertex: Vector, arrows: Sequence[Segment], drawn: Iterable[Primitive]
) -> tuple[Side, ...]:
    """The sides of an angle with how far arrows from its vertex hide them, except where what is
    drawn shows a side farther out than the arrow.
    """
    thin = (each for each in drawn if isinstance(each, Strokes) and each.pen == THIN)
    lines = [line for strokes in thin for line in strokes.lines]
    hidden = []
    for side in sides:
        toward = polar(side.angle)
        over = max((_measure_along(vertex, toward, arrow) for arrow in arrows), default=0.0)
        seen = max((_measure_along(vertex, toward, line) for line in lines), default=0.0)
        hidden.append(replace(side, hidden=over if over > seen - LEFT else 0.0))
    return tuple(hidden)


def _measure_along(vertex: Vector, toward: Vector, line: Segment) -> float:
    """How far, in millimetres, a line from near a vertex lies on a side in a direction."""
    steps = [end - vertex for end in line]
    if any(abs(step.cross(toward)) >= NEAR for step in steps):
        return 0.0
    near, far = sorted(map(toward.dot, steps))
    return far if near < LEFT else 0.0


def _find_broad_bars(vertex: Vector, toward: Vector, drawing: Drawing) -> list[Bar]:
    """The bars that are drawn from a point in a direction; none where one of them is slender."""
    bars = [bar for bar, reach in _list_bars_along(vertex, toward, drawing) if reach > PIN]
    return [] if any(map(is_slender, bars)) else bars


def _measure_ground(
    vertex: Vector, toward: Vector, other: Vector, drawing: Drawing
) -> tuple[float, float]:
    """How far the ground runs along a side of an angle, on it or just outside the angle, and how
    far outside; 0 and 0 where it does not.
    """
    outward = toward.turned() if toward.turned().dot(other) <= 0 else -toward.turned()
    firm = (each for each in drawing.primitives if isinstance(each, Strokes) and each.pen == FIRM)
    for line in (line for strokes in firm for line in strokes.lines):
        near, far = sorted((end - vertex for end in line), key=toward.dot)
        gap, level = near.dot(toward), near.dot(outward)
        parallel = abs(far.dot(outward) - level) < NEAR
        if parallel and -NEAR < level < _DOUBLE and gap < LEFT < far.dot(toward):
            return far.dot(toward), max(0.0, level)
    return 0.0, 0.0


def _list_bars_along(
    vertex: Vector, toward: Vector, drawing: Drawing
) -> Iterator[tuple[Bar, float]]:
    """The bars through a point on a line, with how far they go beyond it in a direction."""
    for bar in drawing.parts:
        if isinstance(bar, Bar) and on_line(vertex, Line(bar.start, bar.end - bar.start)):
            steps = [end - vertex for end in (bar.start, bar.end)]
            along = abs(unit(steps[0] - steps[1]).cross(toward)) < NEAR
            reaches = [step.dot(toward) for step in steps]
            if along and min(reaches) < 1.0:
                yield bar, max(reaches)
