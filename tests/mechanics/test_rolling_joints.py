"""Wheels, racks and gears on examples that can be worked out by hand: exact velocities and
accelerations of what rolls and meshes.
"""

from __future__ import annotations

from kinegrade.mechanics.joints import (
    GROUND,
    Mesh,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from tests.mechanics.writing import Paper, X


def test_roll_on_a_line_the_rolling_wheel() -> None:
    # r = 2, v_C = 6: omega = -3; top: 12; contact: v = 0, a = v^2/r = 18 upwards; a_C = 4: alpha =
    # -2
    p = Paper()
    motion = p.motion(
        {"C": (0, 2), "T": (0, 4), "F": (0, 0)},
        {"wheel": "C T F"},
        [Roll("wheel", p.circle("C", 2), GROUND, p.line(0, 0, X))],
        [p.moves("C", "wheel", X, 6, 4)],
    )
    assert motion.omega("wheel") == -3
    assert motion.alpha("wheel") == -2
    assert motion.velocity("T", "wheel") == (12, 0)
    assert motion.velocity("F", "wheel") == (0, 0)
    assert motion.acceleration("F", "wheel") == (0, 18)
    assert motion.pole("wheel", p.field) == (0, 0)


def test_roll_on_a_moving_bar_between_two_racks() -> None:
    # racks with 5 and 1 to the right, wheel of radius 1 between them: v_C = 3, omega = (1 - 5)/2 =
    # -2
    p = Paper()
    motion = p.motion(
        {"C": (0, 1), "U": (0, 2), "L": (0, 0)},
        {"upper": "U", "lower": "L", "wheel": "C"},
        [
            Sleeve("upper", p.line(0, 2, X), GROUND),
            Sleeve("lower", p.line(0, 0, X), GROUND),
            Roll("wheel", p.circle("C", 1), "upper", p.line(0, 2, X)),
            Roll("wheel", p.circle("C", 1), "lower", p.line(0, 0, X)),
        ],
        [p.moves("U", "upper", X, 5, 2), p.moves("L", "lower", X, 1, -4)],
    )
    assert motion.omega("wheel") == -2
    assert motion.velocity("C", "wheel") == (3, 0)
    assert motion.alpha("wheel") == -3
    assert motion.acceleration("C", "wheel") == (-1, 0)


def test_roll_outside_a_fixed_circle() -> None:
    # arm 3 with 2 rad/s, planet radius 1 on a sun of 2: omega = 2*3/1 = 6, v of the far point = 2*6
    # = 12; alpha = 3*arm's
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (3, 0), "B": (4, 0), "D": (2, 0)},
        {"OA": "O A", "II": "A B D"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "II")),
            Roll("II", p.circle("A", 1), GROUND, p.circle("O", 2)),
        ],
        [p.turns("OA", 2, 5)],
    )
    assert motion.omega("II") == 6
    assert motion.alpha("II") == 15
    assert motion.velocity("B", "II") == (0, 12)
    assert motion.velocity("D", "II") == (0, 0)
    assert motion.acceleration("D", "II") == (-12 + 36, 0)  # arm's -4*3 and +36 towards A


def test_roll_inside_a_fixed_ring() -> None:
    # Cardan's circles: planet half as large as the ring: omega = -omega_arm, and a rim point runs
    # along a diameter
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0), "B": (1, 1), "C": (0, 0)},
        {"OA": "O A", "II": "A B C"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "II")),
            Roll("II", p.circle("A", 1), GROUND, p.circle("O", 2), inside=True),
        ],
        [p.turns("OA", 3)],
    )
    assert motion.omega("II") == -3
    assert motion.velocity("B", "II") == (3, 3)  # along the diameter through O and B = (1, 1)
    assert motion.acceleration("C", "II") == (0, 0)  # the middle of its stroke


def test_a_ring_rolling_around_a_fixed_circle_within_it() -> None:
    # ring radius 3 about a fixed circle of radius 2: centre on an arm of 1: contact on the far side
    # of O: at (-2, 0) v_C = (0, 1) = omega*(1 + 2): omega = 1/3
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "C": (1, 0), "F": (-2, 0)},
        {"arm": "O C", "ring": "C F"},
        [
            Pin("O", ("arm", GROUND)),
            Pin("C", ("arm", "ring")),
            Roll("ring", p.circle("C", 3), GROUND, p.circle("O", 2), inside=True),
        ],
        [p.turns("arm", 1)],
    )
    assert motion.omega("ring") == p.number("1/3")
    assert motion.velocity("F", "ring") == (0, 0)


def test_roll_on_a_circle_of_a_moving_body() -> None:
    # at the contact the sun has 4*2 = 8, the planet 1*3 - omega*1: omega = -5
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (3, 0), "D": (2, 0)},
        {"OA": "O A", "sun": "O", "II": "A D"},
        [
            Pin("O", ("OA", "sun", GROUND)),
            Pin("A", ("OA", "II")),
            Roll("II", p.circle("A", 1), "sun", p.circle("O", 2)),
        ],
        [p.turns("OA", 1, 1), p.turns("sun", 4, 4)],
    )
    assert motion.omega("II") == -5
    assert motion.alpha("II") == -5
    assert motion.velocity("D", "II") == motion.velocity("D", "sun") == (0, 8)


def test_mesh_outside_on_a_carrier() -> None:
    # relative to the carrier (2): sun 5 - 2 = 3, planet -3*2/1 = -6, absolute -4
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (3, 0)},
        {"arm": "O A", "sun": "O", "planet": "A"},
        [
            Pin("O", ("arm", "sun", GROUND)),
            Pin("A", ("arm", "planet")),
            Mesh("sun", p.circle("O", 2), "planet", p.circle("A", 1), "arm"),
        ],
        [p.turns("arm", 2, 1), p.turns("sun", 5)],
    )
    assert motion.omega("planet") == -4
    assert motion.alpha("planet") == 3  # relative to the carrier: sun -1, planet +2; absolute 3
    assert motion.omega("planet", "arm") == -6


def test_mesh_inside_with_a_fixed_ring() -> None:
    # ring of 4 fixed, planet of 1 inside on an arm of 3 with 2: omega_r = -2*4/1 = -8, absolute -6
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (3, 0)},
        {"arm": "O A", "planet": "A"},
        [
            Pin("O", ("arm", GROUND)),
            Pin("A", ("arm", "planet")),
            Mesh("planet", p.circle("A", 1), GROUND, p.circle("O", 4), "arm", inside=True),
        ],
        [p.turns("arm", 2, 3)],
    )
    assert motion.omega("planet") == -6
    assert motion.alpha("planet") == -9


def test_a_wheel_guided_twice_along_one_line_is_no_contradiction() -> None:
    # its centre in a guide that is written from right to left, and the wheel on its track: the same
    # condition twice
    p = Paper()
    motion = p.motion(
        {"C": (0, 2)},
        {"wheel": "C"},
        [
            Roll("wheel", p.circle("C", 2), GROUND, p.line(0, 0, X)),
            Slide("C", "wheel", p.line(9, 2, (-3, 0)), GROUND),
        ],
        [p.moves("C", "wheel", X, 6)],
    )
    assert motion.omega("wheel") == -3
    assert motion.velocity("C", "wheel") == (6, 0)
