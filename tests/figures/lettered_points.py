"""What is wrong with the letters of points in a printed picture: a letter far from its pin, or on
the far side of hatching or of a rim, where it seems to name something else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from shapely import LineString, Point

from tests.figures.svg_shapes import Letters, Picture

FAR, LED = 6.5, 8.0  # millimetres from a letter to its point at most, and with a leader
AT_LETTER, AT_POINT = 1.6, 2.0  # millimetres of paper at the two ends of a leader
WITHIN = 3.0  # millimetres inside a rim from which on a point is away from it
CLOSED = 0.65  # millimetres about the strokes of hatching, which close the gaps between them
ON_GROUND = 1.95  # millimetres from hatching to a point on the ground itself, or on its teeth


def find_letter_flaws(picture: Picture, points: Mapping[str, Point]) -> list[str]:
    """What is wrong with the letters of marked points, in words."""
    far, parted = list(_find_far(picture, points)), _find_parted(picture, points)
    lost = {flaw.split()[0] for flaw in far}
    return [*far, *(flaw for flaw in parted if flaw.split()[0] not in lost)]


def _find_far(picture: Picture, points: Mapping[str, Point]) -> Iterator[str]:
    """Letters that stand too far from their points to be read as theirs."""
    for each in picture.letters:
        point = points.get(each.text)
        if point is not None:
            farthest = LED if _has_leader(each, point, picture) else FAR
            if each.box.distance(point) > farthest:
                yield f"{each.text} far from its point"


def _find_parted(picture: Picture, points: Mapping[str, Point]) -> Iterator[str]:
    for each in picture.letters:
        point = points.get(each.text)
        if point is not None and not _has_leader(each, point, picture):
            if _stands_behind_hatching(each, point, picture):
                yield f"{each.text} stands behind hatching"
            elif _stands_outside(each, point, picture):
                yield f"{each.text} stands outside the wheel of its point"


def _has_leader(letter: Letters, point: Point, picture: Picture) -> bool:
    for line in picture.lines:
        for one, other in ((0, 1), (1, 0)):
            start, end = Point(line.coords[one]), Point(line.coords[other])
            near = letter.box.distance(start) < AT_LETTER
            if near and end.distance(point) < AT_POINT < start.distance(point):
                return True
    return False


def _stands_behind_hatching(letter: Letters, point: Point, picture: Picture) -> bool:
    """Whether hatching lies between a letter and its point."""
    way = LineString([point, letter.box.centroid])
    return any(
        each.distance(point) > ON_GROUND and each.buffer(CLOSED).intersects(way)
        for each in picture.hatchings
    )


def _stands_outside(letter: Letters, point: Point, picture: Picture) -> bool:
    """Whether a letter is beyond the rim of a wheel in which its point lies."""
    wheels = [rim.convex_hull for rim in picture.rims]
    return any(
        wheel.buffer(-WITHIN).contains(point) and not wheel.contains(letter.box.centroid)
        for wheel in wheels
    )
