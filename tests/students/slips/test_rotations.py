"""Rotations that students take for others: absolute and relative ones, of gears and belts."""

from __future__ import annotations

import pytest
from flint import fmpq

from kinegrade.mechanics.joints import GROUND, Belt, Mesh, Pin, Slide
from kinegrade.mechanics.motion import solve_motion
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.field import Field
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.slips import Slips
from kinegrade.students.mistaking.unsuspecting import Unsuspecting
from tests.mechanics.writing import Paper
from tests.students.slips.slipped_mechanisms import crank_and_rod, planet, slipped, slot


def test_the_transport_velocity_for_the_absolute_one() -> None:
    # v_A = 4 to the left, the bar from (0, 0) to A = (3, 4): v_e = 16/5 across it, and not 4
    p = Paper()
    mechanism = p.mechanism(
        {"O": (3, 0), "A": (3, 4), "Q": (0, 0)},
        {"OA": "O A", "bar": "Q"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("Q", ("bar", GROUND)),
            Slide("A", "OA", p.line(0, 0, (3, 4)), "bar"),
        ],
        [p.turns("OA", 1)],
    )
    assert slipped(mechanism, p.field).omega("bar") == fmpq(16, 25)
    motion = slipped(mechanism, p.field, relative=0)
    assert motion.omega("bar") == fmpq(4, 5)
    assert motion.relative_velocity("A", "OA", "bar") == (fmpq(-4) + fmpq(16, 5), fmpq(-12, 5))
    assert slipped(slot()[1], p.field, relative=0).velocity("M", "M") == (0, 6)


@pytest.mark.parametrize(
    ("share", "omega", "v_A"),
    [
        ({}, 6, 6),
        ({"carried": 0}, 4, 6),
        ({"arm": 0}, 4, 4),
        ({"ratio": 0}, fmpq(2, 3), 6),
        ({"meshing": -1}, -2, 6),
    ],
)
def test_a_planet_on_a_fixed_circle(share: dict[str, int], omega: int, v_A: int) -> None:
    p, mechanism = planet()
    motion = slipped(mechanism, p.field, **share)
    assert motion.omega("II") == omega
    assert motion.velocity("A", "II") == (0, v_A)


@pytest.mark.parametrize(
    ("share", "omega"),
    [({}, 9), ({"carried": 0}, 6), ({"meshing": -1}, -3), ({"ratio": 0}, fmpq(9, 2))],
)
def test_gears_in_mesh_on_a_carrier(share: dict[str, int], omega: int) -> None:
    # omega_P - 3 = -2 (0 - 3)
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (3, 0)},
        {"arm": "O A", "P": "A", "S": "O"},
        [
            Pin("O", ("arm", "S", GROUND)),
            Pin("A", ("arm", "P")),
            Mesh("P", p.circle("A", 1), "S", p.circle("O", 2), "arm"),
        ],
        [p.turns("arm", 3), p.turns("S", 0)],
    )
    assert slipped(mechanism, p.field, **share).omega("P") == omega


@pytest.mark.parametrize(
    ("share", "crossed", "omega"),
    [
        ({}, False, -3),
        ({}, True, 9),
        ({"crossing": -1}, False, 9),
        ({"crossing": -1}, True, -3),
        ({"meshing": -1}, True, 9),
        ({"carried": 0}, True, 6),
        ({"ratio": 0}, True, fmpq(9, 2)),
    ],
)
def test_a_belt_on_a_carrier(share: dict[str, int], crossed: bool, omega: int) -> None:
    # omega_P - 3 = +-2 (0 - 3); of the carrier's turning, 6 is lost with its share
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (4, 0)},
        {"arm": "O A", "P": "A", "S": "O"},
        [
            Pin("O", ("arm", "S", GROUND)),
            Pin("A", ("arm", "P")),
            Belt("P", p.circle("A", 1), "S", p.circle("O", 2), "arm", crossed),
        ],
        [p.turns("arm", 3), p.turns("S", 0)],
    )
    assert slipped(mechanism, p.field, **share).omega("P") == omega


def test_a_relative_turning_for_an_absolute_one_and_the_other_way_about() -> None:
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (3, 0), "B": (3, 1)},
        {"arm": "O A", "AB": "A B"},
        [Pin("O", ("arm", GROUND)), Pin("A", ("arm", "AB"))],
        [p.turns("arm", 3, 1), p.turns("AB", 4, 2, of="arm")],
    )
    assert slipped(mechanism, p.field).omega("AB") == 7
    assert slipped(mechanism, p.field, carried=0).omega("AB") == 4
    asked = slipped(mechanism, p.field, asked_relative=0)
    assert (asked.omega("AB", "arm"), asked.alpha("AB", "arm")) == (7, 3)
    assert slipped(mechanism, p.field).alpha("AB", "arm") == 2


def test_stirred_velocities_show_what_a_term_is_for() -> None:
    p, mechanism = crank_and_rod()  # the rod does not turn: its normal term is zero
    plan = solve_motion(mechanism, p.field).plan
    for perturbed, differs in ((False, False), (True, True)):
        right, wrong = (
            make_mistaken_motion(
                mechanism, p.field, plan, Slips(relative_normal=share), perturbed=perturbed
            )
            for share in (1, 0)
        )
        assert (right.alpha("AB") != wrong.alpha("AB")) is differs


def test_who_suspects_nothing_projects_and_does_not_check() -> None:
    unsuspecting = Unsuspecting(Field())
    one, zero = fmpq(1), fmpq(0)
    assert unsuspecting.solve([[one], [zero]], [fmpq(3), fmpq(5)]) == [3]
    assert unsuspecting.solve(
        [[one, zero], [zero, one], [zero, zero]], [fmpq(3), fmpq(5), fmpq(7)]
    ) == [3, 5]
    assert unsuspecting.require_zero(one) is None
    with pytest.raises(Singular):
        unsuspecting.solve([[one, one], [one, one]], [one, one])
