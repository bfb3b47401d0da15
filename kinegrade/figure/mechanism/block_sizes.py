"""How large a block on a ground guide is: large enough to be seen around the members at its pin."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod, is_slender, list_ways
from kinegrade.figure.symbols.sliding import BLOCK_LENGTH, BLOCK_WIDTH
from kinegrade.mechanics.vector import Vector


class BlockSize(Struct, frozen=True):
    """The sides of a block in millimetres, along its guide and across."""

    length: float
    width: float


_USUAL = BlockSize(BLOCK_LENGTH, BLOCK_WIDTH)
_ABOUT_HALF_PIN = BlockSize(5.6, 4.2)  # a bar runs on through the pin, which sits beside it
_UNDER_BROAD_BAR = BlockSize(6.6, 4.8)  # a slotted link, a rack


def choose_block_size(at: Vector, parts: Sequence[Part]) -> BlockSize:
    """The size of the block whose pin is at a point."""
    bars = [part for part in parts if isinstance(part, Bar | Rod) and list_ways(part, at)]
    if any(not is_slender(bar) for bar in bars):
        return _UNDER_BROAD_BAR
    if any(len(list_ways(bar, at)) > 1 for bar in bars):
        return _ABOUT_HALF_PIN
    return _USUAL
