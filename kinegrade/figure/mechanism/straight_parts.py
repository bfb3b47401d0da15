"""The straight parts of bodies as values, in millimetres on paper."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeGuard

from msgspec import Struct

from kinegrade.figure.joints.symbol import NO_BACK, Guide, Use
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.plane import NEAR, length, nearest_of, unit
from kinegrade.figure.scene import BOLD, Fill
from kinegrade.figure.symbols.bars import BAR_WIDTH, SLOT_WIDTH
from kinegrade.mechanics.vector import Vector

_SLENDER: frozenset[Use] = frozenset(("link", "bar", "face"))
_CLEAR = 1.0  # millimetres of a bar beyond a point from which on it is seen to run on


class Bar(Struct, frozen=True):
    """One straight part; `free` are its ends without a marked point, `actions` the points where
    other bodies slide or rest on it.

    A rack has its pitch line as axis and its material in the direction `back`; a jaw starts at its
    pivot and has its teeth on the side away from `back`. A slotted bar in front of a disc is
    white. On a broad one an axis is drawn.
    """

    body: str
    start: Vector
    end: Vector
    use: Use = "link"
    free: tuple[Vector, ...] = ()
    actions: tuple[Vector, ...] = ()
    back: Vector = NO_BACK
    fill: Fill = "grey"


class SlottedDisc(Struct, frozen=True):
    """A body whose slot passes beside its only point, or whose shape is "disc": a disc about its
    first point.
    """

    body: str
    centre: Vector
    radius: float
    slot: tuple[Vector, Vector]

    def list_edges(self) -> tuple[tuple[Vector, Vector], ...]:
        """The two straight edges of the slot."""
        start, end = self.slot
        aside = unit(end - start).turned() * (SLOT_WIDTH / 2)
        return (start + aside, end + aside), (start - aside, end - aside)


class GenevaWheel(Struct, frozen=True):
    """A wheel about its `centre` with radial slots, in one of which is the `pin` of a crank about
    `pivot`.
    """

    body: str
    centre: Vector
    pivot: Vector
    pin: Vector

    @property
    def radius(self) -> float:
        """From the centre to the mouths of the slots: there the crank is at a right angle to a
        slot, so that its pin enters along it.
        """
        away, crank = length(self.centre - self.pivot), length(self.pin - self.pivot)
        return float((away**2 - crank**2) ** 0.5)

    @property
    def deepest(self) -> float:
        """From the centre to where the pin comes nearest to it."""
        return length(self.centre - self.pivot) - length(self.pin - self.pivot)


class Rod(Struct, frozen=True):
    """A body that translates in a straight ground guide near its end, or with a piston in a closed
    cylinder, whose ground is at its end; `free` are its ends without a marked point.
    """

    body: str
    start: Vector
    end: Vector
    free: tuple[Vector, ...]
    cylinder: bool = False


Part = Bar | Plate | SlottedDisc | GenevaWheel | Rod


def is_slender(part: Part) -> TypeGuard[Bar | Rod]:
    """Whether a part is drawn as one bold line."""
    return isinstance(part, Rod) or (isinstance(part, Bar) and part.use in _SLENDER)


def find_guided_rack(guide: Guide, parts: Iterable[Part]) -> Bar | None:
    """The rack that slides along itself in a ground guide; None where another part does."""
    racks = (
        part
        for part in parts
        if isinstance(part, Bar) and part.use == "rack" and part.body == guide.body
    )
    return next((rack for rack in racks if _lies_along(rack, guide.along)), None)


def _lies_along(bar: Bar, along: Vector) -> bool:
    return bool(abs((bar.end - bar.start).cross(along)) < NEAR * length(bar.end - bar.start))


def find_half_width(part: Bar | Rod) -> float:
    """Half the width of a straight part across its axis, in millimetres."""
    return (BOLD.width if is_slender(part) else BAR_WIDTH) / 2


def list_ways(bar: Bar | Rod, at: Vector) -> list[Vector]:
    """The vectors from a point on a bar to those of its ends that are clear of it; none when the
    bar does not lead to the point.
    """
    if length(at - nearest_of(at, bar.start, bar.end)) > NEAR:
        return []
    return [end - at for end in (bar.start, bar.end) if length(end - at) > _CLEAR]
