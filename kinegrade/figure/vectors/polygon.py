"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise, product
from types import MappingProxyType

from kinegrade.figure.mechanism.fitting import make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish, list_spots_around
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
_TRIES = 4  # orders in which the symbols are placed
_SAME = 0.05  # millimetres within which two corners coincide
_ZERO = Vector(0.0, 0.0)


def draw_polygon(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector] = MappingProxyType({}),
    scale: float | None = None,
) -> Scene:
    """The polygon of "sum of `left` = sum of `right`" from the common origin o.

    Known vectors are solid with a filled head, unknown ones dashed with an open head. Vectors
    shorter than a hundredth of the longest are not drawn. The vectors of a side follow one another
    as they are given; those that would run along another are drawn beside it, with thin lines to
    their true positions. `vertices` are letters (LaTeX math) for the tips of vectors from the
    origin; corners that have none are numbered. The scale of the scene is millimetres per m/s (or
    m/s^2), a round number: `scale`, that of other polygons, unless this one would be too large or
    too small, or its symbols have no place at it. The figure is within PICTURE of
    `plain_mechanism`.
    """
    across, upward = measure_spans(left, right)
    if across + upward == 0.0:
        return _fit(left, right, vertices, 1.0, 0.0)
    largest = find_scale(left, right)
    common = min(scale or largest, largest)
    least = _LEAST / max(across, upward)
    scenes: list[Scene] = []
    for size in _list_sizes(common if common > least else largest, largest):
        scenes.append(_fit(left, right, vertices, size, least))
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
    vertices: Mapping[str, Vector],
    scale: float,
    least: float,
) -> Scene:
    """The polygon to a scale, or to the next smaller one above `least` with which it is within
    PICTURE.
    """
    while True:
        layout = _compose(left, right, vertices, scale)
        scene = replace(make_scene(layout.primitives, scale), crowded=layout.crowded)
        if scale <= least or (scene.width <= PICTURE.width and scene.height <= PICTURE.height):
            return scene
        scale = round_scale(scale * 0.99)


def _compose(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector],
    scale: float,
) -> Layout:
    """The arrows with their symbols and the letters of their corners."""
    least = _NEGLIGIBLE * max((length(arrow.value) for arrow in (*left, *right)), default=0.0)
    laid = [arrow for side in (left, right) for arrow in _lay_arrows(side, scale, least)]
    arrows = put_side_by_side(laid, (), _OFFSETS)
    leaving = sum((arrow.end for arrow in arrows), _ZERO)
    origin = next(letter for letter in _ORIGINS if letter not in vertices)
    origin_letter = Wish(origin, list_spots_around(origin, _ZERO, away=-leaving))
    corners = [arrow.end for arrow in arrows]
    lettered = tuple(_name_corners(vertices, corners, scale))
    layout = _name_arrows(arrows, (origin_letter, *lettered))
    return _number_corners(layout, corners, lettered)


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


def _name_corners(
    vertices: Mapping[str, Vector], corners: Sequence[Vector], scale: float
) -> Iterator[Wish]:
    """The letters of those vertices that the polygon has, outside it."""
    middle = sum(corners, _ZERO) * (1 / max(len(corners), 1))
    for letter, vertex in vertices.items():
        place = vertex * scale
        if length(place) > _SAME and any(length(corner - place) < _SAME for corner in corners):
            spots = list_spots_around(letter, place, away=place - middle)
            yield Wish(letter, spots, names=place)


def _number_corners(layout: Layout, corners: Sequence[Vector], lettered: Sequence[Wish]) -> Layout:
    """The layout with numbers outside the corners that have no letters, each once, where there is
    a place free of everything else; a number without such a place counts as crowded.
    """
    middle = sum(corners, _ZERO) * (1 / max(len(corners), 1))
    named = [_ZERO, *(wish.names for wish in lettered if wish.names is not None)]
    number = 1
    for corner in corners:
        if any(length(corner - place) < _SAME for place in named):
            continue
        named.append(corner)
        spots = list_spots_around(str(number), corner, away=corner - middle)
        written = layout.written((Wish(str(number), spots, names=corner),))
        if written.crowded == layout.crowded:
            layout, number = written, number + 1
        else:
            layout = replace(layout, crowded=written.crowded)
    return layout


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones: the arrow before such a
    one leads to its tip, so that the chain is not torn.
    """
    *starts, end = find_corners(chain)
    kept = [place for place, arrow in enumerate(chain) if length(arrow.value) > least]
    corners = [_ZERO, *(starts[place] for place in kept[1:]), end]
    for place, (start, tip) in zip(kept, pairwise(corners), strict=False):
        yield VectorArrow(chain[place].symbol, start * scale, tip * scale, chain[place].known)
