"""Whether a vector of the motion is a velocity or an acceleration, which decides the unit of its
components.
"""

from __future__ import annotations

import pytest

from kinegrade.expressions.reading import read_expression
from kinegrade.worked.answers.asked_vectors import find_level


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ("velocity(A)", "velocity"),
        ("acceleration(A) - acceleration(B)", "acceleration"),
        ("acceleration(A) - (acceleration(B) - acceleration(C))", "acceleration"),
    ],
)
def test_components_of_an_acceleration_are_never_told_in_metres_per_second(
    text: str, level: str
) -> None:
    assert find_level(read_expression(text)) == level


def test_a_number_is_neither() -> None:
    with pytest.raises(TypeError, match="a number or a name is not a vector of the motion"):
        find_level(read_expression("2"))
