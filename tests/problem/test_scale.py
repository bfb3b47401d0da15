"""The scale of a mechanism: the largest quantity of each kind that occurs in it."""

from __future__ import annotations

import pytest

from kinegrade.numbers.units import read_unit
from kinegrade.problem.scale import find_scale
from kinegrade.problem.solving import solve_template
from tests.problem.crank import crank

ACCELERATED = ('velocity = "omega"', 'velocity = "omega", acceleration = "-7*omega**2"')


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        ("m", 5.0),
        ("mm", 5000.0),
        ("m/s", 10.0),
        ("mm/s", 10000.0),
        ("rad/s", 2.0),
        ("m/s^2", 20.0),
        ("rad/s^2", 4.0),
        ("1", 1.0),
        ("rad", 1.0),
        ("deg", 57.3),
    ],
)
def test_a_uniform_crank_of_five_metres_turning_at_two(unit: str, size: float) -> None:
    motion = solve_template(crank(), {"r": "5", "h": "3", "omega": "-2"}).motion
    assert find_scale(motion, read_unit(unit)) == pytest.approx(size, rel=1e-12)


def test_angular_acceleration_counts_where_it_is_the_larger() -> None:
    motion = solve_template(crank(ACCELERATED), {"r": "5", "h": "3", "omega": "2"}).motion
    assert find_scale(motion, read_unit("rad/s^2")) == pytest.approx(28.0)
    assert find_scale(motion, read_unit("m/s^2")) == pytest.approx(20 * 50**0.5)
