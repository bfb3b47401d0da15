"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from string import ascii_lowercase
from types import MappingProxyType

from msgspec.structs import replace

from kinegrade.figure.mechanism.fitting import make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish, list_spots_around, rate_nearness
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, put_side_by_side
from kinegrade.figure.vectors.chains import (
    Arrow,
    find_corners,
    find_scale,
    measure_spans,
    round_scale,
)
from kinegrade.figure.vectors.leaders import NOTHING, ONE_ARROW, write_symbol
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.mechanics.vector import Vector

_NEGLIGIBLE = 0.01  # of the longest vector: shorter ones are not drawn
_OFFSETS = (2.0, -6.0, 8.0, -12.0, 14.0)  # millimetres between arrows that would lie on one another
_NEXT = 2.51  # times a round number, the next one is not above it
_LEAST = 10.0  # millimetres: no polygon is made smaller than this, whatever its symbols take
_ORIGINS = ("o", "p")  # letters of the origin: another where it is that of a corner
# Letters of the other corners: usual ones first, none that is an origin's or a vector's
SPARE = tuple("nkqsuw" + "".join(sorted(set(ascii_lowercase) - set("nkqsuwavop"))))
CLOSE = 2.0  # millimetres: letters of corners that close would stand in a heap
_MISTAKEN = 20.0  # demerit of a letter that may be read as that of another corner
_TRIES = 4  # orders in which the symbols are placed
_SAME = 0.05  # millimetres within which two corners coincide
_ZERO = Vector(0.0, 0.0)


@dataclass(frozen=True)
class _Names:
    """The letters of corners, and those that are left for the others."""

    vertices: Mapping[str, Vector]
    spare: tuple[str, ...]


def draw_polygon(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector] = MappingProxyType({}),
    scale: float | None = None,
    spare: Sequence[str] = SPARE,
) -> Scene:
    """The polygon of "sum of `left` = sum of `right`" from the common origin o.

    Known vectors are solid with a filled head, unknown ones dashed with an open head. Vectors
    shorter than a hundredth of the longest are not drawn. The vectors of a side follow one another
    as they are given; those that would run along another are drawn beside it, with thin lines to
    their true positions. `vertices` are letters (LaTeX math) for the tips of vectors from the
    origin; the other corners have `spare` ones, unless a letter stands there already. The scale of
    the scene is millimetres per m/s (or m/s^2), a round number: `scale`, that of other polygons,
    unless this one would be too large or too small, or its symbols have no place at it. The figure
    is within PICTURE of `plain_mechanism`.
    """
    names = _Names(vertices, tuple(letter for letter in spare if letter not in vertices))
    across, upward = measure_spans(left, right)
    if across + upward == 0.0:
        return _fit(left, right, names, 1.0, 0.0)
    largest = find_scale(left, right)
    common = min(scale or largest, largest)
    least = _LEAST / max(across, upward)
    scenes: list[Scene] = []
    for size in _list_sizes(common if common > least else largest, largest):
        scenes.append(_fit(left, right, names, size, least))
        if not scenes[-1].crowded:
            break
    return min(scenes, key=lambda scene: len(scene.crowded))


def _list_sizes(first: float, last: float) -> Iterator[float]:
    """Round scales from the first to the last, those between among them."""
    while last > first:
        yield first
        first = round_scale(first * _NEXT)
    yield last


def _fit(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    names: _Names,
    scale: float,
    least: float,
) -> Scene:
    """The polygon to a scale, or to the next smaller one above `least` with which it is within
    PICTURE.
    """
    while True:
        layout = _compose(left, right, names, scale)
        scene = replace(make_scene(layout.primitives, scale), crowded=layout.crowded)
        if scale <= least or (scene.width <= PICTURE.width and scene.height <= PICTURE.height):
            return scene
        scale = round_scale(scale * 0.99)


def _compose(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    names: _Names,
    scale: float,
) -> Layout:
    """The arrows with their symbols and the letters of their corners."""
    least = _NEGLIGIBLE * max((length(arrow.value) for arrow in (*left, *right)), default=0.0)
    laid = [arrow for side in (left, right) for arrow in _lay_arrows(side, scale, least)]
    arrows = put_side_by_side(laid, _OFFSETS)
    corners = _list_corners(arrows)
    lettered = _name_corners(names.vertices, corners, scale)
    layout = _name_arrows(arrows, [_wish_letter(*one, corners) for one in lettered.items()])
    for letter, corner in zip(names.spare, _list_apart(corners, lettered.values()), strict=False):
        layout = layout.written((_wish_letter(letter, corner, corners),))
    return layout


def _name_arrows(arrows: Sequence[VectorArrow], letters: Sequence[Wish]) -> Layout:
    """The arrows with their symbols and the letters of corners: symbols first, or else letters,
    which have to stand beside their corners, and at last with thin lines across other arrows.
    """
    ties = (tie for arrow in arrows for tie in arrow.ties())
    parts = (part for arrow in arrows for part in arrow.primitives())
    bare = Layout.of((*ties, *parts, Disc(_ZERO, 0.5, None, "black")))
    found: list[Layout] = []
    for crossed, letters_first in product((NOTHING, ONE_ARROW), (False, True)):
        early, late = (letters, ()) if letters_first else ((), letters)
        layout = _write_symbols(bare.written(early), arrows, crossed).written(late)
        found.append(layout)
        if not layout.crowded:
            break
    return min(found, key=lambda layout: len(layout.crowded))


def _write_symbols(bare: Layout, arrows: Sequence[VectorArrow], crossed: float) -> Layout:
    """The layout with all symbols, starting with the shortest arrow: it has the fewest places to
    choose from. Symbols that find no place of their own start the next time, and the rest have
    what is left.
    """
    order = sorted(arrows, key=lambda arrow: length(arrow.end - arrow.start))
    layout, crowded = bare, bare.crowded
    for _ in range(_TRIES):
        layout = bare
        for arrow in order:
            layout = write_symbol(layout, arrow, arrows, crossed)
        if len(layout.crowded) == len(bare.crowded) or layout.crowded == crowded:
            break
        crowded = layout.crowded
        order.sort(key=lambda arrow: arrow.symbol not in crowded)
    return layout


def _list_corners(arrows: Sequence[VectorArrow]) -> list[Vector]:
    """The origin and the other corners, each once."""
    corners = [_ZERO]
    corners.extend(arrow.end for arrow in arrows if not _is_among(arrow.end, corners))
    return corners


def _is_among(place: Vector, places: Iterable[Vector], within: float = _SAME) -> bool:
    return any(length(place - other) < within for other in places)


def _list_apart(corners: Iterable[Vector], named: Iterable[Vector]) -> Iterator[Vector]:
    """The corners that have no letter and stand clear of those that have: a letter of their own
    would be in a heap with the other one.
    """
    places = list(named)
    for corner in corners:
        if not _is_among(corner, places, CLOSE):
            places.append(corner)
            yield corner


def _name_corners(
    vertices: Mapping[str, Vector], corners: Sequence[Vector], scale: float
) -> dict[str, Vector]:
    """The letters of the origin and of those vertices that the polygon has."""
    origin = next(letter for letter in _ORIGINS if letter not in vertices)
    places = {letter: vertex * scale for letter, vertex in vertices.items()}
    others = {one: place for one, place in places.items() if _is_among(place, corners[1:])}
    return {origin: _ZERO} | others


def _wish_letter(letter: str, corner: Vector, corners: Sequence[Vector]) -> Wish:
    """A letter outside its corner, nearer to it than to any other."""
    middle = sum(corners, _ZERO) * (1 / len(corners))
    spots = list_spots_around(letter, corner, away=corner - middle)
    others = [other for other in corners if length(other - corner) > CLOSE]
    mistaken = _MISTAKEN * rate_nearness(letter, spots, (corner,), others)
    return Wish(letter, spots, None, mistaken, names=corner)


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones: the arrow before such a
    one leads to its tip, so that the chain is not torn.
    """
    *starts, end = find_corners(chain)
    kept = [place for place, arrow in enumerate(chain) if length(arrow.value) > least]
    corners = [_ZERO, *(starts[place] for place in kept[1:]), end]
    for place, (start, tip) in zip(kept, pairwise(corners), strict=False):
        yield VectorArrow(chain[place].symbol, start * scale, tip * scale, chain[place].known)
