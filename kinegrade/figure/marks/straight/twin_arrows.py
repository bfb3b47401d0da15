"""The two arrows of a velocity and an acceleration in one sense: both leave their point, one on
either side of the line of motion. One is longer, so that no head stands beside another one and its
symbol has room past the other arrow.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kinegrade.figure.marks.straight.moving_arrow import ARROW, LEAVING, MovingArrow
from kinegrade.mechanics.vector import Vector

# Millimetres between the two, and from the point to their tails, which touch its pin
_APART, _TAIL = 2.0, 0.5
_LIFTED = 0.4  # millimetres by which they stand farther from the ground on which the point slides
LONG = ARROW + 4.5  # millimetres of the longer one
_FARTHER = 1.0  # millimetres past the tip of the short one, where the symbol of the long one begins
# Millimetres from the point from where on bars are kept off, with demerits
_LEAVINGS = {LEAVING: 0.0, 5.4: 0.4, 7.5: 1.0}


def list_twins(
    on_line: MovingArrow, open_side: Vector, *, lift: bool, short: bool
) -> Iterator[MovingArrow]:
    """The short arrow of two, on the open side of the line, or the long one on the other side; they
    are lifted from the ground.
    """
    across = on_line.toward.turned()
    side = across if across.dot(open_side) >= 0 else -across
    outward = side if short else -side
    start = on_line.point + on_line.toward * _TAIL + side * (_LIFTED * lift)
    twin = replace(on_line, start=start + outward * (_APART / 2), size=ARROW, outward=outward)
    if not short:
        twin = replace(twin, size=LONG, lettered=ARROW + _FARTHER)
    for leaving, close in _LEAVINGS.items():
        yield replace(twin, leaving=leaving, demerit=on_line.demerit + close)


def list_lanes(toward: Vector) -> list[Vector]:
    """The steps from the line of motion to either arrow, wherever the ground is."""
    across = toward.turned() * (_APART / 2 + _LIFTED)
    return [across, -across]
