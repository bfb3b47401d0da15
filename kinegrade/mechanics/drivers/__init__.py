"""The drivers: what is imposed on the mechanism, each with its velocity and its acceleration."""

from __future__ import annotations

from typing import get_args

from kinegrade.mechanics.drivers.circulation import Circulation
from kinegrade.mechanics.drivers.component import Component
from kinegrade.mechanics.drivers.rotation import Rotation

Driver = Rotation | Component | Circulation
DRIVERS: tuple[type[Driver], ...] = get_args(Driver)

__all__ = ["DRIVERS", "Circulation", "Component", "Driver", "Rotation"]
