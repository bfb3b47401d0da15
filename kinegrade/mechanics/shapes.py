"""The shapes on which points and circles move: values at the instant, in the common frame (x right,
y up).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Line:
    """A straight line through `point` along `direction` (any length but zero)."""

    point: Vector
    direction: Vector


@dataclass(frozen=True)
class Circle:
    """A circle about the named point `centre`; `radius` in metres, positive."""

    centre: str
    radius: Any


Shape = Line | Circle
