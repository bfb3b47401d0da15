"""Mechanisms on paper, and why they are refused."""

from __future__ import annotations

from typing import Any

import pytest

from kinegrade.errors import MechanismError
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import solve_motion
from tests.mechanics.writing import Paper

P = Paper()
POINTS = {"O": (0, 0), "A": (3, 0), "B": (8, 0), "C": (3, 4)}
BODIES = {"OA": "O A", "AB": "A B"}
CRANK = [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB"))]


def problem(mechanism: Mechanism) -> str:
    """The refusal of a mechanism, all its lines."""
    with pytest.raises(MechanismError) as refusal:
        solve_motion(mechanism, P.field)
    assert [line for line in refusal.value.problems if "\n" in line] == []
    return str(refusal.value)


def written(
    joints: Any, drivers: Any = (), points: Any = POINTS, bodies: Any = BODIES
) -> Mechanism:
    return P.mechanism(points, bodies, list(joints), list(drivers))
