"""Motions that follow from own values, against vector equations worked out by hand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import sqrt

import pytest

from kinegrade.errors import MechanismError
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.joints import GROUND, Line, Pin, Sleeve, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles
from kinegrade.students.following.departures import state_equations
from kinegrade.students.following.followed import follow_values
from kinegrade.students.following.followed_terms import Share
from kinegrade.students.following.own_values import OwnValue

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


def swivelling_sleeve() -> Mechanism:
    """A block at A, 3 m above the fixed pin O, runs to the left with 3 m/s; AB goes through a
    sleeve at O.
    """
    points = {"O": Vector(0.0, 0.0), "A": Vector(0.0, 3.0)}
    top = Line(Vector(0.0, 3.0), Vector(1.0, 0.0))
    joints = (
        Pin("O", (GROUND, "s")),
        Slide("A", "AB", top, GROUND),
        Sleeve("AB", Line(Vector(0.0, 0.0), Vector(0.0, 1.0)), "s"),
    )
    bodies = (Body("AB", ("A", "O")), Body("s", ("O",)))
    driver = Component("A", "AB", Vector(-1.0, 0.0), 3.0, 0.0)
    return Mechanism(points, bodies, joints, (driver,))


def follow(mechanism: Mechanism, *own: OwnValue) -> list[Motion]:
    """The motions of all ways of going on."""
    doubles = Doubles()
    frames = build_frames(mechanism, doubles)
    equations = [relation.equations() for relation in frames.relations]
    plan = plans.find_plan(frames.relations, equations, doubles)
    places = [value.place for value in own if value.place]
    return list(follow_values(state_equations(frames, plan, places), own))


def any_way(
    mechanism: Mechanism, *own: OwnValue, expected: Mapping[str, tuple[Read, float]]
) -> bool:
    """Whether a way of going on gives all the numbers that are expected."""
    return any(
        all(read(motion) == pytest.approx(number) for read, number in expected.values())
        for motion in follow(mechanism, *own)
    )


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


def omega(body: str) -> Read:
    return lambda motion: motion.omega(body)


def alpha(body: str) -> Read:
    return lambda motion: motion.alpha(body)


def along_guide(motion: Motion) -> float:
    return float(motion.velocity("B", "AB").x)


def acceleration_along_guide(motion: Motion) -> float:
    return float(motion.acceleration("B", "AB").x)


def turning(body: str, value: float) -> OwnValue:
    return OwnValue(when(omega(body)), value, "velocity")


SPEED_OF_PIN = OwnValue(when(lambda m: size(m.velocity("A", "OA"))), 2.0, "velocity", ("OA", "A"))


def test_without_own_values_the_motion_is_the_right_one() -> None:
    for motion in follow(slider_crank()):
        assert motion.omega("AB") == pytest.approx(1 / 3)  # the pole is 3 m from A, along OA
        assert motion.velocity("B", "AB") == pytest.approx((2 * ROOT / 3, 0))
        assert motion.acceleration("B", "AB") == pytest.approx((-2 / 9, 0))


@pytest.mark.parametrize(
    "speed",
    [
        # v_B = v_A + omega x AB, with v_A = (sqrt 3, -1)/2 and AB = (3, -sqrt 3)/2
        pytest.param(ROOT / 2 + 0.5 * ROOT / 2, id="along the guide"),
        pytest.param(2 * ROOT * 0.5, id="2 sqrt 3 from the pole"),
        pytest.param(2 * ROOT / 3, id="by projection on AB, without omega"),
        # Across the guide it is -1/2 + 0.5 * 3/2
        pytest.param((27 / 16 + 1 / 16) ** 0.5, id="magnitude of the sum"),
    ],
)
def test_the_slider_goes_on_from_the_own_angular_velocity_of_the_rod(speed: float) -> None:
    # a_B = a_A + alpha x AB - omega^2 AB with a_A = -(1, sqrt 3)/2 gives, across the guide,
    # alpha = (1 - omega^2)/sqrt 3, and along it a_B = -2 omega^2, however v_B was found
    expected = {
        "omega": (omega("AB"), 0.5),
        "v_B": (lambda m: size(m.velocity("B", "AB")), speed),
        "alpha": (alpha("AB"), ROOT / 4),
        "a_B": (acceleration_along_guide, -0.5),
    }
    if speed == (27 / 16 + 1 / 16) ** 0.5:
        del expected["a_B"]  # read as a sum it has a component across the guide too
    assert any_way(slider_crank(), turning("AB", 0.5), expected=expected)


def test_the_rod_goes_on_from_the_own_velocity_of_the_slider() -> None:
    # From the pole; along the guide, sqrt 3/2 + omega sqrt 3/2; across AB, 3/2 v_B... by hand:
    # v_BA = v_B - v_A, of which the component along (sqrt 3, 3)/2/sqrt 3 is omega sqrt 3
    own = OwnValue(when(along_guide), ROOT, "velocity", ("AB", "B"))
    for expected in (0.5, 1.0, (ROOT / 2 * 0.5 + 0.5 * ROOT / 2) / ROOT):
        assert any_way(slider_crank(), own, expected={"omega": (omega("AB"), expected)})


def test_the_slider_goes_on_from_the_own_speed_of_the_crank_pin() -> None:
    expected = {
        "given": (omega("OA"), -1.0),
        "v_Ax": (lambda m: m.velocity("A", "OA").x, ROOT),
        "omega": (omega("AB"), 2 / 3),
        "v_B": (along_guide, 4 * ROOT / 3),
    }
    assert any_way(slider_crank(), SPEED_OF_PIN, expected=expected)


def test_a_component_leaves_the_other_one_alone() -> None:
    component = OwnValue(when(lambda m: m.velocity("A", "OA").x), 0.1, "velocity", ("OA", "A"))
    expected = {
        "x": (lambda m: m.velocity("A", "OA").x, 0.1),
        "y": (lambda m: m.velocity("A", "OA").y, -0.5),
    }
    assert any_way(slider_crank(), component, expected=expected)


def test_two_own_values_of_which_one_follows_from_the_other() -> None:
    expected = {"v_B": (along_guide, 4 * ROOT / 3), "a_B": (acceleration_along_guide, -0.5)}
    assert any_way(slider_crank(), turning("AB", 0.5), SPEED_OF_PIN, expected=expected)


def test_the_acceleration_goes_on_from_the_own_angular_acceleration_of_the_rod() -> None:
    # a_B = -(1, sqrt 3)/2 + alpha x AB - omega^2 AB: along the guide
    # -1/2 + alpha sqrt 3/2 - 3/2 omega^2
    own = OwnValue(when(alpha("AB")), 2.0, "acceleration")
    expected = {"a_B": (acceleration_along_guide, -0.5 + ROOT - 1 / 6)}
    assert any_way(slider_crank(), own, expected=expected)


def test_an_equal_rate_is_one_with_its_own_value() -> None:
    # The sleeve of a rod turns as the rod does: omega = v_A/3 where OA is at a right angle
    assert any_way(swivelling_sleeve(), turning("AB", 0.9), expected={"s": (omega("s"), 0.9)})


def test_the_rocker_goes_on_from_an_own_angular_velocity_and_an_own_coriolis_acceleration() -> None:
    # across the slot, with CA = (0.7, 0.3): -1.2 * 0.7 = 0.58 alpha + 2 omega (v_r/CA) 0.58, v_r/CA
    # = -0.42/0.58
    expected = {"alpha": (alpha("CA"), -0.42 / 0.58)}
    assert any_way(slotted_rocker(), turning("CA", 0.5), expected=expected)
    right = follow(slotted_rocker())[0]
    half = size(right.coriolis("A", "OA", "CA")) / 2
    read = when(lambda m: size(m.coriolis("A", "OA", "CA")))
    halved = OwnValue(read, half, "acceleration", part=Share("coriolis", "A", "CA"))
    expected = {
        "part": (read, half),
        "alpha": (alpha("CA"), -0.84 / 0.58 + 0.18 / 0.58 * 0.42 / 0.58),
        "omega": (omega("CA"), right.omega("CA")),
    }
    assert any_way(slotted_rocker(), halved, expected=expected)


def test_an_own_normal_part_leaves_the_angular_velocity_alone() -> None:
    # twice the normal part of AB: a_B = -2 omega^2 as if omega^2 were 2/9, although omega is 1/3
    part = Share("normal", "B", "A")
    own = OwnValue(
        when(lambda m: size(m.reading.normal(make_turning("AB"), "B", "A", normal_of_rod(m)))),
        2 * ROOT / 9,
        "acceleration",
        part=part,
    )
    expected = {"a_B": (acceleration_along_guide, -4 / 9), "omega": (omega("AB"), 1 / 3)}
    assert any_way(slider_crank(), own, expected=expected)


def test_an_own_acceleration_of_a_point_goes_on_to_what_hangs_on_it() -> None:
    # twice a_A, at a right angle to AB: it only turns AB more, with alpha = (2 - 1/9)/sqrt 3
    own = OwnValue(
        when(lambda m: size(m.acceleration("A", "OA"))), 2.0, "acceleration", ("OA", "A")
    )
    expected = {"alpha": (alpha("AB"), 17 / 9 / ROOT), "a_B": (acceleration_along_guide, -2 / 9)}
    assert any_way(slider_crank(), own, expected=expected)


def test_the_magnitude_of_a_reversed_vector() -> None:
    own = OwnValue(when(lambda m: size(m.velocity("A", "OA"))), -1.0, "velocity", ("OA", "A"))
    expected = {"v_B": (along_guide, -2 * ROOT / 3), "omega": (omega("AB"), -1 / 3)}
    assert any_way(slider_crank(), own, expected=expected)


@pytest.mark.parametrize(
    "own",
    [
        OwnValue(when(lambda m: m.points["A"].x), 2.0, "velocity"),  # no rate moves it
        OwnValue(when(lambda m: m.omega("AB") ** 2 + 1), 0.25, "velocity"),  # out of reach
        OwnValue(lambda motion: None, 2.0, "velocity"),
    ],
)
def test_what_cannot_be_put_in_changes_nothing(own: OwnValue) -> None:
    for motion in follow(slider_crank(), own):
        assert motion.rates == pytest.approx(follow(slider_crank(), own)[0].rates)
        assert motion.omega("AB") == pytest.approx(1 / 3)
