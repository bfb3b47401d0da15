"""The polygon of a vector equation, to scale: both sides laid tip to tail from a common origin to a
common end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import floor, log10

from kinegrade.figure.mechanism.fitting import make_scene
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc, Primitive, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, put_side_by_side
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.mechanics.vector import Vector

# Millimetres that the polygon alone takes at most: the rest of a figure is for symbols
_WIDE, _HIGH = (44.0, 32.0)
# Leading figures of a scale that is easy to state
ROUND = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)
_NEGLIGIBLE = 0.01  # of the longest vector: shorter ones are not drawn
_OFFSETS = (2.0, -6.0, 8.0, -12.0, 14.0)  # millimetres between arrows that would lie on one another
_LEAST = 10.0  # millimetres: no polygon is made smaller than this, whatever its symbols take
_TINY = 1e-12
_ORIGIN = "o"
_ZERO = Vector(0.0, 0.0)


@dataclass(frozen=True)
class Arrow:
    """A vector of an equation with its symbol (LaTeX math), in m/s or m/s^2, x right, y up; `known`
    before solving.
    """

    symbol: str
    value: Vector
    known: bool = True


def draw_polygon(left: Sequence[Arrow], right: Sequence[Arrow]) -> Scene:
    """The polygon of "sum of `left` = sum of `right`" from the common origin o.

    Known vectors are solid with a filled head, unknown ones dashed with an open head. Vectors
    shorter than a hundredth of the longest are not drawn. Vectors on one line are drawn side by
    side, with thin lines to their true positions. The scale of the scene is millimetres per m/s (or
    m/s^2), a round number. The figure is within PICTURE of `plain_mechanism`.
    """
    across, upward = (
        _measure_span(axis)
        for axis in zip(*_find_corners(left), *_find_corners(right), strict=True)
    )
    if across + upward == 0.0:
        return make_scene(_compose(left, right, 1.0), 1.0)
    scale = _round_down(min(_WIDE / max(across, _TINY), _HIGH / max(upward, _TINY)))
    scene = make_scene(_compose(left, right, scale), scale)
    while not _fits(scene) and max(across, upward) * scale > _LEAST:
        scale = _round_down(scale * 0.99)
        scene = make_scene(_compose(left, right, scale), scale)
    return scene


def _fits(scene: Scene) -> bool:
    return scene.width <= PICTURE.width and scene.height <= PICTURE.height


def _round_down(number: float) -> float:
    """The largest round number that is not above a positive number.

    >>> _round_down(13.7), _round_down(0.0299)
    (12.0, 0.025)
    """
    power = 10.0 ** floor(log10(number) + 1e-9)
    leading = max(figure for figure in ROUND if figure <= number / power * (1 + 1e-9))
    return float(f"{leading * power:.6g}")


def _find_corners(chain: Sequence[Arrow]) -> Iterator[Vector]:
    """The origin and the tips of a chain."""
    at = _ZERO
    yield at
    for arrow in chain:
        at = at + arrow.value
        yield at


def _measure_span(numbers: Sequence[float]) -> float:
    return max(numbers) - min(numbers)


def _compose(left: Sequence[Arrow], right: Sequence[Arrow], scale: float) -> tuple[Primitive, ...]:
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
    return layout.written(
        (Wish(_ORIGIN, list_spots_around(_ORIGIN, _ZERO, away=-leaving)),)
    ).primitives


def _lay_arrows(chain: Sequence[Arrow], scale: float, least: float) -> Iterator[VectorArrow]:
    """The arrows of one side tip to tail on paper, without negligible ones."""
    for arrow, start, end in zip(
        chain, list(_find_corners(chain))[:-1], list(_find_corners(chain))[1:], strict=True
    ):
        if length(arrow.value) > least:
            yield VectorArrow(arrow.symbol, start * scale, end * scale, arrow.known)
