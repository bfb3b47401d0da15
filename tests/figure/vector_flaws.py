"""What is wrong with the symbols of arrows in a picture of vectors: one that stands nearer to another
arrow than to its own, without a thin line to its own, is read as the symbol of that other one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeGuard

from shapely import LineString, Point, Polygon, box
from shapely.geometry.base import BaseGeometry

from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import DASHED, FIRM, THIN, Label, Outline, Primitive, Scene, Strokes
from kinegrade.mechanics.vector import Vector

NEARER = 0.2  # millimetres by which a symbol has to be nearer to its own arrow
AT_LABEL, AT_ARROW = 1.2, 0.5  # millimetres from the ends of a leader to what it joins
SAME = 0.02  # millimetres between starts, and sine between directions, of arrows on one line
CORNERS_OF_OUTLINE, CORNERS_OF_HEAD = 7, 3
LONGEST_HEAD = 3.0  # millimetres from the end of a shaft to the tip


@dataclass(frozen=True)
class Drawn:
    """An arrow of a picture: from its start to its tip, and its ink."""

    start: Vector
    tip: Vector
    ink: BaseGeometry

    @property
    def step(self) -> Vector:
        return self.tip - self.start


def find_vector_flaws(scene: Scene, vectors: Iterable[tuple[str, Vector]]) -> list[str]:
    """What is wrong with the symbols of vectors, each with its value, in words."""
    labels = {each.symbol: each for each in scene.labels}
    shown = [(symbol, value) for symbol, value in vectors if symbol in labels]
    arrows = list(list_arrows(scene.primitives))
    if len(arrows) != len(shown):
        return [f"{len(shown)} symbols of {len(arrows)} arrows"]
    return [
        f"{symbol} stands nearer to another arrow than to its own"
        for symbol, own in match_arrows(shown, arrows)
        if _is_mistaken(labels[symbol], own, arrows, scene)
    ]


def list_arrows(primitives: Sequence[Primitive]) -> Iterator[Drawn]:
    """The arrows of vectors in a picture, in the order in which they are drawn."""
    for part, head in pairwise(primitives):
        if isinstance(part, Outline) and len(part.corners) == CORNERS_OF_OUTLINE:
            if part.fill == "none":
                yield _read_outline(part)
        elif _is_shaft(part) and _is_head(head):
            (start, end), tip = part.lines[0], head.corners[0]
            if length(end - tip) > LONGEST_HEAD:
                continue
            yield Drawn(start, tip, LineString([start, end]).union(Polygon(head.corners)))


def _is_shaft(part: Primitive) -> TypeGuard[Strokes]:
    return isinstance(part, Strokes) and part.pen in (FIRM, DASHED) and len(part.lines) == 1


def _is_head(part: Primitive) -> TypeGuard[Outline]:
    """Heads have a thinner line than supports, or none."""
    is_filled = isinstance(part, Outline) and part.fill in ("black", "white")
    return is_filled and len(part.corners) == CORNERS_OF_HEAD and part.pen != FIRM


def _read_outline(outline: Outline) -> Drawn:
    left, right, tip = outline.corners[0], outline.corners[-1], outline.corners[3]
    return Drawn((left + right) / 2, tip, Polygon(outline.corners).boundary)


def match_arrows(
    vectors: Sequence[tuple[str, Vector]], arrows: Sequence[Drawn]
) -> list[tuple[str, Drawn]]:
    """Each symbol with its arrow: the arrows are to one scale."""
    scale = max(length(one.step) for one in arrows) / max(length(value) for _, value in vectors)
    left, found = list(arrows), list[tuple[str, Drawn]]()
    for symbol, value in sorted(vectors, key=lambda each: -length(each[1])):
        own = min(left, key=lambda one: round(length(one.step - value * scale), 1))
        left.remove(own)
        found.append((symbol, own))
    return found


def _is_mistaken(label: Label, own: Drawn, arrows: Sequence[Drawn], scene: Scene) -> bool:
    half = Vector(label.width / 2, label.height / 2)
    place = box(*(label.centre - half), *(label.centre + half))
    if any(_leads(line, place, own, arrows) for line in _list_thin_lines(scene)):
        return False
    return any(
        other is not own
        and place.distance(_part(other, own)) < place.distance(_part(own, other)) + NEARER
        for other in arrows
    )


def _part(one: Drawn, other: Drawn) -> BaseGeometry:
    """The ink of an arrow; of one that goes on where the other ends, on the same line from the same
    point, what goes on.
    """
    along = length(other.start - one.start) < SAME and (
        abs(unit(one.step).cross(unit(other.step))) < SAME and one.step.dot(other.step) > 0
    )
    if not along or length(one.step) <= length(other.step):
        return one.ink
    return LineString([other.tip, one.tip])


def _list_thin_lines(scene: Scene) -> Iterator[tuple[Vector, Vector]]:
    for part in scene.primitives:
        if isinstance(part, Strokes) and part.pen == THIN:
            yield from part.lines


def _leads(
    line: tuple[Vector, Vector], place: BaseGeometry, own: Drawn, arrows: Sequence[Drawn]
) -> bool:
    """Whether a thin line leads from a symbol to its arrow, and to no other."""
    begin, end = map(Point, line)
    if begin.distance(place) > AT_LABEL or end.distance(own.ink) > AT_ARROW:
        return False
    return min(arrows, key=lambda each: end.distance(_part(each, own))) is own
