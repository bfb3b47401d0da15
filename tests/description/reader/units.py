"""Units of measurement as factors to the units m, s and rad."""

from __future__ import annotations

import math
import re

FACTORS: dict[str, float] = {
    "1": 1.0,
    "m": 1.0,
    "mm": 1e-3,
    "cm": 1e-2,
    "dm": 1e-1,
    "km": 1e3,
    "in": 0.0254,
    "ft": 0.3048,
    "yd": 0.9144,
    "mi": 1609.344,
    "s": 1.0,
    "ms": 1e-3,
    "min": 60.0,
    "h": 3600.0,
    "rad": 1.0,
    "deg": math.pi / 180,
    "r": 2 * math.pi,
    "rev": 2 * math.pi,
    "rpm": 2 * math.pi / 60,
}

LENGTHS = {"m", "mm", "cm", "dm", "km", "in", "ft", "yd", "mi"}
POWER = re.compile(r"([A-Za-z]+|1)(?:\^\{?(-?\d+)\}?)?")


def factor_of(unit: str) -> float:
    """What one of the unit is in m, s and rad: `0.01` for `cm`."""
    above, *below = unit.split("/")
    factor = product_of(above)
    for part in below:
        factor /= product_of(part)
    return factor


def product_of(units: str) -> float:
    """The factor of units written side by side, each with its power."""
    factor = 1.0
    for word in units.replace("*", " ").replace(r"\,", " ").split():
        found = POWER.fullmatch(word)
        if found is None or found[1] not in FACTORS:
            raise ValueError(f"unit not understood: {word}")
        factor *= FACTORS[found[1]] ** int(found[2] or 1)
    return factor


def is_length(unit: str) -> bool:
    """Whether the unit is one of length."""
    return unit in LENGTHS
