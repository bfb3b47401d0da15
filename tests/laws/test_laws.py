"""Laws of plane kinematics over all templates and over random mechanisms: one law, one test, its
name the sentence.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from flint import arb, fmpq
from hypothesis import assume, given

from kinegrade.errors import MechanismError
from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import Circle, Line, Pin
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.surd import Surd, enclose
from tests.laws.cases import (
    Case,
    cases,
    grown_cases,
    template_cases,
    well_conditioned,
    with_numbers,
)
from tests.laws.differences import double, hold_against_positions
from tests.laws.growing import mechanisms
from tests.laws.position import regularity


@given(cases())
def test_the_velocities_of_two_points_of_a_body_agree_along_the_line_that_joins_them(
    case: Case,
) -> None:
    with case.context():
        for body in case.mechanism.bodies:
            first = body.points[0]
            for second in body.points[1:]:
                along = case.motion.points[second] - case.motion.points[first]
                assert case.same(
                    along.dot(case.motion.velocity(first, body.name)),
                    along.dot(case.motion.velocity(second, body.name)),
                )


@given(cases())
def test_the_acceleration_of_b_is_that_of_a_plus_a_tangential_and_a_centripetal_part(
    case: Case,
) -> None:
    with case.context():
        for body in case.mechanism.bodies:
            for second in body.points[1:]:
                first = body.points[0]
                arm = case.motion.points[second] - case.motion.points[first]
                omega, alpha = case.motion.omega(body.name), case.motion.alpha(body.name)
                expected = (
                    case.motion.acceleration(first, body.name)
                    + arm.turned() * alpha
                    - arm * (omega * omega)
                )
                assert case.same(case.motion.acceleration(second, body.name), expected)


@given(cases())
def test_the_point_of_a_body_at_its_pole_has_no_velocity(case: Case) -> None:
    with case.context():
        for body in case.mechanism.bodies:
            if body.particle or case.arithmetic.is_zero(case.motion.omega(body.name)):
                continue
            arm = case.motion.pole(body.name, case.arithmetic) - case.motion.points[body.points[0]]
            velocity = case.motion.velocity(
                body.points[0], body.name
            ) + arm.turned() * case.motion.omega(body.name)
            assert case.same(velocity, Vector(0, 0))


@given(cases())
def test_all_bodies_that_meet_at_a_pin_move_there_alike(case: Case) -> None:
    with case.context():
        for pin in (joint for joint in case.mechanism.joints if isinstance(joint, Pin)):
            for body in pin.bodies[1:]:
                for quantity in (case.motion.velocity, case.motion.acceleration):
                    assert case.same(quantity(pin.point, body), quantity(pin.point, pin.bodies[0]))


@given(cases())
def test_twice_the_lengths_under_the_same_rotations_give_twice_the_speeds(case: Case) -> None:
    def grown(part: Any) -> Any:
        match part:
            case Line(point, direction):
                return Line(point * 2, direction)
            case Circle(centre, radius):
                return Circle(centre, radius * 2)
            case Component() | Circulation():
                return replace(part, velocity=part.velocity * 2, acceleration=part.acceleration * 2)
        return with_parts(part, grown)

    with case.context():
        points = {name: point * 2 for name, point in case.mechanism.points.items()}
        motion = case.solved(rebuilt(case.mechanism, points, grown))
        compare(case, motion, vector=lambda v: v * 2, turn=lambda w: w, change=lambda a: a)


@given(cases())
def test_the_mirrored_mechanism_moves_mirrored(case: Case) -> None:
    def flipped(vector: Vector) -> Vector:
        return Vector(vector.x, -vector.y)

    def mirrored(part: Any) -> Any:
        match part:
            case Line(point, direction):
                return Line(flipped(point), flipped(direction))
            case Component():
                return replace(part, direction=flipped(part.direction))
            case Rotation() | Circulation():
                return replace(part, velocity=-part.velocity, acceleration=-part.acceleration)
        return with_parts(part, mirrored)

    with case.context():
        points = {name: flipped(point) for name, point in case.mechanism.points.items()}
        motion = case.solved(rebuilt(case.mechanism, points, mirrored))
        compare(case, motion, vector=flipped, turn=lambda w: -w, change=lambda a: -a)


@given(cases())
def test_the_turned_mechanism_moves_turned(case: Case) -> None:
    def quarter(part: Any) -> Any:
        match part:
            case Line(point, direction):
                return Line(point.turned(), direction.turned())
            case Component():
                return replace(part, direction=part.direction.turned())
        return with_parts(part, quarter)

    with case.context():
        points = {name: point.turned() for name, point in case.mechanism.points.items()}
        motion = case.solved(rebuilt(case.mechanism, points, quarter))
        compare(case, motion, vector=lambda v: v.turned(), turn=lambda w: w, change=lambda a: a)


@given(cases())
def test_time_run_backwards_reverses_the_velocities_and_keeps_the_accelerations(case: Case) -> None:
    with case.context():
        drivers = tuple(
            replace(driver, velocity=-driver.velocity) for driver in case.mechanism.drivers
        )
        motion = case.solved(replace(case.mechanism, drivers=drivers))
        for point, body in case.marked():
            assert case.same(motion.velocity(point, body), -case.motion.velocity(point, body))
            assert case.same(
                motion.acceleration(point, body), case.motion.acceleration(point, body)
            )
        for body in case.turning():
            assert case.same(motion.omega(body), -case.motion.omega(body))
            assert case.same(motion.alpha(body), case.motion.alpha(body))


@given(cases())
def test_the_velocities_are_the_sum_of_what_each_driver_gives_alone(case: Case) -> None:
    with case.context():
        alone = [
            case.solved(only(case.mechanism, index)) for index in range(len(case.mechanism.drivers))
        ]
        for point, body in case.marked():
            together = sum((motion.velocity(point, body) for motion in alone), Vector(0, 0))
            assert case.same(case.motion.velocity(point, body), together)
        for body in case.turning():
            assert case.same(
                case.motion.omega(body), sum((motion.omega(body) for motion in alone), 0)
            )


@given(cases())
def test_at_rest_the_accelerations_are_linear_in_the_drivers_as_the_velocities_are(
    case: Case,
) -> None:
    with case.context():
        drivers = tuple(
            replace(driver, velocity=driver.velocity * 0, acceleration=driver.velocity)
            for driver in case.mechanism.drivers
        )
        motion = case.solved(replace(case.mechanism, drivers=drivers))
        for point, body in case.marked():
            assert case.same(motion.acceleration(point, body), case.motion.velocity(point, body))
        for body in case.turning():
            assert case.same(motion.alpha(body), case.motion.omega(body))


@given(cases())
def test_the_order_in_which_joints_and_bodies_are_named_changes_nothing(case: Case) -> None:
    with case.context():
        mechanism = replace(
            case.mechanism,
            bodies=case.mechanism.bodies[::-1],
            joints=case.mechanism.joints[::-1],
            drivers=case.mechanism.drivers[::-1],
        )
        compare(
            case, case.solved(mechanism), vector=lambda v: v, turn=lambda w: w, change=lambda a: a
        )


@given(cases())
def test_a_body_seen_from_another_moves_as_a_rigid_body_with_the_relative_rotation(
    case: Case,
) -> None:
    """Were the Coriolis part wrong, the accelerations of two points would not differ by the
    relative rotation's.
    """
    with case.context():
        for body, frame in (
            (body, frame) for body in case.mechanism.bodies for frame in case.turning()
        ):
            if body.particle:
                continue
            first, turn = body.points[0], case.motion.omega(body.name, frame)
            for second in body.points[1:]:
                arm = case.motion.points[second] - case.motion.points[first]
                speeds, changes = (
                    [seen(point, body.name, frame) for point in (first, second)]
                    for seen in (case.motion.relative_velocity, case.motion.relative_acceleration)
                )
                assert case.same(speeds[1] - speeds[0], arm.turned() * turn)
                assert case.same(
                    changes[1] - changes[0],
                    arm.turned() * case.motion.alpha(body.name, frame) - arm * (turn * turn),
                )


@given(cases())
def test_the_motion_is_what_differences_of_constructed_positions_give(case: Case) -> None:
    assume(regularity(case.mechanism) > 1e-4)
    hold_against_positions(case)


@given(mechanisms(groups=1))
def test_a_mechanism_is_refused_exactly_where_positions_do_not_determine_its_motion(
    mechanism: Mechanism,
) -> None:
    try:
        solve_motion(mechanism, Field())
        refused = False
    except MechanismError:
        refused = True
    assert refused == (regularity(mechanism) < 1e-9)


@given(cases())
def test_many_instances_at_once_in_doubles_agree_with_each_one_exactly(case: Case) -> None:
    assume(well_conditioned(case.mechanism))
    floats, factors = Floats(), np.array([1.0, 2.0, 0.5])
    with case.context():
        exact = case.motion

        def stacked(number: Any) -> Any:
            return double(number) * np.ones(3)

        mechanism = with_numbers(case.mechanism, stacked)
        mechanism = replace(
            mechanism,
            drivers=tuple(
                replace(
                    driver,
                    velocity=driver.velocity * factors,
                    acceleration=driver.acceleration * factors**2,
                )
                for driver in mechanism.drivers
            ),
        )
        with floats.context():
            motion = solve_motion(mechanism, floats, exact.plan)
        scale = size(exact)
        for point, body in case.marked():
            for coordinate in (0, 1):
                fast, slow = (
                    motion.velocity(point, body)[coordinate],
                    exact.velocity(point, body)[coordinate],
                )
                assert np.allclose(fast, double(slow) * factors, rtol=0, atol=1e-9 * scale)
                fast, slow = (
                    motion.acceleration(point, body)[coordinate],
                    exact.acceleration(point, body)[coordinate],
                )
                assert np.allclose(fast, double(slow) * factors**2, rtol=0, atol=1e-9 * scale**2)


@given(grown_cases())
def test_balls_hold_the_exact_motion_and_are_narrow(case: Case) -> None:
    balls = Balls(256)
    with balls.context():
        motion = solve_motion(with_numbers(case.mechanism, balls.number), balls)
        for body in case.turning():
            assert encloses(motion.omega(body), case.motion.omega(body))
            assert encloses(motion.alpha(body), case.motion.alpha(body))


@given(template_cases())
def test_the_plan_of_one_instance_serves_every_other(case: Case) -> None:
    with case.context():
        motion = solve_motion(case.mechanism, case.arithmetic, case.motion.plan)
        assert motion.plan is case.motion.plan
        compare(case, motion, vector=lambda v: v, turn=lambda w: w, change=lambda a: a)


def with_parts(part: Any, change: Any) -> Any:
    """A joint or driver with its lines and circles changed."""
    shapes = {
        name: change(getattr(part, name))
        for name in ("line", "circle", "on")
        if isinstance(getattr(part, name, None), (Line, Circle))
    }
    return replace(part, **shapes) if shapes else part


def rebuilt(mechanism: Mechanism, points: dict[str, Vector], change: Any) -> Mechanism:
    """A mechanism with other points, its joints and drivers changed."""
    return Mechanism(
        points,
        mechanism.bodies,
        tuple(change(joint) for joint in mechanism.joints),
        tuple(change(driver) for driver in mechanism.drivers),
    )


def only(mechanism: Mechanism, index: int) -> Mechanism:
    """The mechanism with all drivers but one at rest."""
    drivers = tuple(
        driver if place == index else replace(driver, velocity=driver.velocity * 0)
        for place, driver in enumerate(mechanism.drivers)
    )
    return replace(mechanism, drivers=drivers)


def compare(case: Case, motion: Motion, vector: Any, turn: Any, change: Any) -> None:
    """Hold a motion against the case's own, transformed."""
    assert case.marked()
    for point, body in case.marked():
        assert case.same(motion.velocity(point, body), vector(case.motion.velocity(point, body)))
        assert case.same(
            motion.acceleration(point, body), vector(case.motion.acceleration(point, body))
        )
    for body in case.turning():
        assert case.same(motion.omega(body), turn(case.motion.omega(body)))
        assert case.same(motion.alpha(body), change(case.motion.alpha(body)))


def size(motion: Motion) -> float:
    """The size of the rates: at least one, so that squares are no smaller."""
    return max([1.0, *(abs(double(rate)) for rate in motion.rates.values())]) * max(
        [
            1.0,
            *(abs(double(coordinate)) for point in motion.points.values() for coordinate in point),
        ]
    )


def encloses(ball: Any, exact: Any) -> bool:
    """Whether a ball meets the exact number and is narrower than 1e-30 of it."""
    value = enclose(exact, 400) if isinstance(exact, Surd) else arb(fmpq(exact))
    narrow = ball.rad() < arb("1e-30") if value == 0 else ball.rel_accuracy_bits() > 100
    return bool(ball.overlaps(value)) and narrow
