"""A direction by a named angle: that of the line along or normal to which it is, or an axis."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.worked.findings import Stated
from kinegrade.worked.formulas.formula import Formula

RIGHT = 90.0
CLOSE = 1e-6  # degrees


@dataclass(frozen=True)
class Inclination:
    """A direction as sign times a named angle plus right angles, counter-clockwise from +x.

    `angle` is None for a direction along an axis; `value` is that of the angle, in degrees.
    """

    sign: int
    angle: Formula | None
    value: float
    quarters: int


def relate(direction: float, line: Stated) -> Inclination | None:
    """A direction by the angle of a line along or normal to which it is; None for any other."""
    angle, sign, value = line
    quarters = (direction - sign * value) / RIGHT
    if abs(quarters - round(quarters)) > CLOSE:
        return None
    return Inclination(sign, angle, value, round(quarters))


def name_axis(direction: float) -> Inclination | None:
    """A direction along an axis, in degrees from +x; None for an oblique one."""
    quarters = round(direction / RIGHT)
    along = abs(direction / RIGHT - quarters) < CLOSE
    return Inclination(1, None, 0.0, quarters) if along else None
