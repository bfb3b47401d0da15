"""The rails of blocks on ground guides: on which side of a guide the ground is, how far it reaches,
and where two of them meet in a corner.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Guide, Symbol, find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.block_sizes import BlockSize, choose_block_size
from kinegrade.figure.mechanism.straight.broad_links import find_frame_place
from kinegrade.figure.mechanism.straight.leaving_bars import (
    Leaving,
    find_opening,
    find_room_before,
    has_bar_through,
    list_leaving,
)
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.plane import NEAR, length, mean, meet, unit
from kinegrade.figure.scene import FIRM
from kinegrade.figure.symbols.sliding import BLOCK_LENGTH
from kinegrade.figure.symbols.teeth import RACK_DEPTH
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_REACH = 7.5  # millimetres of a rail on either side of its block
_SEEN = 2.0  # at least beyond a block: it is seen to run on, even behind a bar
_BEYOND_RACK = 5.0  # millimetres of a guide on either side of the rack in it
_BARE = 0.0  # from the axis of a guide where a bare end slides: the ground is the guide
_LEAST = 0.75  # share of half a block that the ground on both sides of it reaches at least
_BEYOND_BAR = 3.0  # millimetres of the ground beyond a bar that passes through, with its hatching
_CLEAR = 0.3  # millimetres between a rail and a bar
_HALF_STAND = 4.2  # millimetres along a rail between a pin and the end of the rail
_LEVEL_OF_STANDS = 6.0  # millimetres between a guide and a pin whose stand may be in its way
_CORNER = 4.5  # millimetres from a block to a corner at least


class Rail(Struct, frozen=True):
    """The ground along a guide: `at` is the block or bare end on it, `start` and `end` its ends,
    `side` the side of the guide on which it is, and `level` how far from the guide; `crossed` are
    the bars that pass through it, for which it is open, `axes` the directions of axes of a body's
    frame that leave the block across its hatching, and `facing` the ground on the other side of the
    block, where there is some.
    """

    at: Vector
    along: Vector
    side: Vector
    start: Vector
    end: Vector
    level: float
    block: BlockSize | None
    crossed: tuple[Leaving, ...] = ()
    axes: tuple[Vector, ...] = ()
    facing: Rail | None = None

    @property
    def bare(self) -> bool:
        """Whether the end of a bar slides there without a block."""
        return self.block is None

    @property
    def surface(self) -> Line:
        """The line of the ground."""
        return Line(self.at + self.side * self.level, self.along)


def find_rails(anatomy: Anatomy) -> tuple[Rail, ...]:
    """The rail of each block, bare end or rack on a ground guide; two on outer sides meet where
    their guides do.
    """
    rails = []
    for symbol in anatomy.symbols:
        if symbol.guide and symbol.point and not anatomy.is_rod(symbol):
            rack = anatomy.find_rack(symbol)
            rails.append(
                _lay_under_rack(symbol.guide, rack)
                if rack
                else _lay_rail(anatomy, symbol.point, symbol.guide.along, symbol.pinned)
            )
    marked = _find_free_points(anatomy.mechanism.points, anatomy.symbols)
    return tuple(
        _extend(rail, [*rails[:number], *rails[number + 1 :]], marked)
        for number, rail in enumerate(rails)
    )


def _lay_under_rack(guide: Guide, rack: Bar) -> Rail:
    """The ground along the back of a rack and beyond its ends."""
    beyond = unit(rack.end - rack.start) * _BEYOND_RACK
    back = rack.back * (RACK_DEPTH + FIRM.width / 2)
    start, end = rack.start - beyond + back, rack.end + beyond + back
    return Rail(guide.at, guide.along, rack.back, start, end, length(back), None)


def _lay_rail(anatomy: Anatomy, name: str, along: Vector, pinned: bool) -> Rail:
    """Below its block, so that a guide looks alike in all postures; on the other side where a bar
    leaves downward. Where one passes through the block, the ground is open for it if it is steep,
    else on both sides as far as it leaves them free. A wall is on the side away from the mechanism.
    """
    at = anatomy.mechanism.points[name]
    block = choose_block_size(at, anatomy.parts) if pinned else None
    half = (block.length if block else BLOCK_LENGTH) / 2
    level = block.width / 2 + FIRM.width / 2 if block else _BARE
    leaving = list(list_leaving(anatomy.mechanism, anatomy.parts, name))
    sides = _order_sides(anatomy.mechanism, at, along)
    most = _find_room_between_stands(anatomy, name, along)
    reaches = [_find_reaches(along, side, leaving, level, most) for side in sides]
    narrowest = [min(back, ahead) for back, ahead in reaches]
    passing = all(reach != most for reach in reaches) or has_bar_through(leaving, along)
    usual = 1 if not passing and narrowest[1] >= half > narrowest[0] else 0
    side = sides[usual]
    crossed = tuple(each for each in leaving if passing and each[0].dot(side) > NEAR)
    openings = [find_opening(each, along, side, level) for each in crossed]
    if block and any(opening > half for opening in openings):
        most = _find_room_between_stands(anatomy, name, along, max(openings) + _BEYOND_BAR)
        return _lay_both_sides(Rail(at, along, side, at, at, level, block), leaving, min(most))
    back, ahead = most if passing else reaches[usual]
    start, end = _lay_wall(
        at + side * level, along, (max(back, half + _SEEN), max(ahead, half + _SEEN))
    )
    axes = tuple(axis for axis in _list_axes(anatomy, at) if axis.dot(side) > NEAR)
    return Rail(at, along, side, start, end, level, block, crossed, axes)


def _lay_both_sides(rail: Rail, leaving: Sequence[Leaving], most: float) -> Rail:
    """A rail and one like it that faces it, as a slanted bar passes through its block: they end
    before the bar where that leaves them about as long as the block, else they are open for it.
    """
    across = [each for each in leaving if abs(each[0].dot(rail.side)) > NEAR]
    short = min(find_room_before(each, rail.along, rail.side, rail.level) for each in across)
    far = max(find_opening(each, rail.along, rail.side, rail.level) for each in across)
    least = _LEAST * rail.block.length / 2 if rail.block else 0.0
    ends = short >= least or far + _BEYOND_BAR > most
    reach = min(max(short, least), most) if ends else most
    bars = () if ends else tuple(across)
    facing = _lay_side(replace(rail, side=-rail.side, block=None), bars, reach)
    return replace(_lay_side(rail, bars, reach), facing=facing)


def _lay_side(rail: Rail, bars: Sequence[Leaving], reach: float) -> Rail:
    """A rail that reaches so far on either side of its block, with the bars that pass through."""
    start, end = _lay_wall(rail.at + rail.side * rail.level, rail.along, (reach, reach))
    crossed = tuple(each for each in bars if each[0].dot(rail.side) > NEAR)
    return replace(rail, start=start, end=end, crossed=crossed)


def _lay_wall(at: Vector, along: Vector, reach: tuple[float, float]) -> Segment:
    """A straight piece of the ground so far backward and forward from a place."""
    back, ahead = reach
    return at - along * back, at + along * ahead


def _list_axes(anatomy: Anatomy, at: Vector) -> Iterator[Vector]:
    """The directions of the axes of bodies' frames at a place."""
    for frame in anatomy.hints.frames:
        origin, along = find_frame_place(anatomy.mechanism.points, frame)
        if length(origin - at) < NEAR:
            yield from (along, along.turned())


def _order_sides(mechanism: Mechanism, at: Vector, along: Vector) -> tuple[Vector, Vector]:
    """The side of a guide on which the ground usually is, then the other."""
    across = along.turned()
    if abs(across.y) > NEAR:
        return (-across, across) if across.y > 0 else (across, -across)
    away = (at - mean(mechanism.points.values())).dot(across)
    return (-across, across) if away < 0 else (across, -across)


def _find_room_between_stands(
    anatomy: Anatomy, name: str, along: Vector, least: float = 0.0
) -> tuple[float, float]:
    """How far a rail that should reach the `least` may reach backward and forward before it runs
    into the stand of a pin.
    """
    at, reaches = anatomy.mechanism.points[name], [max(_REACH, least)] * 2
    for pin in find_fixed_pins(anatomy.symbols):
        step = anatomy.mechanism.points[pin] - at
        if pin != name and abs(step.cross(along)) < _LEVEL_OF_STANDS:
            ahead = step.dot(along)
            reaches[ahead > 0] = min(reaches[ahead > 0], abs(ahead) - _HALF_STAND)
    return reaches[0], reaches[1]


def _find_reaches(
    along: Vector,
    side: Vector,
    leaving: Sequence[Leaving],
    level: float,
    most: tuple[float, float],
) -> tuple[float, float]:
    """How far a rail may reach backward and forward, not further than `most`, before a bar
    crosses it.
    """
    reaches = list(most)
    for direction, half in leaving:
        down, ahead = direction.dot(side), direction.dot(along)
        if down > NEAR:
            free = (level * abs(ahead) - half - _CLEAR) / down
            reaches[ahead > 0] = min(reaches[ahead > 0], free)
    return reaches[0], reaches[1]


def _find_free_points(points: Mapping[str, Vector], symbols: Sequence[Symbol]) -> list[Vector]:
    """The points of a figure at which there is no support."""
    pins = set(find_fixed_pins(symbols))
    return [at for name, at in points.items() if name not in pins]


def _extend(rail: Rail, others: Sequence[Rail], marked: Sequence[Vector]) -> Rail:
    """The ground on which a bare end slides up to the corner with another, where a marked point is
    the end of both; the guides of blocks cross there without a wall.
    """
    for other in others:
        if not (rail.bare and other.bare and _enclose(rail, other)):
            continue
        crossing = meet(Line(rail.at, rail.along), Line(other.at, other.along))
        if any(length(crossing - at) < NEAR * (1 + length(at)) for at in marked):
            corner = meet(rail.surface, other.surface)
            ahead = (crossing - rail.at).dot(rail.along) > 0
            return replace(rail, end=corner) if ahead else replace(rail, start=corner)
    return rail


def _enclose(rail: Rail, other: Rail) -> bool:
    """Whether either block is on the open side of the other's rail."""
    step = other.at - rail.at
    crossed = abs(rail.along.cross(other.along)) > NEAR
    return crossed and bool(step.dot(rail.side) < -_CORNER and step.dot(other.side) > _CORNER)
