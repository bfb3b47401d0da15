"""Paths against closed forms: full turns, dead points, change points, and what has no path."""

from __future__ import annotations

import math

import numpy as np
import pytest

from kinegrade.errors import MechanismError
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.ends import Closed, Limit, Open
from kinegrade.motion.path import MotionPath, Still, find_path
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.motion.mechanisms import (
    bar_held_thrice,
    block_on_turning_bar,
    follow,
    four_bar,
    slider_crank,
)


def write(line: Message | None) -> str:
    assert line is not None
    return open_catalogue(ENGLISH).write(line)


@pytest.mark.parametrize("at", [0.4, 2.0, 4.5])
def test_a_crank_of_grashof_turns_fully_and_comes_back_to_where_it_was(at: float) -> None:
    path = follow(four_bar(1.0, 3.5, 2.5, 4.0, at))
    assert path.end == Closed(pytest.approx(math.tau, abs=1e-14), 1)
    assert (path.start, path.changes) == (None, ())
    first, last = path.place(np.array(path.bounds)).frames.mechanism.points["B"].map(np.ravel)[0]
    assert first == pytest.approx(last, abs=1e-12)


def test_a_rocker_of_grashof_swings_between_the_angles_of_the_law_of_cosines() -> None:
    path = follow(four_bar(1.0, 3.5, 2.5, 4.0, 1.0))
    points = path.place(path.spread(20_001)).frames.mechanism.points
    angles = np.arctan2(points["B"].y - points["C"].y, points["B"].x - points["C"].x)
    bounds = [math.acos((4.0**2 + 2.5**2 - (3.5 + s) ** 2) / (2 * 4.0 * 2.5)) for s in (1, -1)]
    assert math.pi - angles.max() == pytest.approx(min(bounds), abs=1e-7)
    assert math.pi - angles.min() == pytest.approx(max(bounds), abs=1e-7)


def test_a_crank_that_cannot_turn_stops_where_coupler_and_rocker_are_in_line() -> None:
    crank, coupler, rocker, frame, at = 2.0, 1.5, 1.8, 3.0, 0.5
    path = follow(four_bar(crank, coupler, rocker, frame, at))
    stop = math.acos((crank**2 + frame**2 - (coupler + rocker) ** 2) / (2 * crank * frame))
    for end, angle in ((path.start, -stop), (path.end, stop)):
        assert isinstance(end, Limit)
        assert at + end.displacement == pytest.approx(angle, abs=1e-12)
        assert write(end.line) == "A, B and C are in line"


def test_a_parallelogram_goes_on_as_one_through_its_change_points() -> None:
    path = follow(four_bar(1.0, 3.0, 1.0, 3.0, 0.7))
    assert isinstance(path.end, Closed)
    places = [change.displacement + 0.7 for change in path.changes]
    assert places == pytest.approx([math.pi, math.tau], abs=1e-9)
    assert write(path.changes[0].line) == "A, B and O are in line"
    motion = path.place(path.spread(100)).motion
    assert np.allclose(motion.omega("BC"), 2.0, atol=1e-9)


def test_a_point_that_slides_from_the_pivot_of_its_bar_runs_along_a_spiral() -> None:
    path = follow(block_on_turning_bar(3.0, 2.0))
    placement = path.place(np.linspace(-1.0, 1.0, 9))
    way, angle = 1.5 * placement.moved, placement.moved
    place = placement.frames.mechanism.points["P"]
    assert np.allclose(place, (way * np.cos(angle), way * np.sin(angle)), atol=1e-12)
    acceleration = placement.motion.acceleration("P", "block")
    radial, across = -4.0 * way, 2 * 2.0 * 3.0
    expected = (
        radial * np.cos(angle) - across * np.sin(angle),
        radial * np.sin(angle) + across * np.cos(angle),
    )
    assert np.allclose(acceleration, expected, atol=1e-9)


def test_redundant_links_that_go_together_have_a_path() -> None:
    path = follow(bar_held_thrice(Vector(0.0, 0.0)))
    assert isinstance(path.end, Limit)
    assert path.end.displacement == pytest.approx(math.sqrt(2) - 1, abs=1e-9)


def test_links_that_fit_at_one_instant_alone_have_none() -> None:
    still = find_path(bar_held_thrice(Vector(0.75, 0.75)))
    assert isinstance(still, Still)
    assert open_catalogue(ENGLISH).write(still.reason) == (
        "the mechanism stays only at this instant: a little further on its conditions are not met "
        "together"
    )


def test_a_pose_has_no_path_as_nothing_drives_it() -> None:
    still = find_path(solve_template(load_template("pose-four-bar-coupler"), {}).motion)
    assert isinstance(still, Still)
    assert open_catalogue(ENGLISH).write(still.reason) == (
        "no driver moves the mechanism: it has no cycle"
    )


def test_an_input_that_is_a_length_stops_at_its_dead_points() -> None:
    motion = solve_template(load_template("rod-ground-and-incline"), {}).motion
    path = follow(motion)
    a, b = motion.map(float).points["A"], motion.map(float).points["B"]
    length, incline = math.hypot(a.x - b.x, a.y - b.y), math.atan2(b.y, b.x)
    reach = length / math.sin(incline)  # the rod at right angles to the incline
    assert isinstance(path.end, Limit)
    assert isinstance(path.start, Limit)
    assert path.bounds[1] - path.bounds[0] == pytest.approx(2 * reach, abs=1e-9)


def test_a_rolling_wheel_goes_on_for_at_least_a_turn() -> None:
    path = follow(solve_template(load_template("rolling-wheel-rim-points"), {}).motion)
    assert isinstance(path.end, Open)
    assert abs(path.place(np.array([path.bounds[1]])).at.coordinates[path.system.rates[1]]) > 6


def test_positions_beyond_the_range_are_refused() -> None:
    path = follow(slider_crank(1.0, 3.0, 0.0, 0.3))
    with pytest.raises(MechanismError) as refused:
        path.place(np.array([7.0]))
    assert str(refused.value) == (
        "the input does not reach that displacement: choose one from 0 to 6.283"
    )


@pytest.mark.parametrize("at", ["0", "90", "180", "270"])
def test_an_arm_along_an_axis_moves_like_any_other(at: str) -> None:
    """One row of its vector equation vanishes at the instant."""
    template = load_template("planetary-gear-external-rim-velocities")
    path = find_path(solve_template(template, {"phi": at, "r1": "0.15", "r2": "0.2"}).motion)
    assert isinstance(path, MotionPath)
    assert path.end == Closed(pytest.approx(4 * math.tau, abs=1e-12), 4)
    assert path.place(path.spread(101)).greatest <= 1e-12 * path.size


def test_change_points_are_those_at_which_another_way_begins() -> None:
    """A rod whose end passes the pivot of its sleeve, from all draws of its angle; a rack that comes
    to lie on its track; the bars of a lift that meet, after which both may turn together. A wheel
    that rolls has none.
    """

    def find_changes(name: str, **given: str) -> list[float]:
        path = follow(solve_template(load_template(name), given).motion)
        return [change.displacement for change in path.changes]

    for theta in ("60", "110", "150"):
        gone = math.tau - math.radians(float(theta))
        assert find_changes("guide-tube-rod-fixed-centrode", theta=theta) == pytest.approx(
            [gone, gone + math.tau], abs=1e-6
        )
    at = -0.05 / math.tan(math.radians(30))
    assert find_changes("guided-rack-and-gear") == pytest.approx([at], abs=1e-6)
    assert find_changes("scissor-lift") == pytest.approx([math.sqrt(3)], abs=1e-6)
    assert find_changes("planetary-gear-external-rim-velocities") == []


def test_gears_that_turn_more_often_than_can_be_followed_could_go_on() -> None:
    """Sixteen turns bring them back; no part of them is ever far away."""
    drawn = {"r1": "0.35", "r2": "0.16"}
    path = find_path(
        solve_template(load_template("planetary-gear-external-rim-velocities"), drawn).motion
    )
    assert isinstance(path, MotionPath)
    assert isinstance(path.end, Open)
    assert path.start is None
    assert path.bounds[0] == 0
