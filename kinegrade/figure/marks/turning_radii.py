"""How far from its pivot the arrow of a rotation stands, by what turns about it, and in which
direction.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from math import pi

from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Rod, SlottedDisc
from kinegrade.figure.plane import NEAR, angle_of, length
from kinegrade.figure.scene import PITCH, Disc
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

RADII = (5.0, 6.5, 8.0, 10.0)  # millimetres, where nothing else is about the pivot
BEYOND = 2.0  # millimetres between the rim of a body and an arrow beyond it
ROOMY = 11.0  # millimetres from a pivot to the nearest rim that leave room for an arrow within
_WITHIN = 2.6  # millimetres between the rim of a body and an arrow within it
# Millimetres between the rim of a disc and the arrow of another body about its pivot
_OUTSIDE = 4.5


def order_radii(
    mechanism: Mechanism, body: str, centre: Vector, drawing: Drawing
) -> tuple[float, ...]:
    """The radii of the arrow of a body, the preferred one first."""
    for base in list_base_circles(drawing, body, centre):
        within = base.radius > ROOMY
        return (base.radius + (-_WITHIN if within else BEYOND), *RADII)
    rims = list(_list_radii(drawing, body))
    outer = [radius + BEYOND for radius in rims]
    others = _list_pivoted_beside(mechanism, body, drawing)
    if not others:
        return (*RADII, *outer)
    inner = [radius - _WITHIN for radius in rims if radius > 2 * RADII[0]]
    apart = [radius + _OUTSIDE for radius in _list_discs(drawing, others)]
    return (*inner, *outer, *apart, *RADII)


def list_base_circles(drawing: Drawing, body: str, centre: Vector) -> list[Disc]:
    """The base circle of a cam about its pivot; none of another body."""
    if not any(rim.body == body and rim.kind == "cam" for rim in drawing.rims):
        return []
    discs = (part for part in drawing.primitives if isinstance(part, Disc) and part.pen == PITCH)
    return [disc for disc in discs if length(disc.centre - centre) < NEAR]


def _list_radii(drawing: Drawing, body: str) -> Iterator[float]:
    """The radii of the circles that a body is drawn as."""
    yield from (rim.radius for rim in drawing.rims if rim.body == body)
    for part in drawing.parts:
        if isinstance(part, SlottedDisc | GenevaWheel) and part.body == body:
            yield part.radius


def _list_pivoted_beside(mechanism: Mechanism, body: str, drawing: Drawing) -> list[str]:
    """The other bodies that turn about the fixed pin of a body, so that their arrows have to be
    told from its own: each stands at its own rim, or beyond that of the others.
    """
    pin = find_fixed_pin(drawing.symbols, body)
    others = [other.name for other in mechanism.bodies if other.name != body]
    return [name for name in others if pin and find_fixed_pin(drawing.symbols, name) == pin]


def _list_discs(drawing: Drawing, bodies: Collection[str]) -> Iterator[float]:
    """The radii of those bodies that are discs."""
    for rim in drawing.rims:
        if rim.body in bodies and not rim.ring:
            yield rim.radius


def find_body_direction(mechanism: Mechanism, body: str, centre: Vector, drawing: Drawing) -> float:
    """The direction in which a body extends from its pivot; when it extends in none, away from the
    bars of others there, or up.
    """
    points = [mechanism.points[name] for name in mechanism.body(body).points]
    bars = [part for part in drawing.parts if isinstance(part, Bar | Rod)]
    points += [end for bar in bars if isinstance(bar, Bar) and bar.body == body for end in bar.free]
    far = max(points, key=lambda point: length(point - centre))
    if length(far - centre) > 1.0:
        return angle_of(far - centre)
    others = [(bar.start, bar.end) for bar in bars if bar.body != body]
    ends = [end for bar in others for end in (bar, bar[::-1])]
    away = sum((start - end for start, end in ends if length(start - centre) < NEAR), Vector(0, 0))
    return angle_of(away) if length(away) > NEAR else pi / 2
