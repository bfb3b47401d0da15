"""The marks of points as primitives: open circles at pins, crosses at centres and at labelled
construction points, dots at other marked points.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import draw_centre_mark, draw_dot, draw_pin


def draw_points(anatomy: Anatomy) -> Iterator[Primitive]:
    """Crosses below dots below circles; the tip of a knife edge needs no mark."""
    at = anatomy.mechanism.points
    tips = set(anatomy.knife_edges)
    pins = _find_pins(anatomy) - tips
    owned = {name for body in anatomy.mechanism.bodies for name in body.points}
    centres = ({rim.centre for rim in anatomy.rims} | _find_labelled(anatomy) - owned - tips) - pins
    for name in sorted(centres):
        yield from draw_centre_mark(at[name])
    for name in sorted(owned - pins - centres - tips):
        yield from draw_dot(at[name])
    for name in sorted(pins):
        yield from draw_pin(at[name])


def _find_pins(anatomy: Anatomy) -> set[str]:
    """The points of pins, but for those that only guide a rod."""
    return {
        symbol.point
        for symbol in anatomy.symbols
        if symbol.point and symbol.pinned and not anatomy.is_rod(symbol)
    }


def _find_labelled(anatomy: Anatomy) -> set[str]:
    labels = anatomy.hints.labels.items()
    return {name for name, symbol in labels if symbol and name in anatomy.mechanism.points}
