"""What is wrong with the straight arrows of motions in a printed picture: a symbol nearer to
another arrow than to its own, or just past the tip of another one, or beyond a bar.

A velocity has one head and the letter v, an acceleration two and the letter a.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from shapely import LineString, Point, shortest_line
from shapely.geometry.base import BaseGeometry

from tests.figures.dimension_flaws import find_ends, find_extension_lines
from tests.figures.svg_shapes import Letters, Picture

SHAFT = (0.38, 0.45)  # millimetres, the width of a shaft
LONG = (5.0, 20.0)  # millimetres of a shaft
AT_NECK = 0.5  # millimetres between the end of a shaft and the back of its head
SECOND = (1.4, 1.8)  # millimetres from one tip to the next behind it
BEYOND = 3.0  # millimetres past a tip that are the arrow's own
NEAR = 6.0  # millimetres within which another arrow may be mistaken
BAR = 0.6, 5.0  # millimetres: least width and length of a bar
UNDER = 0.25, 2.0  # millimetres beside a shaft, and of a line there that is not told apart from it
HEADS = {"v": 1, "a": 2}


@dataclass(frozen=True)
class Arrow:
    """The line from a tail to a tip, how many heads it has, and the line past its tip."""

    line: LineString
    heads: int
    past: LineString


def find_arrow_flaws(picture: Picture) -> list[str]:
    """What is wrong with the symbols of straight motions, in words."""
    arrows = list(find_arrows(picture))
    bars = [ink for ink in picture.ink if _is_bar(ink)]
    flaws = [flaw for letters in picture.letters for flaw in _find_flaws_of(letters, arrows)]
    return [*flaws, *(flaw for each in picture.letters for flaw in _find_cut(each, arrows, bars))]


def find_arrows_on_dimensions(picture: Picture) -> list[str]:
    """The arrows along extension lines of dimensions, of which they would seem to be a part."""
    lines = list(find_extension_lines(picture))
    return [
        f"an arrow to ({x:.1f}, {y:.1f}) lies on the line of a dimension"
        for arrow in find_arrows(picture)
        for x, y in arrow.line.coords[-1:]
        if any(line.intersection(arrow.line.buffer(UNDER[0])).length > UNDER[1] for line in lines)
    ]


def _find_cut(
    letters: Letters, arrows: Sequence[Arrow], bars: Sequence[BaseGeometry]
) -> Iterator[str]:
    """Whether a bar passes between a symbol and its arrow."""
    own = [arrow.line for arrow in arrows if arrow.heads == HEADS.get(letters.text[:1])]
    if own:
        nearest = min(own, key=letters.box.distance)
        way = shortest_line(letters.box.centroid, nearest)
        if any(bar.intersects(way) and not bar.intersects(nearest) for bar in bars):
            yield f"{letters.text} is cut off from its own arrow by a bar"


def _is_bar(ink: BaseGeometry) -> bool:
    """Whether some ink is a strip as wide as a bar."""
    size = ink.length / 2
    return bool(size > BAR[1] and BAR[0] * size < ink.area < size)


def _find_flaws_of(letters: Letters, arrows: Sequence[Arrow]) -> Iterator[str]:
    heads = HEADS.get(letters.text[:1])
    own = [arrow for arrow in arrows if arrow.heads == heads]
    if not heads or not own:
        return
    gap = min(letters.box.distance(arrow.line) for arrow in own)
    for other in arrows:
        away = letters.box.distance(other.line)
        if other.heads != heads and away < min(gap - 0.05, NEAR):
            yield f"{letters.text} is nearer to another arrow than to its own"
        elif other.heads != heads and letters.box.intersects(other.past) and gap > 1.0:
            yield f"{letters.text} stands past the tip of another arrow"


def find_arrows(picture: Picture) -> Iterator[Arrow]:
    """The straight arrows with the heads of motions."""
    ends = [find_ends(head) for head in picture.heads]
    for tip, neck in ends:
        shafts = [line for line in map(_read_shaft, picture.ink) if line]
        for shaft in shafts:
            tail, front = sorted(map(Point, shaft.coords), key=tip.distance, reverse=True)
            if front.distance(neck) < AT_NECK and LineString([tail, tip]).distance(neck) < 0.1:
                behind = [each for each, _ in ends if SECOND[0] < each.distance(tip) < SECOND[1]]
                heads = 1 + any(LineString([tail, tip]).distance(each) < 0.1 for each in behind)
                size = tail.distance(tip)
                step = ((tip.x - tail.x) / size * BEYOND, (tip.y - tail.y) / size * BEYOND)
                past = LineString([tip, (tip.x + step[0], tip.y + step[1])])
                yield Arrow(LineString([tail, tip]), heads, past)


def _read_shaft(ink: BaseGeometry) -> LineString | None:
    """The middle of a strip as wide as a shaft."""
    if not 1.5 < ink.area < 10.0:
        return None
    corners = list(ink.minimum_rotated_rectangle.exterior.coords)
    sides = [LineString(corners[place : place + 2]) for place in (0, 1)]
    short, long = sorted(sides, key=lambda side: side.length)
    if not SHAFT[0] < short.length < SHAFT[1] or not LONG[0] < long.length < LONG[1]:
        return None
    opposite = LineString(corners[2:4]) if short == sides[0] else LineString(corners[3:5])
    return LineString([short.centroid, opposite.centroid])
