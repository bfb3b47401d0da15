"""What a printed formula is worth: its value as printed, how far rounding may have moved it, its
value without any rounding where the page gives that, and its dimension.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

DUST = 1e-12


class Unreadable(Exception):
    """The formula holds something that has no value here."""


class MixedUnits(Exception):
    """The formula adds a length to a speed, or takes the sine of a length."""


@dataclass(frozen=True)
class Amount:
    """A value in SI. `room` is how far rounding may have moved it; `precise` the value before any
    rounding, None where the page shows rounded numbers alone; `metres` and `seconds` are the
    exponents of its unit, radians are pure numbers.
    """

    value: float
    room: float = 0.0
    precise: float | None = None
    metres: float = 0.0
    seconds: float = 0.0

    @property
    def is_pure(self) -> bool:
        """Whether it has no unit."""
        return self.metres == 0 and self.seconds == 0

    @property
    def is_zero(self) -> bool:
        """Whether it is nothing, which may stand in any sum without a unit."""
        return self.value == 0

    def has_unit_of(self, other: Amount) -> bool:
        """Whether two amounts may be added or be equal."""
        same = self.metres == other.metres and self.seconds == other.seconds
        return same or (self.is_zero and self.is_pure) or (other.is_zero and other.is_pure)


def make_exact(value: float, metres: float = 0.0, seconds: float = 0.0) -> Amount:
    """An amount that nothing has rounded."""
    return Amount(value, 0.0, value, metres, seconds)


def add(first: Amount, second: Amount, sign: int) -> Amount:
    """The sum, or with a sign of -1 the difference. Raises MixedUnits."""
    if not first.has_unit_of(second):
        raise MixedUnits
    unit = second if first.is_zero and first.is_pure else first
    precise = None
    if first.precise is not None and second.precise is not None:
        precise = first.precise + sign * second.precise
    value, room = first.value + sign * second.value, first.room + second.room
    return Amount(value, room, precise, unit.metres, unit.seconds)


def multiply(first: Amount, second: Amount) -> Amount:
    """The product; with a zero that has no unit a zero without one."""
    if any(one.is_zero and one.is_pure for one in (first, second)):
        return make_exact(0.0)
    precise = None
    if first.precise is not None and second.precise is not None:
        precise = first.precise * second.precise
    return Amount(
        first.value * second.value,
        abs(first.value) * second.room + abs(second.value) * first.room,
        precise,
        first.metres + second.metres,
        first.seconds + second.seconds,
    )


def raise_to(base: Amount, exponent: float) -> Amount:
    """A power. Raises Unreadable where it is no real number."""
    if base.value < 0 and exponent != int(exponent):
        if abs(base.value) > base.room + DUST:
            raise Unreadable
        base = Amount(0.0, base.room, base.precise and 0.0, base.metres, base.seconds)
    if base.value == 0 and exponent < 0:
        raise Unreadable
    value = base.value**exponent
    slope = abs(exponent * value / base.value) if base.value else 1.0
    precise = None if base.precise is None else abs(base.precise) ** exponent
    if precise is not None and base.value < 0:
        precise = math.copysign(precise, value)
    return Amount(
        value, slope * base.room, precise, base.metres * exponent, base.seconds * exponent
    )


def apply(name: str, argument: Amount) -> Amount:
    """A sine, cosine ... of an angle, or the angle of one. Raises MixedUnits."""
    if not argument.is_pure:
        raise MixedUnits
    work = getattr(math, {"arcsin": "asin", "arccos": "acos", "arctan": "atan"}.get(name, name))
    try:
        value = work(argument.value)
        moved = work(argument.value + argument.room), work(argument.value - argument.room)
        precise = None if argument.precise is None else work(argument.precise)
    except ValueError as fault:
        raise Unreadable from fault
    return Amount(value, max(abs(one - value) for one in moved), precise)
