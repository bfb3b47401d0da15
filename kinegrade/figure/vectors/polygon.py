"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations, islice, pairwise, permutations, product
from types import MappingProxyType

from kinegrade.figure.mechanism.fitting import make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, look_like_one, put_side_by_side
from kinegrade.figure.vectors.leaders import NOTHING, ONE_ARROW, write_symbol
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.mechanics.vector import Vector
from kinegrade.round_numbers import round_down

# Millimetres that the polygon alone takes at most: the rest of a figure is for symbols
_WIDE, _HIGH = (52.0, 36.0)
_NEGLIGIBLE = 0.01  # of the longest vector: shorter ones are not drawn
_OFFSETS = (2.0, -6.0, 8.0, -12.0, 14.0)  # millimetres between arrows that would lie on one another
_NEXT = 2.51  # times a round number, the next one is not above it
_LEAST = 10.0  # millimetres: no polygon is made smaller than this, whatever its symbols take
_TINY = 1e-12
_ORIGINS = ("o", "p")  # letters of the origin: another where it is that of a corner
_TRIES = 4  # orders in which the symbols are placed
_SAME = 0.05  # millimetres within which two corners coincide
_PERMUTED, _ORDERS = 4, 150  # vectors of a side that may change places, orders that are tried
_ZERO = Vector(0.0, 0.0)


@dataclass(frozen=True)
class Arrow:
    """A vector of an equation with its symbol (LaTeX math), in m/s or m/s^2, x right, y up; `known`
    before solving.
    """

    symbol: str
    value: Vector
    known: bool = True


def draw_polygon(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector] = MappingProxyType({}),
    scale: float | None = None,
) -> Scene:
    """The polygon of "sum of `left` = sum of `right`" from the common origin o.

    Known vectors are solid with a filled head, unknown ones dashed with an open head. Vectors
    shorter than a hundredth of the longest are not drawn. The vectors of a side follow one another
    in an order in which none runs along another; where there is no such order they are drawn side
    by side, with thin lines to their true positions. `vertices` are letters (LaTeX math) for the
    tips of vectors from the origin. The scale of the scene is millimetres per m/s (or m/s^2), a
    round number: `scale`, that of other polygons, unless this one would be too large or too small,
    or its symbols have no place at it.
    The figure is within PICTURE of `plain_mechanism`.
    """
    across, upward = _measure_spans(left, right)
    if across + upward == 0.0:
        return _fit(left, right, vertices, 1.0, 0.0)
    left, right = _arrange(left, right)
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
        first = _round_down(first * _NEXT)
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
        scale = _round_down(scale * 0.99)


def find_scale(left: Sequence[Arrow], right: Sequence[Arrow]) -> float:
    """The largest round scale, millimetres per m/s or m/s^2, at which the vectors fit a polygon."""
    across, upward = _measure_spans(left, right)
    return _round_down(min(_WIDE / max(across, _TINY), _HIGH / max(upward, _TINY)))


def _measure_spans(left: Sequence[Arrow], right: Sequence[Arrow]) -> tuple[float, float]:
    """Width and height of the chains."""
    corners = (*_find_corners(left), *_find_corners(right))
    across, upward = (_measure_span(axis) for axis in zip(*corners, strict=True))
    return across, upward


def _arrange(
    left: Sequence[Arrow], right: Sequence[Arrow]
) -> tuple[Sequence[Arrow], Sequence[Arrow]]:
    """The sides in the order nearest to the given one in which the fewest vectors run along
    another.
    """
    orders = product(_list_orders(left), _list_orders(right))
    return min(islice(orders, _ORDERS), key=_count_overlaps)


def _list_orders(side: Sequence[Arrow]) -> Iterable[Sequence[Arrow]]:
    return permutations(side) if len(side) <= _PERMUTED else (side,)


def _count_overlaps(sides: tuple[Sequence[Arrow], Sequence[Arrow]]) -> int:
    """How many pairs of vectors run along one another, on paper of the scale that they would
    have.
    """
    scale = find_scale(*sides)
    lines = [
        (start * scale, end * scale)
        for side in sides
        for start, end in pairwise(_find_corners(side))
        if length(end - start) * scale > 1.0
    ]
    return sum(look_like_one(one, other) for one, other in combinations(lines, 2))


def _round_down(number: float) -> float:
    """The largest round number that is not above a positive number, as far as doubles tell: a
    scale with a leading figure of 1, 2 or 5, and so its reciprocal.

    >>> _round_down(13.7), _round_down(0.0299)
    (10.0, 0.02)
    """
    return float(round_down(Fraction(number * (1 + 1e-9))))


def _find_corners(chain: Sequence[Arrow]) -> Iterator[Vector]:
    """The origin and the tips of a chain."""
    at = _ZERO
    yield at
    for arrow in chain:
        at = at + arrow.value
        yield at


def _measure_span(numbers: Sequence[float]) -> float:
    return max(numbers) - min(numbers)


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
    corners = [arrow.end for arrow in arrows if arrow.aside == _ZERO]
    return _name_arrows(arrows, (origin_letter, *_name_corners(vertices, corners, scale)))


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


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones."""
    for arrow, start, end in zip(
        chain, list(_find_corners(chain))[:-1], list(_find_corners(chain))[1:], strict=True
    ):
        if length(arrow.value) > least:
            yield VectorArrow(arrow.symbol, start * scale, end * scale, arrow.known)
