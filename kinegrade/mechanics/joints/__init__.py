"""The joints: each a small frozen value that says which bodies meet, where and how, and what that
means for positions, velocities and accelerations.

Points are named; lines are values in the common frame at the instant (x right, y up). The ground is
the body `GROUND`.
"""

from __future__ import annotations

from typing import get_args

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints.arc import Arc
from kinegrade.mechanics.joints.belt import Belt
from kinegrade.mechanics.joints.contact import Contact
from kinegrade.mechanics.joints.mesh import Mesh
from kinegrade.mechanics.joints.parallel import Parallel
from kinegrade.mechanics.joints.pin import Pin
from kinegrade.mechanics.joints.roll import Roll
from kinegrade.mechanics.joints.sleeve import Sleeve
from kinegrade.mechanics.joints.slide import Slide
from kinegrade.mechanics.shapes import Circle, Line

Joint = Pin | Slide | Arc | Contact | Roll | Mesh | Belt | Sleeve | Parallel
JOINTS: tuple[type[Joint], ...] = get_args(Joint)

__all__ = [
    "GROUND",
    "JOINTS",
    "Arc",
    "Belt",
    "Circle",
    "Contact",
    "Joint",
    "Line",
    "Mesh",
    "Parallel",
    "Pin",
    "Roll",
    "Sleeve",
    "Slide",
]
