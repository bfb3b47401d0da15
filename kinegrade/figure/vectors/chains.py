"""The two sides of a vector equation as chains of arrows: their corners, the scale at which they
fit a figure, and the order in which the arrows of a side follow one another.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import chain, combinations, islice, pairwise, permutations, product
from types import MappingProxyType
from typing import TypeAlias

from kinegrade.figure.plane import length
from kinegrade.figure.vectors.arrows import look_like_one
from kinegrade.mechanics.vector import Vector
from kinegrade.round_numbers import round_down

# Millimetres that the polygon alone takes at most: the rest of a figure is for symbols
USUAL, LARGEST, HIGHEST = (52.0, 36.0), (68.0, 56.0), (68.0, 76.0)
NEGLIGIBLE = 0.01  # of the longest vector: shorter ones are not drawn
_TINY = 1e-12
_PERMUTED, _ORDERS = 4, 150  # vectors of a side that may change places, orders that are tried
_SAME = 0.05  # millimetres within which two corners coincide
_ZERO = Vector(0.0, 0.0)
Places: TypeAlias = Sequence[int]
_Order: TypeAlias = tuple[Places, Places]


@dataclass(frozen=True)
class Arrow:
    """A vector of an equation with its symbol (LaTeX math), in m/s or m/s^2, x right, y up; `known`
    before solving.
    """

    symbol: str
    value: Vector
    known: bool = True


def find_corners(chain: Sequence[Arrow]) -> Iterator[Vector]:
    """The origin and the tips of a chain."""
    at = _ZERO
    yield at
    for arrow in chain:
        at = at + arrow.value
        yield at


def measure_spans(left: Sequence[Arrow], right: Sequence[Arrow]) -> tuple[float, float]:
    """Width and height of the chains."""
    corners = (*find_corners(left), *find_corners(right))
    across, upward = (max(axis) - min(axis) for axis in zip(*corners, strict=True))
    return across, upward


def find_scale(
    left: Sequence[Arrow], right: Sequence[Arrow], span: tuple[float, float] = USUAL
) -> float:
    """The largest round scale, millimetres per m/s or m/s^2, at which the vectors fit a polygon of
    that width and height.
    """
    across, upward = measure_spans(left, right)
    return round_scale(min(span[0] / max(across, _TINY), span[1] / max(upward, _TINY)))


def round_scale(number: float) -> float:
    """The largest round number that is not above a positive number, as far as doubles tell: a
    scale with a leading figure of 1, 2 or 5, and so its reciprocal.

    >>> round_scale(13.7), round_scale(0.0299)
    (10.0, 0.02)
    """
    return float(round_down(Fraction(number * (1 + 1e-9))))


def find_order(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector] = MappingProxyType({}),
) -> _Order:
    """The places of the vectors of both sides, in the order nearest to the given one in which the
    fewest run along another and, of these orders, the most corners have letters.
    """
    return _find_order(tuple(left), tuple(right), tuple(vertices.values()))


@lru_cache(maxsize=128)  # what is said of a polygon depends on it, as do its letters and itself
def _find_order(
    left: tuple[Arrow, ...], right: tuple[Arrow, ...], vertices: tuple[Vector, ...]
) -> _Order:
    def rate(order: _Order) -> tuple[int, int]:
        sides = [left[place] for place in order[0]], [right[place] for place in order[1]]
        scale = find_scale(*sides)
        return -_count_overlaps(*sides, scale), _count_lettered(*sides, scale, vertices)

    given: _Order = (range(len(left)), range(len(right)))
    best, most = given, rate(given)
    if most[0] == 0:
        return given
    whole, scale = (0, len(vertices)), find_scale(left, right)
    lefts, rights = (_list_orders(side, scale, vertices) for side in (left, right))
    for order in islice(product(lefts, rights), 1, _ORDERS):
        found = rate(order)
        if found > most:
            best, most = order, found
        if most == whole:
            break
    while most[0] < 0:
        found, nearest = max(
            ((rate(order), order) for order in _list_moves(best)), key=lambda rated: rated[0]
        )
        if found <= most:
            break
        best, most = nearest, found
    return best


def _list_orders(
    side: Sequence[Arrow], scale: float, vertices: Sequence[Vector]
) -> Iterator[Places]:
    """The orders of a side, the given one first: all of a few vectors, of many those in which every
    letter keeps its corner, as the two parts of one vector lie between the same letters.
    """
    if len(side) <= _PERMUTED:
        return permutations(range(len(side)))
    groups = _list_groups(side, scale, vertices)
    orders = product(*map(_permute, groups))
    return (tuple(chain.from_iterable(order)) for order in islice(orders, _ORDERS))


def _list_groups(
    side: Sequence[Arrow], scale: float, vertices: Sequence[Vector]
) -> Iterator[Places]:
    """The places of vectors between one corner that has a letter and the next."""
    begin = 0
    for place, corner in enumerate(find_corners(side)):
        if place == len(side) or _has_letter(corner, scale, vertices):
            yield range(begin, place)
            begin = place


def _permute(places: Places) -> Iterable[Places]:
    return permutations(places) if len(places) <= _PERMUTED else (places,)


def _has_letter(corner: Vector, scale: float, vertices: Sequence[Vector]) -> bool:
    return any(length(corner - vertex) * scale < _SAME for vertex in vertices)


def _list_moves(order: _Order) -> Iterator[_Order]:
    """The orders in which one vector is at another place of its side."""
    left, right = order
    yield from ((moved, right) for moved in _move_one(left))
    yield from ((left, moved) for moved in _move_one(right))


def _move_one(places: Places) -> Iterator[Places]:
    yield places
    for taken in places:
        rest = [place for place in places if place != taken]
        for at in range(len(places)):
            yield (*rest[:at], taken, *rest[at:])


def _count_overlaps(left: Sequence[Arrow], right: Sequence[Arrow], scale: float) -> int:
    """How many pairs of vectors run along one another, on paper of the scale that they would
    have.
    """
    least = NEGLIGIBLE * max((length(arrow.value) for arrow in (*left, *right)), default=0.0)
    lines = [
        (start * scale, end * scale)
        for side in (left, right)
        for start, end in pairwise(find_corners(side))
        if length(end - start) > least
    ]
    return sum(look_like_one(one, other) for one, other in combinations(lines, 2))


def _count_lettered(
    left: Sequence[Arrow], right: Sequence[Arrow], scale: float, vertices: Sequence[Vector]
) -> int:
    """How many of the places of letters are corners."""
    corners = (*find_corners(left), *find_corners(right))
    return sum(
        any(length(corner - vertex) * scale < _SAME for corner in corners) for vertex in vertices
    )
