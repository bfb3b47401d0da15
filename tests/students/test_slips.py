"""Every slip on an example that can be worked out by hand, one after the other exactly and all
together in arrays.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flint import fmpq

from kinegrade.mechanics.joints import GROUND, Belt, Mesh, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.slips import Slips
from kinegrade.students.mistaking.unsuspecting import Unsuspecting
from tests.mechanics.writing import Paper, X, Y


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


def test_a_fixed_pivot_for_the_pole_when_the_slider_drives() -> None:
    # v_B = (-8, 0) at 4 from O: 8/4 for both, in the sense of the crank
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(0, 0, X), GROUND),
        ],
        [p.moves("B", "AB", X, -8)],
    )
    assert slipped(mechanism, p.field).omega("OA") == fmpq(8, 3)
    motion = slipped(mechanism, p.field, pole=0)
    assert motion.omega("OA") == motion.omega("AB") == 2


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
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(4, 0, (3, 1)), GROUND),
        ],
        [p.moves("B", "AB", X, -6)],
    )
    right = slipped(mechanism, p.field)
    assert right.velocity("B", "AB") == (-6, -2)
    translating = slipped(mechanism, p.field, rotation=0)
    assert translating.omega("AB") == 0
    assert translating.omega("OA") * translating.omega("OA") == fmpq(40, 9)
    assert slipped(mechanism, p.field, neighbour=0).omega("AB") == right.omega("AB")


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
