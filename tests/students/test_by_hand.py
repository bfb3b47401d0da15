"""A motion worked out by hand: rounded terms, and the relative motion as it was solved for."""

from __future__ import annotations

import pytest
from flint import fmpq

from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.joints import GROUND, Line, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.motion import Motion, pose_mechanism, solve_motion
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.field import Field
from kinegrade.numbers.rounding import Rounded
from kinegrade.students.rounding.by_hand import WrittenReading, solve_by_hand


def slotted_rocker() -> Motion:
    """The crank OA (0.3 m, straight up, 2 rad/s) drives a block in the slot of CA, pinned 0.7 m to
    the left of O.
    """
    points = {
        "O": Vector(fmpq(0), fmpq(0)),
        "A": Vector(fmpq(0), fmpq(3, 10)),
        "C": Vector(fmpq(-7, 10), fmpq(0)),
    }
    slot = Line(points["C"], points["A"] - points["C"])
    joints = (
        Pin("O", (GROUND, "crank")),
        Pin("C", (GROUND, "rocker")),
        Slide("A", "crank", slot, "rocker"),
    )
    bodies = (Body("crank", ("O", "A")), Body("rocker", ("C",)))
    return solve_motion(
        Mechanism(points, bodies, joints, (Rotation("crank", fmpq(2), fmpq(0)),)), Field()
    )


def test_doubles_say_what_the_exact_motion_says() -> None:
    exact = slotted_rocker()
    doubles = exact.map(float)
    assert doubles.rates == {name: float(rate) for name, rate in exact.rates.items()}
    for body in ("crank", "rocker"):
        found, expected = doubles.acceleration("A", body), exact.acceleration("A", body)
        assert found == pytest.approx((float(expected.x), float(expected.y)), rel=1e-14)


def test_with_all_figures_the_plan_gives_the_exact_motion_again() -> None:
    exact = slotted_rocker()
    worked = solve_by_hand(exact.map(float), Rounded(14))
    assert worked.rates == pytest.approx(
        {name: float(rate) for name, rate in exact.rates.items()}, rel=1e-12
    )
    assert worked.changes == pytest.approx(
        {name: float(change) for name, change in exact.changes.items()}, rel=1e-12
    )


def test_every_rate_and_every_term_is_written_down() -> None:
    worked = solve_by_hand(slotted_rocker().map(float), Rounded(3))
    assert worked.omega("rocker") == 0.31  # 2 * 0.09 / 0.58 = 0.31034
    assert worked.velocity("A", "rocker") == (-0.093, 0.217)  # 0.31 * 0.3, 0.31 * 0.7
    rate = Rate("circling", "slider", "A", "rocker")
    reading = WrittenReading(Rounded(2), {})
    term = Term("arc", rate, Vector(0.123, 0.456), "A", "O", "rocker")
    assert [each.vector for each in reading.chain((term,))] == [(0.12, 0.46)]
    rates = {rate: 1.5, make_turning("rocker"): 0.31}
    assert term.velocity(rates, reading) == (-0.68, 0.18)  # -0.684, 0.1845
    assert term.normal(rates, reading) == (-0.28, -1.0)  # -0.27675, -1.026
    assert term.coriolis(rates, reading) == (-0.11, -0.42)  # 2 * 0.31 * (-0.18, -0.68)
    assert term.acceleration(rates, {rate: 2.0}, reading) == pytest.approx(
        (-0.28 - 0.91 - 0.11, -1.0 + 0.25 - 0.42)
    )


def test_a_relative_motion_that_was_solved_for_is_no_difference_of_rounded_vectors() -> None:
    worked = solve_by_hand(slotted_rocker().map(float), Rounded(2))
    (rate,) = (rate for name, rate in worked.rates.items() if name.kind == "sliding")
    relative = worked.relative_velocity("A", "crank", "rocker")
    assert relative == pytest.approx((0.7 * rate, 0.3 * rate), rel=0.05)
    assert relative != worked.velocity("A", "crank") - worked.velocity("A", "rocker")
    seen = worked.relative_acceleration("A", "crank", "rocker")
    assert seen.x * 0.3 == pytest.approx(seen.y * 0.7, rel=0.05)  # along the slot
    assert worked.relative_velocity("C", "rocker", "crank") == (
        worked.velocity("C", "rocker") - worked.velocity("C", "crank")
    )


def test_a_pose_has_nothing_to_be_worked_out() -> None:
    still = pose_mechanism(slotted_rocker().frames.mechanism, Field())
    assert solve_by_hand(still.map(float), Rounded(3)).rates == {}
