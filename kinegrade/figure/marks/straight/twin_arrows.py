"""The two arrows of a velocity and an acceleration in one sense: both leave their point, one on
either side of the line of motion. One is longer, so that no head stands beside another one and its
symbol has room past the other arrow.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.straight.moving_arrow import ARROW, LEAVING, MovingArrow
from kinegrade.figure.scene import BOLD, FIRM
from kinegrade.mechanics.vector import Vector

LONG = ARROW + 4.5  # millimetres of the longer one
_FARTHER = 1.0  # millimetres past the tip of the short one, where the symbol of the long one begins
# Millimetres from the point from where on bars are kept off, with demerits
_LEAVINGS = {LEAVING: 0.0, 5.4: 0.4, 7.5: 1.0}


class Stance(Struct, frozen=True):
    """Millimetres between two arrows, from the point or the end of the rod to their tails, and by
    which they stand farther from the ground.
    """

    apart: float
    tail: float
    lifted: float = 0.0


AT_PIN = Stance(2.0, 0.5)
IN_BLOCK = Stance(1.4, 0.75, 0.2)  # on the ground, whose block has an edge on which neither lies
# Of a rod, along which both tails lie: they hang in the air beside nothing
AT_END = Stance(BOLD.width + FIRM.width, -0.4)


def list_twins(
    on_line: MovingArrow, open_side: Vector, stance: Stance, *, short: bool
) -> Iterator[MovingArrow]:
    """The short arrow of two, on the open side of the line, or the long one on the other side."""
    across = on_line.toward.turned()
    side = across if across.dot(open_side) >= 0 else -across
    outward = side if short else -side
    start = on_line.point + on_line.toward * stance.tail + side * stance.lifted
    twin = replace(on_line, start=start + outward * (stance.apart / 2), size=ARROW, outward=outward)
    if not short:
        twin = replace(twin, size=LONG, lettered=ARROW + _FARTHER)
    for leaving, close in _LEAVINGS.items():
        yield replace(twin, leaving=leaving, demerit=on_line.demerit + close)


def list_lanes(toward: Vector) -> list[Vector]:
    """The steps from the line of motion to either arrow, wherever the ground is."""
    across = toward.turned() * (AT_PIN.apart / 2)
    return [across, -across]
