"""Circles, tracks, belts and ropes as tactile lines: a pitch circle is dashed, the ground thick."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import assert_never

from kinegrade.figure.joints.symbol import Foot, Rim
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.belts import draw_ropes
from kinegrade.figure.mechanism.wheels.outlines import trace_around, trace_cam_outline
from kinegrade.figure.plane import angle_of, mean
from kinegrade.figure.scene import Bow, Disc, Outline, Pen, Primitive, Strokes
from kinegrade.figure.tactile.sizes import (
    BETWEEN_RIMS,
    DASH,
    GAP,
    GROUND,
    HALF,
    MARK,
    OUTLINE,
    RAIL,
)
from kinegrade.mechanics.joints import GROUND as GROUND_BODY

_SHARE = 1.2  # of the radius of a wheel that its track has at least on either side


def draw_rim(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """One circle of a body."""
    pen = GROUND if rim.body == GROUND_BODY else OUTLINE
    outer = (Disc(rim.at, rim.radius + BETWEEN_RIMS, OUTLINE),) if rim.ring else ()
    match rim.kind:
        case "cam":
            profile = trace_cam_outline(anatomy.mechanism, anatomy.symbols, rim)
            return (Outline(profile, OUTLINE), Strokes(((rim.at, rim.touch),), MARK))
        case "slot" if rim.body != GROUND_BODY and not rim.ring:
            inner = Disc(rim.at, rim.radius - HALF, OUTLINE) if rim.radius > 2 * HALF else None
            return (Disc(rim.at, rim.radius + HALF, OUTLINE), *([inner] if inner else []))
        case "gear":
            return (*_dash(rim, pen), *outer)
        case "wheel" | "slot":
            arc = rim.find_arc()
            circle = Bow(rim.at, rim.radius, *arc, pen) if arc else Disc(rim.at, rim.radius, pen)
            return (circle, *outer)
        case "edge":
            return (Disc(rim.at, rim.radius, OUTLINE), *_trace_cam_of_circles(anatomy, rim))
        case _:
            assert_never(rim.kind)


def _trace_cam_of_circles(anatomy: Anatomy, rim: Rim) -> Iterator[Outline]:
    """The outline of a cam that is made of circles, with the first of these."""
    edges = [each for each in anatomy.rims if each.kind == "edge" and each.body == rim.body]
    if anatomy.hints.shapes.get(rim.body) == "cam" and rim is edges[0]:
        yield Outline(trace_around(edges), OUTLINE)


def _dash(rim: Rim, pen: Pen) -> Iterator[Bow]:
    """A pitch circle, with a dash at its contact."""
    gap = GAP + pen.width  # the ends of dashes are round
    count = max(3, int(2 * pi * rim.radius / (DASH + gap)))
    step = 2 * pi / count
    size = max(step - gap / rim.radius, 0.02)
    first = angle_of(rim.touch - rim.at)
    for number in range(count):
        yield Bow(rim.at, rim.radius, first - size / 2 + number * step, size, pen)


def draw_track(foot: Foot) -> Strokes:
    """The ground under a wheel."""
    along = foot.away.turned() * max(RAIL, _SHARE * foot.radius)
    return Strokes(((foot.contact - along, foot.contact + along),), GROUND)


def draw_strands(anatomy: Anatomy) -> Iterator[Primitive]:
    """Belts and ropes; a load hangs twice as large as in print."""
    for symbol in anatomy.symbols:
        for strand in symbol.strands:
            yield Strokes((strand,), OUTLINE)
    for drawn in draw_ropes(anatomy):
        match drawn:
            case Strokes(lines):
                yield Strokes(lines, OUTLINE)
            case Outline(corners):
                middle = mean(corners)
                larger = tuple(middle + (corner - middle) * 2.0 for corner in corners)
                yield Outline(larger, OUTLINE)
            case _:
                assert_never(drawn)
