"""What slides and what guides it: blocks and sleeves, guides of rods, cylinders with pistons."""

from __future__ import annotations

from kinegrade.figure.plane import unit
from kinegrade.figure.scene import BOLD, FIRM, Outline, Primitive, Strokes
from kinegrade.figure.symbols.ground import HATCHING, draw_ground
from kinegrade.mechanics.vector import Vector

BLOCK_LENGTH, BLOCK_WIDTH = 5.0, 3.0
BLOCK_IN_SLOT = 4.0  # the length of a block in the slot of a bar
SLEEVE_LENGTH, WIDTH_ABOUT_PIN = 6.4, 4.4  # of a sleeve; its width about a pin beside its bar
_GUIDE_GAP = BOLD.width / 2 + 0.55  # from the axis of a rod to its guide
# Millimetres: half the width of a cylinder, its length, and from its floor to the piston in it
_BORE, _STROKE, _UNDER_PISTON = 2.0, 9.5, 3.8


def measure_in_sleeve(away: Vector, side: Vector) -> float:
    """Millimetres from the point of such a joint to the edge of its sleeve in a direction."""
    along, across = abs(float(away.cross(side))), abs(float(away.dot(side)))
    return min(SLEEVE_LENGTH / 2 / max(along, 1e-9), WIDTH_ABOUT_PIN / 2 / max(across, 1e-9))


def draw_block(
    at: Vector, along: Vector, size: float = BLOCK_LENGTH, width: float = BLOCK_WIDTH
) -> Outline:
    """A slider: a rectangle with its long side along the guide."""
    half, across = along * (size / 2), along.turned() * (width / 2)
    return Outline(
        (at - half - across, at + half - across, at + half + across, at - half + across),
        FIRM,
        "white",
    )


def draw_guide(at: Vector, along: Vector, reach: float = 2.8) -> tuple[Primitive, ...]:
    """A straight ground guide on both sides of a rod."""
    across = along.turned()
    sides = (across, -across)
    return tuple(
        part
        for side in sides
        for part in draw_ground(
            at + side * _GUIDE_GAP - along * reach, at + side * _GUIDE_GAP + along * reach, side
        )
    )


def draw_cylinder(start: Vector, end: Vector) -> tuple[Primitive, ...]:
    """A rod whose piston is in a closed cylinder, on ground of which the hatching ends at `end`."""
    along = unit(end - start)
    across, floor = along.turned(), end - along * HATCHING
    side, mouth, piston = across * _BORE, floor - along * _STROKE, floor - along * _UNDER_PISTON
    box = (mouth - side, mouth + side, floor + side, floor - side)
    reach, head = across * (_BORE + 1.3), across * (_BORE - FIRM.width)
    return (
        *draw_ground(floor - reach, floor + reach, along),
        Outline(box, FIRM, "white"),
        Strokes(((piston - head, piston + head),), BOLD),
        Strokes(((start, piston),), BOLD),
    )
