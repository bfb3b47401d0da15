"""Worked solutions name causes: from where to where an axis points, why an acceleration is absent,
about what a point goes round, and what is given or merely assumed.
"""

from __future__ import annotations

import pytest

from tests.worked.draws import kept
from tests.worked.telling import lines


def told(template: str) -> str:
    return "\n".join(lines(kept(template, 1)))


def test_a_normal_says_which_way_it_points() -> None:
    solution = told("scotch-yoke-driven-by-guide")
    assert r"Projecting on the normal to $\boldsymbol{v}_{\mathrm{r}}$ (to the left)" in solution
    assert r"v_{\mathrm{a}}\sin\varphi &= v_{\mathrm{e}}" in solution  # the yoke moves to the left


def test_a_slanting_one_is_turned_from_the_vector() -> None:
    solution = told("pin-in-disc-slot-and-rod")
    for vector, turned in (("v", "clockwise"), ("a", "counter-clockwise")):
        normal = rf"normal to $\boldsymbol{{{vector}}}_{{\mathrm{{r}}2}}$"
        assert f"{normal} (its positive direction turned {turned})" in solution


@pytest.mark.parametrize(
    ("template", "because"),
    [
        ("scotch-yoke-driven-by-guide", r"The yoke does not turn here, so $a_{\mathrm{Cor}} = 0$."),
    ],
)
def test_it_is_said_why_there_is_no_coriolis_acceleration(template: str, because: str) -> None:
    assert because in told(template)


def test_a_link_is_named_by_its_ends_and_not_by_a_pin_between_them() -> None:
    solution = told("crank-rocker-towed-wheel")
    assert "$D$ is a point of the rocker $CD$" in solution
    assert "rocker $CB$" not in solution


def test_what_only_serves_to_find_a_pole_is_assumed_and_not_given() -> None:
    solution = told("guide-tube-rod-fixed-centrode")
    assert "What is asked does not depend on how fast $AB$ turns" in solution
    assert "Given: " not in solution
    assert "Known: " not in solution
    assert "Given: the angular velocity of the bar $OA$." in told("crank-rocker-towed-wheel")


def test_a_centre_that_goes_round_goes_round_a_named_point() -> None:
    assert r"\text{(counter-clockwise about }O_{1}\text{)}" in told("wheel-on-circular-track")


def test_a_base_point_whose_motion_is_given_need_not_be_found() -> None:
    assert "the velocity of $A$ is given" in told("toggle-press")
    assert "the velocity of $A$ can be found" in told("slider-crank")
