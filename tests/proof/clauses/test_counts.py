"""`check` finds angles that are counted the other way round, whatever their lines are called."""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_faults


@pytest.mark.parametrize(
    "said",
    [
        "The crank makes the angle {{ phi }} with the positive $x$-axis, measured anticlockwise",
        "The crank has turned {{ phi }} anticlockwise from the horizontal to the right",
        "The angle from the horizontal to $OA$, anticlockwise, is {{ phi }}",
        "At {{ phi }} from the horizontal, anticlockwise, stands the crank",
        "Die Kurbel steht unter {{ phi }}, gegen den Uhrzeigersinn gezählt",
        "曲柄与水平线的夹角为 {{ phi }}（逆时针量取）",
    ],
)
def test_an_angle_that_no_line_has_when_it_is_counted_so_is_a_fault(said: str) -> None:
    assert find_faults("slider", said) == []
    changes = (("anticlock", "clock"), ("gegen den", "im"), ("逆", "顺"))
    wrong = said
    for change in changes:
        wrong = wrong.replace(*change)
    [fault] = find_faults("slider", wrong)
    assert fault.endswith(", and phi is counted the other way round")


@pytest.mark.parametrize(
    "said",
    [
        "The crank turns clockwise, and stands at {{ phi }}",  # which is the sense of its motion
        "Half a turn later it stands at {{ phi }}, counted clockwise",
        "The distance {{ r }} is counted clockwise, {{ e }}",
    ],
)
def test_what_is_no_count_of_an_angle_is_none(said: str) -> None:
    assert not [each for each in find_faults("slider", said) if "counted" in each]


def test_an_angle_of_one_value_may_be_counted_either_way() -> None:
    said = "The crank has turned {{ phi }} clockwise"
    assert find_faults("slider", said, phi=["45"]) == []
