"""Mechanisms on which students slip, and their motion with a slip."""

from __future__ import annotations

from typing import Any

from kinegrade.mechanics.joints import GROUND, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.slips import Slips
from tests.mechanics.writing import Paper, X


def slipped(mechanism: Mechanism, arithmetic: Any, **shares: Any) -> Motion:
    plan = solve_motion(mechanism, arithmetic).plan
    return make_mistaken_motion(mechanism, arithmetic, plan, Slips(**shares))


def slot() -> tuple[Paper, Mechanism]:
    """A bar turns with 2 about O; M, 3 from O, slides outwards with 5: a = (-2*2*3, 2*2*5)."""
    p = Paper()
    return p, p.mechanism(
        {"O": (0, 0), "C": (4, 0), "M": (3, 0)},
        {"OC": "O C", "M": "particle M"},
        [Pin("O", ("OC", GROUND)), Slide("M", "M", p.line(0, 0, X), "OC")],
        [p.turns("OC", 2), p.moves("M", "M", X, 5, of="OC")],
    )


def crank_and_rod() -> tuple[Paper, Mechanism]:
    """A crank of 3 upright with 2, a rod of 5 to a slider at (4, 0): v_A = v_B = (-6, 0), a_A = (0,
    -12), a_B = 9.
    """
    p = Paper()
    return p, p.mechanism(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(0, 0, X), GROUND),
        ],
        [p.turns("OA", 2)],
    )


def planet() -> tuple[Paper, Mechanism]:
    """A planet of radius 1 on a fixed circle of radius 2, its arm of 3 turns with 2: omega = 6, v_C
    = 12.
    """
    p = Paper()
    return p, p.mechanism(
        {"O": (0, 0), "A": (3, 0), "C": (4, 0)},
        {"arm": "O A", "II": "A C"},
        [
            Pin("O", ("arm", GROUND)),
            Pin("A", ("arm", "II")),
            Roll("II", p.circle("A", 1), GROUND, p.circle("O", 2)),
        ],
        [p.turns("arm", 2)],
    )


def rod_between_rockers() -> tuple[Paper, Mechanism]:
    """OA of 3 upright turns with 2: v_A = (-6, 0). BC of 5 turns with 3/8 and the rod AB with -3/8:
    v_B = 3/8 (-4, -3).
    """
    p = Paper()
    return p, p.mechanism(
        {"O": (0, 0), "A": (0, 3), "B": (3, 15), "C": (6, 11)},
        {"OA": "O A", "AB": "A B", "BC": "B C"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Pin("B", ("AB", "BC")),
            Pin("C", ("BC", GROUND)),
        ],
        [p.turns("OA", 2)],
    )
