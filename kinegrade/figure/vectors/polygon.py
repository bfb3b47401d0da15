"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from types import MappingProxyType

from msgspec.structs import replace

from kinegrade.figure.mechanism.fitting import Room, make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, put_around, spare_short
from kinegrade.figure.vectors.chains import (
    HIGHEST,
    LARGEST,
    NEGLIGIBLE,
    USUAL,
    Arrow,
    find_corners,
    find_scale,
    measure_spans,
    round_scale,
)
from kinegrade.figure.vectors.corners import list_corners, name_corners, wish_letter
from kinegrade.figure.vectors.leaders import NOTHING, ONE_ARROW, Crossed, write_symbol
from kinegrade.figure.vectors.plain_mechanism import LARGE, PICTURE
from kinegrade.figure.vectors.symbols import wish_beside
from kinegrade.mechanics.vector import Vector

_NEXT = 2.51  # times a round number, the next one is not above it
# Millimetres, a line's width: a shorter arrow is a dot, and is left out beside one so many times
# as long, which leads to its tip without being seen to point elsewhere
_VISIBLE, _LEADING = (0.4, 16.0)
_LEAST = 10.0  # millimetres: no polygon is made smaller than this, whatever its symbols take
_SHORT = 2.4  # millimetres, the length of a head
HIGH = Room(80.0, 84.0)  # where symbols find no place in less
_TRIES = 4  # orders in which the symbols are placed
_DOT = 0.4  # millimetres, radius of the origin: a short arrow comes out from under it
_ZERO = Vector(0.0, 0.0)


def draw_polygon(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector] = MappingProxyType({}),
    scale: float | None = None,
) -> Scene:
    """The polygon of "sum of `left` = sum of `right`" from the common origin o.

    Known vectors are solid with a filled head, unknown ones dashed with an open head. Vectors
    shorter than a hundredth of the longest, or no more than a dot, are not drawn. The vectors of a
    side follow one another as they are given, each from the tip of another; one that runs along
    shorter ones is an outline around them. `vertices` are letters (LaTeX math) for the tips of
    vectors from the origin; the other corners, between the components of a vector, are no point's
    and have none.
    The scale of the scene is millimetres per m/s (or m/s^2), a round number: `scale`, that of other
    polygons, unless this one would be too large or too small, or is hard to read at it. The figure
    is within PICTURE of `plain_mechanism`, or LARGE where it is easier to read, or HIGH.
    """
    across, upward = measure_spans(left, right)
    if across + upward == 0.0:
        return _fit(left, right, vertices, 1.0, _Limits(PICTURE, 0.0)).scene
    largest = find_scale(left, right)
    common = min(scale or largest, largest)
    least = _LEAST / max(across, upward)
    first = common if common > least else largest
    drawings: list[_Drawing] = []
    for room, span in ((PICTURE, USUAL), (LARGE, LARGEST), (HIGH, HIGHEST)):
        for size in _list_sizes(first, find_scale(left, right, span)):
            drawings.append(_fit(left, right, vertices, size, _Limits(room, least)))
            if not drawings[-1].faults + drawings[-1].short:
                return drawings[-1].scene
        best = min(drawings, key=lambda drawing: (drawing.faults, drawing.short))
        if not best.faults or (room is LARGE and not best.scene.crowded):
            break
    return best.scene


def _list_sizes(first: float, last: float) -> Iterator[float]:
    """Round scales from the first to the last, those between among them."""
    while last > first:
        yield first
        first = round_scale(first * _NEXT)
    yield last


@dataclass(frozen=True)
class _Limits:
    """What a polygon takes at most, and the scale below which it does not shrink."""

    room: Room
    least: float


@dataclass(frozen=True)
class _Drawing:
    """A polygon to a scale, how much in it is hard to read, and how many arrows are hardly more
    than a head, or corners without a letter: a reason for a larger scale, not a larger picture.
    """

    scene: Scene
    faults: int
    short: int


def _fit(
    left: Sequence[Arrow],
    right: Sequence[Arrow],
    vertices: Mapping[str, Vector],
    scale: float,
    limits: _Limits,
) -> _Drawing:
    """The polygon to a scale, or to the next smaller one with which it is within its limits."""
    while True:
        least = NEGLIGIBLE * max((length(arrow.value) for arrow in (*left, *right)), default=0.0)
        laid = [arrow for side in (left, right) for arrow in _lay_arrows(side, scale, least)]
        arrows = put_around(spare_short(laid))
        undrawn = max(least * scale, _VISIBLE) * (len(left) + len(right) - len(laid))
        layout = _name_arrows(arrows, name_corners(vertices, list_corners(arrows), scale, undrawn))
        scene = replace(make_scene(layout.primitives, scale), crowded=layout.crowded)
        room = limits.room
        if scale <= limits.least or (scene.width <= room.width and scene.height <= room.height):
            short = sum(length(arrow.end - arrow.start) < _SHORT for arrow in arrows)
            hidden = sum(length(arrow.value) > least for arrow in (*left, *right)) - len(laid)
            faults = len(layout.crowded) + sum(map(_rate_arrow, arrows)) + hidden
            return _Drawing(scene, faults, short)
        scale = round_scale(scale * 0.99)


def _rate_arrow(arrow: VectorArrow) -> int:
    """How hard an arrow is to read: one that lies on others, or is hardly more than a dot."""
    return bool(arrow.around) + (length(arrow.end - arrow.start) < _SHORT / 2)


def _name_arrows(arrows: Sequence[VectorArrow], lettered: Mapping[str, Vector]) -> Layout:
    """The arrows with their symbols and the letters of corners: symbols first, or else letters,
    which have to stand beside their corners, and at last with thin lines across other arrows.
    """
    corners = list_corners(arrows)
    letters = [wish_letter(*one, corners) for one in lettered.items()]
    wishes = [(arrow, wish_beside(arrow, arrows)) for arrow in arrows]
    wishes.sort(key=lambda wished: length(wished[0].end - wished[0].start))
    parts = (part for arrow in arrows for part in arrow.primitives())
    bare = Layout.of((*parts, Disc(_ZERO, _DOT, None, "black")))
    found: list[Layout] = []
    for crossed, letters_first in product((NOTHING, ONE_ARROW), (False, True)):
        early, late = (letters, ()) if letters_first else ((), letters)
        layout = _write_symbols(bare.written(early), wishes, crossed).written(late)
        found.append(layout)
        if not layout.crowded:
            break
    return min(found, key=lambda layout: len(layout.crowded))


def _write_symbols(
    bare: Layout, wishes: Sequence[tuple[VectorArrow, Wish]], crossed: Crossed
) -> Layout:
    """The layout with all symbols, starting with the shortest arrow: it has the fewest places to
    choose from. Symbols that find no place of their own start the next time, and the rest have
    what is left.
    """
    order, arrows = list(wishes), [arrow for arrow, _ in wishes]
    layout, crowded = bare, bare.crowded
    for _ in range(_TRIES):
        layout = bare
        for arrow, wish in order:
            layout = write_symbol(layout, arrow, arrows, crossed, wish)
        if len(layout.crowded) == len(bare.crowded) or layout.crowded == crowded:
            break
        crowded = layout.crowded
        order.sort(key=lambda wished: wished[0].symbol not in crowded)
    return layout


def _is_visible(chain: Sequence[Arrow], place: int, scale: float, least: float) -> bool:
    """Whether a vector of a side is to be drawn: it is no dot, or the arrow beside it is so short
    that it would lead elsewhere without it.
    """
    size = length(chain[place].value)
    if size <= least or size * scale > _VISIBLE or len(chain) == 1:
        return size > least
    return length(chain[place - 1 if place else 1].value) < _LEADING * size


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones: the arrow before such a
    one leads to its tip, so that the chain is not torn.
    """
    *starts, end = find_corners(chain)
    kept = [place for place in range(len(chain)) if _is_visible(chain, place, scale, least)]
    corners = [_ZERO, *(starts[place] for place in kept[1:]), end]
    for place, (start, tip) in zip(kept, pairwise(corners), strict=False):
        yield VectorArrow(chain[place].symbol, start * scale, tip * scale, chain[place].known)
