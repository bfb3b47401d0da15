"""Every joint kind on an example that can be worked out by hand: exact velocities and
accelerations.
"""

from __future__ import annotations

from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Contact,
    Parallel,
    Pin,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.motion import solve_motion
from tests.laws.position import moving
from tests.mechanics.writing import Paper, X, Y


def test_pin_a_crank_of_two_metres() -> None:
    # v = 3*2 = 6 upwards; a = (-9*2, 4*2)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (2, 0)}, {"OA": "O A"}, [Pin("O", ("OA", GROUND))], [p.turns("OA", 3, 4)]
    )
    assert motion.velocity("A", "OA") == (0, 6)
    assert motion.acceleration("A", "OA") == (-18, 8)


def test_pin_four_bars_of_a_parallelogram() -> None:
    # the coupler translates, so B moves as A does: v = (0, 2*1), a = (-4*1, 5*1)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0), "B": (4, 1), "C": (3, 1)},
        {"OA": "O A", "AB": "A B", "CB": "C B"},
        [
            Pin("O", (GROUND, "OA")),
            Pin("A", ("OA", "AB")),
            Pin("B", ("AB", "CB")),
            Pin("C", ("CB", GROUND)),
        ],
        [p.turns("OA", 2, 5)],
    )
    assert motion.omega("AB") == 0
    assert motion.alpha("AB") == 0
    assert motion.omega("CB") == 2
    assert motion.alpha("CB") == 5
    assert motion.velocity("B", "AB") == (0, 2)
    assert motion.acceleration("B", "CB") == (-4, 5)


def test_pin_of_three_bodies_carries_one_motion_to_all() -> None:
    # v_A = (0, 2), a_A = (-4, 0); B on x = 1: v_B = (0 + omega, 2): omega_AB = 0
    # C on y = 0: v_C = (0, 2 + omega): omega_AC = -2; a_C = (-4 - 2^2*1, 0)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0), "B": (1, -1), "C": (2, 0)},
        {"OA": "O A", "AB": "A B", "AC": "A C"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB", "AC")),
            Slide("B", "AB", p.line(1, -1, Y), GROUND),
            Slide("C", "AC", p.line(0, 0, X), GROUND),
        ],
        [p.turns("OA", 2)],
    )
    assert motion.omega("AB") == 0
    assert motion.velocity("B", "AB") == (0, 2)
    assert motion.omega("AC") == -2
    assert motion.velocity("C", "AC") == (0, 0)
    assert motion.acceleration("C", "AC") == (-8, 0)
    assert motion.velocity("A", "AC") == motion.velocity("A", "AB") == (0, 2)


def test_slide_on_the_ground_slider_crank_with_the_crank_upright() -> None:
    # crank 3 upright, omega 2: v_A = (-6, 0); rod 5 from (0, 3) to (4, 0): instantaneous
    # translation: v_B = (-6, 0) a_A = (0, -12); a_B,y = 0 = -12 + 4 alpha: alpha = 3; a_B,x = 3
    # alpha = 9
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(0, 0, X), GROUND),
        ],
        [p.turns("OA", 2)],
    )
    assert motion.omega("AB") == 0
    assert motion.velocity("B", "AB") == (-6, 0)
    assert motion.alpha("AB") == 3
    assert motion.acceleration("B", "AB") == (9, 0)


def test_slide_on_a_moving_body_the_quick_return_slot() -> None:
    # crank 1 at A = (0, 1), pin of the rocker at C = (0, -1): v_A = (-2, 0) across the slot:
    # omega_CA = 2/2 = 1, v_r = 0 a_A = (0, -4): along the slot -4 = -1*2 + a_r: a_r = -2; across 0
    # = 2 alpha: alpha = 0
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (0, 1), "C": (0, -1)},
        {"OA": "O A", "CB": "C"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("C", ("CB", GROUND)),
            Slide("A", "OA", p.line(0, -1, Y), "CB"),
        ],
        [p.turns("OA", 2)],
    )
    assert motion.omega("CB") == 1
    assert motion.alpha("CB") == 0
    assert motion.relative_velocity("A", "OA", "CB") == (0, 0)
    assert motion.relative_acceleration("A", "OA", "CB") == (0, -2)


def test_slide_with_coriolis_acceleration() -> None:
    # v_A = (-2, 0): along CA -sqrt 2 = v_r, across it sqrt 2 = omega*CA: omega = 1
    # a_A = (0, -4): across CA -2 sqrt 2 = alpha*CA + 2*1*(-sqrt 2): alpha = 0; along CA -2 sqrt 2 =
    # -sqrt 2 + a_r
    p = Paper()
    motion = p.motion(
        {"O": (1, 0), "A": (1, 1), "C": (0, 0)},
        {"OA": "O A", "CB": "C"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("C", ("CB", GROUND)),
            Slide("A", "OA", p.line(0, 0, (1, 1)), "CB"),
        ],
        [p.turns("OA", 2)],
    )
    assert motion.omega("CB") == 1
    assert motion.alpha("CB") == 0
    assert motion.relative_velocity("A", "OA", "CB") == (-1, -1)
    assert motion.coriolis("A", "OA", "CB") == (2, -2)
    assert motion.relative_acceleration("A", "OA", "CB") == (-1, -1)


def test_a_fixed_point_on_the_line_of_a_moving_body() -> None:
    # A, straight above O, runs to the left with 2: omega = 2/1; the bar does not slide at O at this
    # instant: alpha = 0
    p = Paper()
    motion = p.motion(
        {"A": (0, 1), "O": (0, 0)},
        {"AB": "A"},
        [Slide("A", "AB", p.line(0, 1, X), GROUND), Slide("O", GROUND, p.line(0, 1, Y), "AB")],
        [p.moves("A", "AB", (-1, 0), 2)],
    )
    assert motion.omega("AB") == 2
    assert motion.alpha("AB") == 0
    assert motion.velocity("O", "AB") == (0, 0)
    assert motion.acceleration("O", "AB") == (
        0,
        4,
    )  # omega^2 towards A, which the sliding of O takes up


def test_sleeve_bar_through_a_swivelling_sleeve_at_45_degrees() -> None:
    # A = (1, 1), v_A = (-2, 0): across OA: sqrt 2 = omega*sqrt 2: omega = 1; along: v_r = -sqrt 2
    # a_A = 0: across: 0 = alpha*sqrt 2 + 2*1*(-sqrt 2): alpha = 2
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 1)},
        {"AC": "A", "AB": "A O", "sleeve": "O"},
        [
            Parallel("AC", GROUND),
            Slide("A", "AC", p.line(0, 1, X), GROUND),
            Pin("A", ("AC", "AB")),
            Pin("O", (GROUND, "sleeve")),
            Sleeve("AB", p.line(0, 0, (1, 1)), "sleeve"),
        ],
        [p.moves("A", "AC", (-1, 0), 2)],
    )
    assert motion.omega("AB") == motion.omega("sleeve") == 1
    assert motion.alpha("AB") == motion.alpha("sleeve") == 2
    assert motion.velocity("O", "AB") == (-1, -1)


def test_arc_a_crank_pin_in_a_circular_slot_is_a_hidden_connecting_rod() -> None:
    # the hidden rod DP = (-2, 0) lies along the guide of BC: v_D = v_P = (-3, 0), so the rod does
    # not turn; a_P = (0, -9) has no part along the rod: a_D = 0
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "P": (0, 1), "D": (2, 1)},
        {"OP": "O P", "BC": "D"},
        [
            Pin("O", ("OP", GROUND)),
            Sleeve("BC", p.line(0, 0, X), GROUND),
            Arc("P", "OP", p.circle("D", 2), "BC"),
        ],
        [p.turns("OP", 3)],
    )
    assert motion.velocity("D", "BC") == (-3, 0)
    assert motion.acceleration("D", "BC") == (0, 0)
    assert motion.relative_acceleration("P", "OP", "BC") == (0, -9)


def test_contact_of_a_circle_and_a_line_flat_follower() -> None:
    # centre C = (3, 4)/5 from O, radius 1, omega 5: v_C = (-4, 3): the follower rises with 3; a_C,y
    # = -25*4/5 = -20
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "C": ("3/5", "4/5"), "B": (0, "9/5")},
        {"cam": "O C", "BC": "B"},
        [
            Pin("O", ("cam", GROUND)),
            Parallel("BC", GROUND),
            Slide("B", "BC", p.line(0, 0, Y), GROUND),
            Contact("cam", p.circle("C", 1), "BC", p.line(0, "9/5", X)),
        ],
        [p.turns("cam", 5)],
    )
    assert motion.velocity("B", "BC") == (0, 3)
    assert motion.acceleration("B", "BC") == (0, -20)


def test_contact_of_two_circles_outside_is_a_rod_between_the_centres() -> None:
    # cam centre C = (1, 0), radius 1; roller of the follower D = (1, 3), radius 2, moving along y:
    # v_C = (0, 2): v_D = (0, 2) CD does not turn, as v_D,x = v_C,x = 0; a_C = (-4, 0) has no part
    # along CD: a_D = 0
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "C": (1, 0), "D": (1, 3)},
        {"cam": "O C", "stem": "D"},
        [
            Pin("O", ("cam", GROUND)),
            Sleeve("stem", p.line(0, 0, Y), GROUND),
            Contact("cam", p.circle("C", 1), "stem", p.circle("D", 2)),
        ],
        [p.turns("cam", 2)],
    )
    assert motion.velocity("D", "stem") == (0, 2)
    assert motion.acceleration("D", "stem") == (0, 0)


def test_contact_of_two_circles_inside_is_a_rod_of_the_difference_of_radii() -> None:
    # the rod CD = 3 - 1 stands upright over C = (1, 0): v_D = v_C = (0, 2), a_D = a_C,y = 1
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "C": (1, 0), "D": (1, -2)},
        {"cam": "O C", "stem": "D"},
        [
            Pin("O", ("cam", GROUND)),
            Sleeve("stem", p.line(0, 0, Y), GROUND),
            Contact("cam", p.circle("C", 1), "stem", p.circle("D", 3), inside=True),
        ],
        [p.turns("cam", 2, 1)],
    )
    assert motion.velocity("D", "stem") == (0, 2)
    assert motion.acceleration("D", "stem") == (0, 1)


def test_parallel_a_platform_that_does_not_turn_on_its_crank() -> None:
    # all points move like the crank's end: (0, 6), (-18, 2)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (2, 0), "B": (7, 7)},
        {"OA": "O A", "deck": "A B"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "deck")), Parallel("deck", GROUND)],
        [p.turns("OA", 3, 1)],
    )
    assert motion.omega("deck") == 0
    assert motion.alpha("deck") == 0
    assert motion.velocity("B", "deck") == (0, 6)
    assert motion.acceleration("B", "deck") == (-18, 2)


def test_parallel_to_a_moving_body() -> None:
    # the second arm keeps its angle with the first: it turns with it
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (2, 0), "B": (2, 1)},
        {"OA": "O A", "AB": "A B"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB")), Parallel("AB", "OA")],
        [p.turns("OA", 3)],
    )
    assert motion.omega("AB") == 3
    assert motion.velocity("B", "AB") == (-3, 6)


def test_redundant_joints_that_agree_the_elliptic_trammel_with_both_slots_and_its_crank() -> None:
    # crank OM = 5 with omega, rod AB = 10 about its midpoint M = (3, 4): the rod turns with -omega
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "M": (3, 4), "A": (6, 0), "B": (0, 8)},
        {"OM": "O M", "AB": "A M B"},
        [
            Pin("O", ("OM", GROUND)),
            Pin("M", ("OM", "AB")),
            Slide("A", "AB", p.line(0, 0, X), GROUND),
            Slide("B", "AB", p.line(0, 0, Y), GROUND),
        ],
        [p.turns("OM", 2, 1)],
    )
    motion = solve_motion(mechanism, p.field)
    assert motion.omega("AB") == -2
    assert motion.alpha("AB") == -1
    assert motion.velocity("A", "AB") == (-16, 0)
    assert motion.velocity("B", "AB") == (0, 12)
    assert motion.acceleration("A", "AB") == (
        -4 * 6 - 8,
        0,
    )  # x = 10 cos(phi): -omega^2 x - alpha*8
    assert abs(moving(mechanism).acceleration["A", "AB"][0] + 32) < 1e-9


def test_a_joint_has_to_say_how_it_relates_rates_if_only_not_at_all() -> None:
    """One that forgot it would leave its mechanism free, and be refused by another's name."""
    assert "relate_rates" in Constraint.__abstractmethods__
    assert "relate_rates" not in Pin.__abstractmethods__
