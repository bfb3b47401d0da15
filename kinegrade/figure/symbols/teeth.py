"""Toothed bars and the jaws of a crusher."""

from __future__ import annotations

from math import pi

from kinegrade.figure.plane import angle_of, length, unit
from kinegrade.figure.scene import FIRM, PITCH, TOOTHED, Bow, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.figure.symbols.ground import draw_ground
from kinegrade.figure.teeth import find_teeth_of_rack, trace_rack
from kinegrade.mechanics.vector import Vector

RACK_DEPTH = 2.6  # from the pitch line of a rack to its back
# Millimetres: a tooth of a jaw, and the gap at the mouth; the slope between the two jaws
_TOOTH, _MOUTH, _MOUTH_SLOPE = 0.9, 2.2, 0.3


def draw_rack(
    start: Vector, end: Vector, back: Vector, gap: Vector, eyes: tuple[Vector, ...] = ()
) -> tuple[Primitive, ...]:
    """A toothed bar with its pitch line, on which there is a gap at that point, its material in the
    direction `back`, and an eye about the pin at each of those ends, whose outline runs on in that
    of the bar.
    """
    teeth, radius = find_teeth_of_rack(start, end, gap, eyes), BAR_WIDTH / 2
    contour = trace_rack((start, end), back, teeth, RACK_DEPTH, eyes)
    edges = tuple(Disc(at, radius, TOOTHED, "grey") for at in eyes)
    insides = tuple(Disc(at, radius - TOOTHED.width / 2, None, "grey") for at in eyes)
    line = Strokes(((teeth[0], teeth[-1]),), PITCH)
    return (*edges, Outline(contour, TOOTHED, "grey"), *insides, line)


def draw_jaw(pivot: Vector, mouth: Vector, back: Vector) -> tuple[Primitive, ...]:
    """A plate from its pivot to its mouth, with the axis from pin to pin and teeth on the side away
    from `back`, and the fixed jaw that it faces, which is nearest at the mouth.
    """
    along, size = unit(mouth - pivot), length(mouth - pivot)
    half, count = BAR_WIDTH / 2, max(4, round(size / 2.2))
    teeth = [
        mouth - along * (size * (index + 0.5) / count) - back * (half + _TOOTH * (index % 2))
        for index in range(count)
    ]
    round_mouth = pi if back.cross(along) > 0 else -pi
    caps = [
        Bow(at, half, angle_of(side), round_mouth, FIRM).path()
        for at, side in ((mouth, back), (pivot, -back))
    ]
    plate = Outline((*caps[0], *teeth, *caps[1]), FIRM, "grey")
    upward = unit(-along - back * _MOUTH_SLOPE)
    facing = mouth - back * (half + _TOOTH + _MOUTH)
    outward = upward.turned() if back.dot(upward.turned()) < 0 else -upward.turned()
    faced = draw_ground(facing - upward * 2.0, facing + upward * size * 0.9, outward)
    return (*faced, plate, Strokes(((pivot, mouth),), PITCH))
