"""What is wrong with the symbols of rotations in a printed picture: one that is nearer to a pin
than to its own curved arrow, on the other side of the rim of a wheel, or at the symbol of another.

An angular velocity has one head and the letter omega or n, an angular acceleration two and alpha.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from tests.figures.dimension_flaws import find_ends
from tests.figures.svg_shapes import Letters, Picture

SHAFT = (0.3, 0.5)  # millimetres, the width of a shaft
LONG = (4.0, 12.0)  # millimetres of a shaft along its arc
BENT = 0.8  # share of the box about a shaft up to which it is curved
AT_HEAD = 0.8  # millimetres between a shaft and the back of each of its heads
AT_RIM = 0.5  # millimetres within a rim, or without, at which an arrow lies on it
APART = 1.5  # millimetres between the symbols of two arrows, at least
HEADS = {"ω": 1, "n": 1, "α": 2}


@dataclass(frozen=True)
class CurvedArrow:
    """The ink of a curved shaft, and how many heads it has."""

    shaft: BaseGeometry
    heads: int


def find_turning_flaws(picture: Picture) -> list[str]:
    """What is wrong with the symbols of rotations, in words."""
    arrows = list(find_curved_arrows(picture))
    flaws = [
        flaw for letters in picture.letters for flaw in _find_flaws_of(letters, arrows, picture)
    ]
    symbols = [each for each in picture.letters if each.text[:1] in HEADS] if arrows else []
    return flaws + [
        f"{one.text} stands at {other.text}"
        for one, other in combinations(symbols, 2)
        if one.box.distance(other.box) < APART
    ]


def _find_flaws_of(letters: Letters, arrows: list[CurvedArrow], picture: Picture) -> Iterator[str]:
    heads = HEADS.get(letters.text[:1]) if "·" not in letters.text else None
    own = [arrow for arrow in arrows if arrow.heads == heads]
    if not own:
        return
    nearest = min(own, key=lambda arrow: letters.box.distance(arrow.shaft))
    gap = letters.box.distance(nearest.shaft)
    if any(letters.box.distance(pin) < gap for pin in picture.pins):
        yield f"{letters.text} is nearer to a pin than to its own arrow"
    for wheel in map(Polygon, picture.rims):
        sides = wheel.buffer(-AT_RIM), wheel.buffer(AT_RIM)
        inside, outside = letters.box.within(sides[0]), letters.box.disjoint(sides[1])
        shaft = nearest.shaft
        if (inside and shaft.disjoint(sides[1])) or (outside and shaft.within(sides[0])):
            yield f"{letters.text} is cut off from its own arrow by a rim"


def find_curved_arrows(picture: Picture) -> Iterator[CurvedArrow]:
    """The curved arrows of rotations."""
    ends = [find_ends(head) for head in picture.heads]
    for ink in picture.ink:
        if _is_curved_shaft(ink):
            tips = [tip for tip, neck in ends if ink.distance(neck) < AT_HEAD]
            if tips:
                yield CurvedArrow(ink, len(tips))


def _is_curved_shaft(ink: BaseGeometry) -> bool:
    """Whether some ink is a strip as wide as a shaft that is not straight."""
    size = ink.length / 2
    if not LONG[0] < size < LONG[1] or not SHAFT[0] * size < ink.area < SHAFT[1] * size:
        return False
    return bool(ink.area < BENT * ink.minimum_rotated_rectangle.area)
