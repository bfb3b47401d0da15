"""Strokes, swings and time ratios against closed forms."""

from __future__ import annotations

import math

import pytest

from kinegrade.cycles.swings import find_swings
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.motion.mechanisms import follow, four_bar, slider_crank


@pytest.mark.parametrize("offset", [0.0, 0.4, -0.9])
@pytest.mark.parametrize("from_outer_dead_centre", [0.8, 0.001, -0.001, 0.0])
def test_a_slider_crank_has_the_stroke_and_time_ratio_of_its_offset(
    offset: float, from_outer_dead_centre: float
) -> None:
    crank, rod = 1.0, 2.5
    at = math.asin(offset / (rod + crank)) + from_outer_dead_centre
    (swing,) = find_swings(follow(slider_crank(crank, rod, offset, at)))
    stroke = math.sqrt((rod + crank) ** 2 - offset**2) - math.sqrt((rod - crank) ** 2 - offset**2)
    lag = abs(math.asin(offset / (rod - crank)) - math.asin(offset / (rod + crank)))
    assert (swing.name, swing.is_angle) == ("B", False)
    assert swing.extent == pytest.approx(stroke, rel=1e-12)
    assert swing.time_ratio == pytest.approx((math.pi + lag) / (math.pi - lag), rel=1e-9)


def test_a_crank_rocker_has_the_swing_and_time_ratio_of_its_dead_centres() -> None:
    crank, coupler, rocker, frame = 1.0, 3.5, 2.5, 4.0
    (swing,) = find_swings(follow(four_bar(crank, coupler, rocker, frame, 1.0)))

    def angle(side: float, other: float, opposite: float) -> float:
        return math.acos((side**2 + other**2 - opposite**2) / (2 * side * other))

    far, near = coupler + crank, coupler - crank
    extent = angle(frame, rocker, far) - angle(frame, rocker, near)
    lag = abs(angle(frame, far, rocker) - angle(frame, near, rocker))
    assert swing.extent == pytest.approx(extent, rel=1e-12)
    assert swing.time_ratio == pytest.approx((math.pi + lag) / (math.pi - lag), rel=1e-9)


def test_a_slotted_rocker_has_the_swing_and_time_ratio_of_its_tangents() -> None:
    solution = solve_template(load_template("crank-bar-through-sleeve-with-arm"), {})
    points = solution.doubles.points
    crank = math.hypot(points["A"].x, points["A"].y)
    half = math.asin(crank / points["B"].x)
    swings = {each.name: each for each in find_swings(follow(solution.motion))}
    assert swings["BD"].extent == pytest.approx(2 * half, rel=1e-9)
    ratio = (math.pi + 2 * half) / (math.pi - 2 * half)
    assert swings["BD"].time_ratio == pytest.approx(ratio, rel=1e-9)


def test_what_turns_fully_or_goes_on_has_no_swing() -> None:
    assert find_swings(follow(four_bar(1.0, 3.0, 1.0, 3.0, 0.7))) == ()
    rolling = solve_template(load_template("rolling-wheel-rim-points"), {})
    assert find_swings(follow(rolling.motion)) == ()
