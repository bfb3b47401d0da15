"""The engine's motion held against the differences of independently constructed positions."""

from __future__ import annotations

from typing import Any

from flint import arb

from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.surd import Surd
from tests.laws.cases import Case
from tests.laws.position import moving


def hold_against_positions(case: Case) -> None:
    """Velocity and acceleration of every marked point and body against central differences."""
    assert case.marked()
    differences = moving(case.mechanism)
    with case.context():
        for body in case.mechanism.bodies:
            if not body.particle:
                assert near(case.motion.omega(body.name), differences.omega[body.name])
                assert near(case.motion.alpha(body.name), differences.alpha[body.name])
            for point in body.points:
                for coordinate in (0, 1):
                    velocity = differences.velocity[point, body.name][coordinate]
                    acceleration = differences.acceleration[point, body.name][coordinate]
                    assert near(case.motion.velocity(point, body.name)[coordinate], velocity)
                    assert near(
                        case.motion.acceleration(point, body.name)[coordinate], acceleration
                    )


def near(exact: Any, difference: Any) -> bool:
    """Equal to 1e-9 of the size, or absolutely where the size is small."""
    return abs(double(exact) - float(difference)) <= 1e-9 * max(1.0, abs(float(difference)))


def double(number: Any) -> float:
    """Any number as the nearest double."""
    return (
        float(number)
        if isinstance(number, (arb, Surd, PiMultiple, int, float))
        else int(number.p) / int(number.q)
    )
