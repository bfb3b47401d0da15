"""The rails of blocks on ground guides: on which side of a guide the ground is, how far it reaches,
and where two of them meet in a corner.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from kinegrade.figure.joints.symbol import Symbol, find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.plane import NEAR, length, mean, meet, unit
from kinegrade.figure.scene import BOLD, FIRM
from kinegrade.figure.symbols import BLOCK_LENGTH, BLOCK_WIDTH
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_REACH = 7.5  # millimetres of a rail on either side of its block
_FREE = BLOCK_LENGTH / 2 + 0.2  # at least without a bar in front of it: the block is on it
_LEAST = BLOCK_LENGTH / 2 + 2.0  # at least: it is seen to run on, even behind a bar
_LEVEL = BLOCK_WIDTH / 2 + FIRM.width / 2  # from the axis of a guide to its rail
_BARE = BOLD.width / 2 + FIRM.width / 2  # the same where the end of a bar slides without a block
_CLEAR = 0.3  # millimetres between a rail and a bar
_CORNER = 4.5  # millimetres from a block to a corner at least


@dataclass(frozen=True)
class Rail:
    """The ground along a guide: a block or a bare end at `at` on it, its ends, the side of the
    guide on which it is, and how far from the guide.
    """

    at: Vector
    along: Vector
    side: Vector
    start: Vector
    end: Vector
    level: float

    @property
    def bare(self) -> bool:
        """Whether there is no block."""
        return self.level < _LEVEL

    @property
    def surface(self) -> Line:
        """The line of the ground."""
        return Line(self.at + self.side * self.level, self.along)


def find_rails(anatomy: Anatomy) -> tuple[Rail, ...]:
    """The rail of each block or bare end on a ground guide; two on outer sides meet where their
    guides do.
    """
    mechanism = anatomy.mechanism
    rails = [
        _lay_rail(mechanism, symbol.point, symbol.guide.along, _LEVEL if symbol.pinned else _BARE)
        for symbol in anatomy.symbols
        if symbol.guide and symbol.point and not anatomy.is_rod(symbol)
    ]
    marked = _find_free_points(mechanism.points, anatomy.symbols)
    return tuple(
        _extend(rail, [*rails[:number], *rails[number + 1 :]], marked)
        for number, rail in enumerate(rails)
    )


def _lay_rail(mechanism: Mechanism, name: str, along: Vector, level: float) -> Rail:
    """Below its block, so that a guide looks alike in all postures; on the other side where a bar
    leaves downward. A wall is on the side away from the mechanism.
    """
    at = mechanism.points[name]
    leaving = list(_list_leaving(mechanism, name))
    across = along.turned()
    if abs(across.y) > NEAR:
        sides = (-across, across) if across.y > 0 else (across, -across)
    else:
        away = (at - mean(mechanism.points.values())).dot(across)
        sides = (-across, across) if away < 0 else (across, -across)
    side = max(sides, key=lambda side: min(_find_reaches(along, side, leaving)) >= _FREE)
    back, ahead = (max(reach, _LEAST) for reach in _find_reaches(along, side, leaving))
    base = at + side * level
    return Rail(at, along, side, base - along * back, base + along * ahead, level)


def _list_leaving(mechanism: Mechanism, name: str) -> Iterator[Vector]:
    """The directions from a point to the other points of its bodies."""
    at = mechanism.points[name]
    for body in mechanism.bodies:
        if name in body.points:
            others = (mechanism.points[point] - at for point in body.points)
            yield from (unit(step) for step in others if length(step) > NEAR)


def _find_reaches(along: Vector, side: Vector, leaving: Sequence[Vector]) -> tuple[float, float]:
    """How far a rail may reach backward and forward before a bar crosses it."""
    reaches = [_REACH, _REACH]
    for direction in leaving:
        down, ahead = direction.dot(side), direction.dot(along)
        if down > NEAR:
            level = _LEVEL - _CLEAR - BOLD.width / 2
            free = level * abs(ahead) / down
            reaches[ahead > 0] = min(reaches[ahead > 0], free)
    return reaches[0], reaches[1]


def _find_free_points(points: Mapping[str, Vector], symbols: Sequence[Symbol]) -> list[Vector]:
    """The points of a figure at which there is no support."""
    pins = set(find_fixed_pins(symbols))
    return [at for name, at in points.items() if name not in pins]


def _extend(rail: Rail, others: Sequence[Rail], marked: Sequence[Vector]) -> Rail:
    """The rail up to the corner with another, where a marked point is the end of both guides."""
    for other in others:
        if not _enclose(rail, other):
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
