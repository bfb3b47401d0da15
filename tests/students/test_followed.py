"""Motions that follow from own values, against vector equations worked out by hand."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

import pytest

from kinegrade.errors import MechanismError
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.joints import GROUND, Line, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.students.following.followed import follow_values
from kinegrade.students.following.followed_terms import Share
from kinegrade.students.following.substituting import OwnValue

ROOT = sqrt(3)
LEVEL = Line(Vector(0.0, 0.0), Vector(1.0, 0.0))
SLOT = Line(Vector(-0.7, 0.0), Vector(0.7, 0.3))
Read = Callable[[Motion], float]


def slider_crank() -> Mechanism:
    """OA of 1 m at 60 degrees turns with -1 rad/s; AB of sqrt(3) m at a right angle to it; B at (2,
    0) on the level.
    """
    points = {"O": Vector(0.0, 0.0), "A": Vector(0.5, ROOT / 2), "B": Vector(2.0, 0.0)}
    joints = (Pin("O", (GROUND, "OA")), Pin("A", ("OA", "AB")), Slide("B", "AB", LEVEL, GROUND))
    return Mechanism(
        points,
        (Body("OA", ("O", "A")), Body("AB", ("A", "B"))),
        joints,
        (Rotation("OA", -1.0, 0.0),),
    )


def slotted_rocker() -> Mechanism:
    """OA of 0.3 m, straight up, turns with 2 rad/s; its block at A runs in the slot of CA, pinned
    0.7 m to the left.
    """
    points = {"O": Vector(0.0, 0.0), "A": Vector(0.0, 0.3), "C": Vector(-0.7, 0.0)}
    joints = (Pin("O", (GROUND, "OA")), Pin("C", (GROUND, "CA")), Slide("A", "OA", SLOT, "CA"))
    return Mechanism(
        points, (Body("OA", ("O", "A")), Body("CA", ("C",))), joints, (Rotation("OA", 2.0, 0.0),)
    )


def follow(mechanism: Mechanism, *own: OwnValue) -> Motion:
    floats = Floats()
    frames = build_frames(mechanism, floats)
    equations = [relation.equations() for relation in frames.relations]
    return follow_values(frames, plans.find_plan(frames.relations, equations, floats), own, floats)


def when(read: Read) -> Callable[[Motion], float | None]:
    """The reading, None as long as something of it is not determined."""

    def determined(motion: Motion) -> float | None:
        try:
            return float(read(motion))
        except (KeyError, MechanismError):
            return None

    return determined


def size(vector: Vector) -> float:
    return float(sqrt(vector.squared()))


def normal_of_rod(motion: Motion) -> Vector:
    return (motion.points["A"] - motion.points["B"]) * (motion.omega("AB") * motion.omega("AB"))


def test_without_own_values_the_motion_is_the_right_one() -> None:
    motion = follow(slider_crank())
    assert motion.omega("AB") == pytest.approx(1 / 3)  # the pole is 3 m from A, along OA
    assert motion.velocity("B", "AB") == pytest.approx((2 * ROOT / 3, 0))
    assert motion.acceleration("B", "AB") == pytest.approx((-2 / 9, 0))


def test_the_slider_goes_on_from_the_own_angular_velocity_of_the_rod() -> None:
    # a_B = a_A + alpha x AB - omega^2 AB with AB = (3, -sqrt 3)/2 and a_A = -(1, sqrt 3)/2 gives,
    # across the guide, alpha = (1 - omega^2)/sqrt 3, and along it a_B = -2 omega^2
    motion = follow(
        slider_crank(), OwnValue(when(lambda m: m.rates[make_turning("AB")]), 0.5, "velocity")
    )
    assert motion.omega("AB") == pytest.approx(0.5)
    assert motion.alpha("AB") == pytest.approx(ROOT / 4)
    assert motion.acceleration("B", "AB") == pytest.approx((-0.5, 0))
    # Of the same step: as it was found
    assert motion.velocity("B", "AB") == pytest.approx((2 * ROOT / 3, 0))


def test_the_slider_goes_on_from_the_own_speed_of_the_crank_pin() -> None:
    speed = OwnValue(when(lambda m: size(m.velocity("A", "OA"))), 2.0, "velocity", ("OA", "A"))
    motion = follow(slider_crank(), speed)
    assert motion.omega("OA") == -1  # given on the paper
    assert motion.velocity("A", "OA") == pytest.approx((ROOT, -1))
    assert motion.omega("AB") == pytest.approx(2 / 3)
    assert motion.velocity("B", "AB") == pytest.approx((4 * ROOT / 3, 0))


def test_a_component_leaves_the_other_one_alone() -> None:
    component = OwnValue(when(lambda m: m.velocity("A", "OA").x), 0.0, "velocity", ("OA", "A"))
    assert follow(slider_crank(), component).velocity("A", "OA") == pytest.approx((0, -0.5))


def test_two_own_values_of_which_one_follows_from_the_other() -> None:
    speed = OwnValue(when(lambda m: size(m.velocity("A", "OA"))), 2.0, "velocity", ("OA", "A"))
    rod = OwnValue(when(lambda m: m.rates[make_turning("AB")]), 0.5, "velocity")
    motion = follow(slider_crank(), rod, speed)
    assert motion.velocity("B", "AB") == pytest.approx((4 * ROOT / 3, 0))
    assert motion.acceleration("B", "AB") == pytest.approx((-0.5, 0))


def test_the_rocker_goes_on_from_an_own_angular_velocity_and_an_own_coriolis_acceleration() -> None:
    # across the slot, with CA = (0.7, 0.3): -1.2 * 0.7 = 0.58 alpha + 2 omega (v_r/CA) 0.58, v_r/CA
    # = -0.42/0.58
    turning = OwnValue(when(lambda m: m.rates[make_turning("CA")]), 0.5, "velocity")
    assert follow(slotted_rocker(), turning).alpha("CA") == pytest.approx(-0.42 / 0.58)
    right = follow(slotted_rocker())
    part = Share("coriolis", "A", "CA")
    halved = OwnValue(
        when(lambda m: size(m.coriolis("A", "OA", "CA"))),
        size(right.coriolis("A", "OA", "CA")) / 2,
        "acceleration",
        part=part,
    )
    motion = follow(slotted_rocker(), halved)
    assert size(motion.coriolis("A", "OA", "CA")) == pytest.approx(halved.value)
    assert motion.alpha("CA") == pytest.approx(-0.84 / 0.58 + 0.18 / 0.58 * 0.42 / 0.58)
    assert motion.omega("CA") == right.omega("CA")


def test_an_own_normal_part_leaves_the_angular_velocity_alone() -> None:
    # twice the normal part of AB: a_B = -2 omega^2 as if omega^2 were 2/9, although omega is 1/3
    part = Share("normal", "B", "A")
    own = OwnValue(
        when(lambda m: size(m.reading.normal(make_turning("AB"), "B", "A", normal_of_rod(m)))),
        2 * ROOT / 9,
        "acceleration",
        part=part,
    )
    motion = follow(slider_crank(), own)
    assert motion.acceleration("B", "AB") == pytest.approx((-4 / 9, 0))
    assert motion.omega("AB") == pytest.approx(1 / 3)


def test_an_own_acceleration_of_a_point_goes_on_to_what_hangs_on_it() -> None:
    # twice a_A, at a right angle to AB: it only turns AB more, with alpha = (2 - 1/9)/sqrt 3
    own = OwnValue(
        when(lambda m: size(m.acceleration("A", "OA"))), 2.0, "acceleration", ("OA", "A")
    )
    motion = follow(slider_crank(), own)
    assert motion.alpha("AB") == pytest.approx(17 / 9 / ROOT)
    assert motion.acceleration("B", "AB") == pytest.approx((-2 / 9, 0))


@pytest.mark.parametrize(
    "own",
    [
        # No magnitude is negative
        OwnValue(when(lambda m: abs(m.rates[make_turning("AB")])), -0.5, "velocity"),
        OwnValue(when(lambda m: m.omega("AB") ** 2), 0.25, "velocity"),  # no straight way to it
        OwnValue(when(lambda m: m.rates[make_turning("OA")]), 2.0, "velocity"),  # given
        # Of two rates
        OwnValue(
            when(lambda m: m.rates[Rate("sliding", "AB", "B")] + m.omega("AB")), 2.0, "velocity"
        ),
        OwnValue(lambda motion: None, 2.0, "velocity"),
    ],
)
def test_what_cannot_be_put_in_changes_nothing(own: OwnValue) -> None:
    assert follow(slider_crank(), own).rates == pytest.approx(follow(slider_crank()).rates)
