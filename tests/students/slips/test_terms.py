"""Terms of points that students take wrongly: Coriolis, normal and transport terms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flint import fmpq

from kinegrade.mechanics.joints import GROUND, Pin, Roll, Slide
from kinegrade.mechanics.motion import solve_motion
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.slips import Slips
from tests.mechanics.writing import Paper, X, Y
from tests.students.slips.slipped_mechanisms import crank_and_rod, slipped, slot


@pytest.mark.parametrize(
    ("shares", "acceleration"),
    [
        ({}, (-12, 20)),
        ({"coriolis": 0}, (-12, 0)),
        ({"coriolis": fmpq(1, 2)}, (-12, 10)),
        ({"coriolis": -1}, (-12, -20)),
        ({"path_normal": 0}, (0, 20)),
        ({"path_normal": -1}, (12, 20)),
        ({"square": 0}, (-6, 20)),
    ],
)
def test_coriolis_and_normal_terms_of_a_point_in_a_turning_slot(
    shares: dict[str, Any], acceleration: tuple[int, int]
) -> None:
    p, mechanism = slot()
    motion = slipped(mechanism, p.field, **shares)
    assert motion.acceleration("M", "M") == acceleration
    assert motion.velocity("M", "M") == (5, 6)
    assert motion.coriolis("M", "M", "OC") == (0, 20 * shares.get("coriolis", 1))


def test_magnitudes_added_in_place_of_vectors() -> None:
    p, mechanism = slot()
    motion = slipped(mechanism, p.field, vector_sum=0)
    velocity, acceleration = motion.velocity("M", "M"), motion.acceleration("M", "M")
    assert (velocity, acceleration) == ((5, 6), (-12, 20))
    assert velocity.magnitude(p.field) == 11
    assert acceleration.magnitude(p.field) == 32
    assert (velocity * 1).magnitude(p.field) ** 2 == 61


def test_the_transport_motion_in_the_other_of_two_slots() -> None:
    # M at (1, 2): the slot x = 1 turns with 3, v_e = (-6, 3), the one from O with 1, v_e = (-2, 1)
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "K": (1, 0), "M": (1, 2)},
        {"disc": "O K", "rod": "O", "M": "particle M"},
        [
            Pin("O", ("disc", "rod", GROUND)),
            Slide("M", "M", p.line(1, 0, Y), "disc"),
            Slide("M", "M", p.line(0, 0, (1, 2)), "rod"),
        ],
        [p.turns("disc", 3), p.turns("rod", 1)],
    )
    right = slipped(mechanism, p.field)
    assert right.relative_velocity("M", "M", "disc") == (0, -10)
    assert right.velocity("M", "M") == (-6, -7)
    motion = slipped(mechanism, p.field, own_transport=0)
    assert motion.velocity("M", "M") == (-2, 1 - 10)
    assert motion.relative_velocity("M", "M", "disc") == (0, -10)
    # of the disc's -9 (1, 2) the rod's -1 (1, 2) is left
    difference = right.acceleration("M", "M") - motion.acceleration("M", "M")
    assert difference == (-8, -16)
    assert motion.relative_acceleration("M", "M", "rod") == right.relative_acceleration(
        "M", "M", "rod"
    )


def test_one_run_of_arrays_gives_what_single_runs_give() -> None:
    _, mechanism = slot()
    plan = solve_motion(mechanism, Field()).plan
    motion = make_mistaken_motion(
        mechanism.map(float),
        Floats(),
        plan,
        Slips(
            coriolis=np.array([1.0, 0.0, 0.5, -1.0, 1.0]),
            path_normal=np.array([1.0, 1.0, 1.0, 1.0, 0.0]),
        ),
    )
    acceleration = motion.acceleration("M", "M")
    assert np.allclose(acceleration.x.astype(float), [-12, -12, -12, -12, 0])
    assert np.allclose(acceleration.y.astype(float), [20, 0, 10, -20, 20])


def test_a_forgotten_normal_term_of_the_crank_leaves_the_slider_without_acceleration() -> None:
    p, mechanism = crank_and_rod()
    assert slipped(mechanism, p.field).acceleration("B", "AB") == (9, 0)
    assert slipped(mechanism, p.field, path_normal=0).acceleration("B", "AB") == (0, 0)


def test_the_normal_term_about_a_base_point_is_not_that_of_a_path() -> None:
    # a wheel of radius 1 rolls with 3: the contact has 9 upwards, all of it about the centre
    p = Paper()
    wheel = p.mechanism(
        {"C": (0, 1), "K": (0, 0), "T": (0, 2)},
        {"W": "C K T"},
        [Roll("W", p.circle("C", 1), GROUND, p.line(0, 0, X))],
        [p.moves("C", "W", X, 3)],
    )
    assert slipped(wheel, p.field, path_normal=0).acceleration("K", "W") == (0, 9)
    assert slipped(wheel, p.field, relative_normal=0).acceleration("K", "W") == (0, 0)
    assert slipped(wheel, p.field, relative_normal=-1).acceleration("K", "W") == (0, -9)
    assert slipped(wheel, p.field, square=0).acceleration("K", "W") == (0, 3)
