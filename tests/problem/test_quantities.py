"""Every function of quantities has its row, and its row says all about it."""

from __future__ import annotations

from kinegrade.expressions.angular import ANGLES
from kinegrade.expressions.reading import read_expression
from kinegrade.problem.quantities.functions import needs_configurations
from kinegrade.problem.quantities.measures import MEASURES
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS


def test_a_level_follows_from_what_a_function_gives() -> None:
    levels = {name: function.level for name, function in MOTION_FUNCTIONS.items()}
    assert levels["omega"] == levels["relative_velocity"] == "velocity"
    assert levels["alpha"] == levels["coriolis"] == "acceleration"
    assert levels["pole"] is levels["circle_of_poles"] is None


def test_only_a_centrode_takes_further_configurations() -> None:
    assert needs_configurations(read_expression("radius(circle_of_poles(AB, phi))"))
    assert not needs_configurations(read_expression("x(pole(AB)) - x(velocity(A))"))


def test_a_measure_is_an_angle_where_expressions_take_it_for_one() -> None:
    assert ANGLES & MEASURES.keys() == {"angle", "between"}
