"""What is wrong with the supports of a printed picture: hatching that cuts the rim of a wheel."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from shapely.geometry.base import BaseGeometry

from tests.figures.svg_shapes import Picture

WIDE = 7.0  # millimetres across the hatching of a support at most; that of a floor is longer
OFF_RIM = 0.4  # millimetres from hatching to the line of a rim, at least


def find_support_flaws(picture: Picture) -> list[str]:
    """What is wrong with supports, in words."""
    return list(_find_cut_rims(picture))


def _find_cut_rims(picture: Picture) -> Iterator[str]:
    """Supports whose hatching reaches the rim of a wheel: it belongs inside, or clearly outside."""
    for hatching in filter(is_of_support, picture.hatchings):
        if any(rim.distance(hatching) < OFF_RIM for rim in picture.rims):
            x, y = hatching.centroid.coords[0]
            yield f"hatching cuts a rim at ({x:.1f}, {y:.1f})"


def is_of_support(hatching: BaseGeometry) -> bool:
    """Whether hatching is that of a support, and not of a floor or a guide."""
    left, top, right, bottom = hatching.bounds
    return hypot(right - left, bottom - top) < WIDE
