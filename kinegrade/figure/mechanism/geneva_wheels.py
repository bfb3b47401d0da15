"""Geneva wheels: open slots, which the pin of a crank enters without a shock, and between them
the hollows for the locking disc of the crank.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import asin, pi

from kinegrade.errors import TemplateError
from kinegrade.figure.joints.symbol import Symbol, find_fixed_pin
from kinegrade.figure.mechanism.straight_parts import GenevaWheel
from kinegrade.figure.plane import NEAR, angle_of, length, polar
from kinegrade.figure.scene import FIRM, Bow, Outline
from kinegrade.figure.symbols.bars import SLOT_WIDTH
from kinegrade.figure.symbols.pins import PIN
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_FEWEST = 3  # slots: with two the crank would be as long as the distance of the pivots
_ROOM = 1.5  # times the lip of a slot: at least half of what is between two slots
_PAST_PIN = 0.2  # millimetres between the pin where it is deepest and the end of its slot
_LIP = 2.5  # times half the width of a slot: from its middle to where a hollow begins


def find_geneva_wheels(
    mechanism: Mechanism, symbols: Sequence[Symbol], shapes: Mapping[str, str]
) -> Iterator[GenevaWheel]:
    """The wheels of the bodies of that shape. Raises TemplateError for one without a crank."""
    for body in mechanism.bodies:
        if shapes.get(body.name) == "geneva" and body.points:
            wheel = _find_wheel(mechanism, symbols, body.name, body.points[0])
            if wheel is None:
                what = Message("figure.no-crank-of-geneva-wheel")
                raise TemplateError(Fault(f"figure.shapes.{body.name}", what))
            yield wheel


def _find_wheel(
    mechanism: Mechanism, symbols: Sequence[Symbol], body: str, centre: str
) -> GenevaWheel | None:
    """A wheel by the crank whose pin is in its slot; None where none reaches it."""
    at = mechanism.points
    slid = {
        symbol.point: feature.action
        for symbol in symbols
        for feature in symbol.features
        if feature.body == body and symbol.point
    }
    for crank in mechanism.bodies:
        pivot = find_fixed_pin(symbols, crank.name)
        pins = [slid[name] for name in crank.points if name in slid]
        if pivot and pins and NEAR < length(pins[0] - at[pivot]) < length(at[centre] - at[pivot]):
            return GenevaWheel(body, at[centre], at[pivot], pins[0])
    return None


def trace_geneva_wheel(wheel: GenevaWheel) -> Outline:
    """Slot by slot: from its mouth to its round end and back, then the hollow up to the next."""
    return Outline(tuple(_list_corners(wheel)), FIRM, "grey")


def _list_corners(wheel: GenevaWheel) -> Iterator[Vector]:
    facing, half = angle_of(wheel.pin - wheel.centre), SLOT_WIDTH / 2
    depth = wheel.deepest + half - PIN - _PAST_PIN
    lip = _LIP * half / wheel.radius  # the angle between the middle of a slot and its hollow
    slots = _count_slots(wheel, lip)
    step = 2 * pi / slots
    for number in range(slots):
        turn = facing + number * step
        out, across = polar(turn), polar(turn).turned() * half
        mouth = wheel.centre + out * wheel.radius
        yield wheel.centre + polar(turn - lip, wheel.radius)
        yield mouth - across
        yield from reversed(Bow(wheel.centre + out * depth, half, turn + pi / 2, pi, FIRM).path())
        yield mouth + across
        yield wheel.centre + polar(turn + lip, wheel.radius)
        yield from _trace_hollow(wheel, turn + step / 2, step / 2 - lip)


def _count_slots(wheel: GenevaWheel, lip: float) -> int:
    """The number at which the pin leaves one slot where the next is to enter, so far as hollows
    have room between them.
    """
    away, crank = length(wheel.centre - wheel.pivot), length(wheel.pin - wheel.pivot)
    return max(_FEWEST, min(round(pi / asin(crank / away)), int(pi / (_ROOM * lip))))


def _trace_hollow(wheel: GenevaWheel, turn: float, reach: float) -> tuple[Vector, ...]:
    """The arc about the pivot of the crank, as that stands while the wheel rests, within an angle
    on either side of a direction.
    """
    middle = wheel.centre + polar(turn, length(wheel.pivot - wheel.centre))
    ends = [wheel.centre + polar(turn + side * reach, wheel.radius) - middle for side in (-1, 1)]
    first, last = map(angle_of, ends)
    sweep = (last - first) % (2 * pi) - 2 * pi
    return Bow(middle, length(ends[0]), first, sweep, FIRM).path(0.08)[1:-1]
