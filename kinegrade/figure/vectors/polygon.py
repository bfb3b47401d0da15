"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, islice, pairwise, permutations, product
from types import MappingProxyType

from kinegrade.figure.mechanism.fitting import make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc, Primitive, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, look_like_one, put_side_by_side
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.mechanics.vector import Vector
from kinegrade.round_numbers import round_down

# Millimetres that the polygon alone takes at most: the rest of a figure is for symbols
_WIDE, _HIGH = (52.0, 36.0)
_NEGLIGIBLE = 0.01  # of the longest vector: shorter ones are not drawn
_OFFSETS = (2.0, -6.0, 8.0, -12.0, 14.0)  # millimetres between arrows that would lie on one another
_LEAST = 10.0  # millimetres: no polygon is made smaller than this, whatever its symbols take
_TINY = 1e-12
_ORIGIN = "o"
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
    round number: `scale`, that of other polygons, unless this one would be too large or too small.
    The figure is within PICTURE of `plain_mechanism`.
    """
    across, upward = _measure_spans(left, right)
    if across + upward == 0.0:
        return make_scene(_compose(left, right, vertices, 1.0), 1.0)
    left, right = _arrange(left, right)
    largest = find_scale(left, right)
    common = min(scale or largest, largest)
    scale = common if max(across, upward) * common >= _LEAST else largest
    scene = make_scene(_compose(left, right, vertices, scale), scale)
    while not _fits(scene) and max(across, upward) * scale > _LEAST:
        scale = _round_down(scale * 0.99)
        scene = make_scene(_compose(left, right, vertices, scale), scale)
    return scene


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


def _fits(scene: Scene) -> bool:
    return scene.width <= PICTURE.width and scene.height <= PICTURE.height


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
) -> tuple[Primitive, ...]:
    """The arrows, then the symbols, starting with the shortest arrow: it has the fewest places to
    choose from.
    """
    least = _NEGLIGIBLE * max((length(arrow.value) for arrow in (*left, *right)), default=0.0)
    laid = [arrow for side in (left, right) for arrow in _lay_arrows(side, scale, least)]
    arrows = put_side_by_side(laid, (), _OFFSETS)
    origin = Disc(_ZERO, 0.5, None, "black")
    ties = (tie for arrow in arrows for tie in arrow.ties())
    layout = Layout.of((*ties, *(part for arrow in arrows for part in arrow.primitives()), origin))
    for arrow in sorted(arrows, key=lambda arrow: length(arrow.end - arrow.start)):
        layout = layout.written((arrow.wish_beside(arrows),))
    leaving = sum((arrow.end for arrow in arrows), _ZERO)
    origin_letter = Wish(_ORIGIN, list_spots_around(_ORIGIN, _ZERO, away=-leaving))
    corners = [arrow.end for arrow in arrows if arrow.aside == _ZERO]
    return layout.written((origin_letter, *_name_corners(vertices, corners, scale))).primitives


def _name_corners(
    vertices: Mapping[str, Vector], corners: Sequence[Vector], scale: float
) -> Iterator[Wish]:
    """The letters of those vertices that the polygon has, outside it."""
    middle = sum(corners, _ZERO) * (1 / max(len(corners), 1))
    for letter, vertex in vertices.items():
        place = vertex * scale
        if length(place) > _SAME and any(length(corner - place) < _SAME for corner in corners):
            yield Wish(letter, list_spots_around(letter, place, away=place - middle))


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones."""
    for arrow, start, end in zip(
        chain, list(_find_corners(chain))[:-1], list(_find_corners(chain))[1:], strict=True
    ):
        if length(arrow.value) > least:
            yield VectorArrow(arrow.symbol, start * scale, end * scale, arrow.known)
