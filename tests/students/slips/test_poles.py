"""Poles that students take for the right one."""

from __future__ import annotations

import pytest
from flint import fmpq

from kinegrade.mechanics.joints import GROUND, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Mechanism
from tests.mechanics.writing import Paper, X
from tests.students.slips.slipped_mechanisms import crank_and_rod, rod_between_rockers, slipped


def test_the_centre_for_the_pole_of_a_rolling_wheel() -> None:
    p = Paper()
    wheel = p.mechanism(
        {"C": (0, 2), "K": (0, 0), "T": (0, 4)},
        {"W": "C K T"},
        [Roll("W", p.circle("C", 2), GROUND, p.line(0, 0, X))],
        [p.moves("C", "W", X, 4)],
    )
    motion = slipped(wheel, p.field, centre=0)
    assert motion.omega("W") == -2
    assert motion.velocity("T", "W") == (4, 0)  # and not 8
    assert motion.velocity("K", "W") == (-4, 0)  # and not 0
    assert motion.velocity("C", "W") == (4, 0)
    assert motion.acceleration("K", "W") == (0, 8)


def test_a_fixed_pivot_for_the_pole_makes_the_rod_turn_with_the_crank() -> None:
    p, mechanism = crank_and_rod()
    motion = slipped(mechanism, p.field, pole=0)
    assert motion.omega("AB") == 2
    assert motion.velocity("B", "AB") == (0, 8)  # 2 times OB
    assert motion.pole("AB", p.field) == (0, 0)


def rod_driven_by_its_slider(guide: tuple[int, int], speed: int) -> tuple[Paper, Mechanism]:
    """A crank OA and a rod whose end B is moved along a guide, its speed counted along x."""
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(4, 0, guide), GROUND),
        ],
        [p.moves("B", "AB", X, speed)],
    )
    return p, mechanism


def test_a_fixed_pivot_for_the_pole_when_the_slider_drives() -> None:
    # v_B = (-8, 0) at 4 from O: 8/4 for both, in the sense of the crank
    p, mechanism = rod_driven_by_its_slider(X, -8)
    assert slipped(mechanism, p.field).omega("OA") == fmpq(8, 3)
    motion = slipped(mechanism, p.field, pole=0)
    assert motion.omega("OA") == motion.omega("AB") == 2


@pytest.mark.parametrize(
    ("share", "rod", "rocker"),
    [
        ({}, fmpq(-3, 8), fmpq(3, 8)),
        ({"neighbour": 0}, 2, fmpq(3, 8)),  # as the crank
        ({"rotation": 0}, 0, fmpq(6, 5)),  # v_B = v_A
        ({"far_pivot": 0}, fmpq(-3, 5), fmpq(3, 5)),  # v_A over CA = 10
        ({"across": 0}, fmpq(-6, 13), fmpq(24, 13)),  # at P = (-13, 3): v_A over 13, times 20
    ],
)
def test_what_is_taken_for_the_rates_of_a_rod(
    share: dict[str, int], rod: fmpq, rocker: fmpq
) -> None:
    p, mechanism = rod_between_rockers()
    motion = slipped(mechanism, p.field, **share)
    assert (motion.omega("AB"), motion.omega("BC")) == (rod, rocker)
    # the end of the rod is as fast as that of the rocker, in its direction
    assert motion.velocity("B", "AB") == (-4 * rocker, -3 * rocker)
    assert motion.velocity("A", "AB") == (-6, 0)


def test_the_far_end_of_a_rod_for_its_pole() -> None:
    p, mechanism = rod_between_rockers()
    motion = slipped(mechanism, p.field, far_end=0)
    assert motion.omega("AB") * motion.omega("AB") == fmpq(36, 3**2 + 12**2)
    assert motion.omega("BC") == fmpq(3, 8)


def test_the_point_that_is_taken_for_the_pole_of_a_rod() -> None:
    p, mechanism = rod_between_rockers()
    places = {"far_pivot": (6, 11), "far_end": (3, 15), "across": (-13, 3)}
    for share, place in places.items():
        assert slipped(mechanism, p.field, **{share: 0}).pole("AB", p.field) == place


def test_a_rod_driven_by_its_slider_takes_the_velocity_from_there() -> None:
    # v_B = (-6, -2) along its guide; without rotation A is as fast, at 3 from O
    p, mechanism = rod_driven_by_its_slider((3, 1), -6)
    right = slipped(mechanism, p.field)
    assert right.velocity("B", "AB") == (-6, -2)
    translating = slipped(mechanism, p.field, rotation=0)
    assert translating.omega("AB") == 0
    assert translating.omega("OA") * translating.omega("OA") == fmpq(40, 9)
    assert slipped(mechanism, p.field, neighbour=0).omega("AB") == right.omega("AB")
