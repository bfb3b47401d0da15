"""The moving mechanism of a page is where the engine says, and as fast."""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.cycles.centrodes import find_poled_bodies, trace_centrodes
from kinegrade.cycles.curves import find_followed
from kinegrade.cycles.cycle import make_cycle
from kinegrade.motion.path import MotionPath, find_path
from kinegrade.motion.placing import find_carriers
from kinegrade.practice.poses import frame_poses, write_motion
from kinegrade.practice.sampling import choose_poses
from kinegrade.practice.skeleton import list_guides, make_skeleton
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.practice.node import move_in_node

DRIVEN = [name for name in find_template_names() if load_template(name).scheme.drivers]
SHARES = [0.013, 0.21, 0.377, 0.5, 0.642, 0.871, 0.97]
HARD = (
    "crank-rocker-towed-wheel",  # a rod turns slowly: what coordinates are rounded by moves a pole
    "differential-epicyclic-train",  # gears turn seventeen times
    "epicyclic-train-by-tooth-counts",
)
UNKNOWN = 0.1  # of the poles in the picture, at most: about where a body stops turning
PIXEL = 0.2  # millimetres: the page shows five pixels for each
FEW = ("slider-crank", "four-bar-parallel-coupler", "bar-through-swivelling-sleeve")


def find_motion(name: str) -> MotionPath:
    path = find_path(solve_template(load_template(name), {}).motion)
    assert isinstance(path, MotionPath)
    return path


@pytest.mark.sampled(16, also=("crank-slider-in-floating-link",))  # almost jumps once in a cycle
@pytest.mark.parametrize("name", DRIVEN)
def test_positions_between_those_that_are_baked_are_the_engines(name: str) -> None:
    assert measure_error(name, SHARES) <= PIXEL


def test_a_guide_reaches_the_pin_about_which_its_body_turns() -> None:
    """The slotted rocker is drawn from its pin on, however far from it the block slides."""
    path = find_motion("rocker-driven-by-two-slider-link")
    mechanism = path.motion.frames.mechanism
    names, guides = list(mechanism.points), list_guides(mechanism)
    (number,) = (place for place, guide in enumerate(guides) if guide.of == "OA")
    places = choose_poses(path).places
    pin, *ends = (
        places[2 * row : 2 * row + 2]
        for row in (names.index("O"), *(len(names) + 2 * number + each for each in (0, 1)))
    )
    apart, halves = (np.hypot(*(ends[1] - ends[0])), [np.hypot(*(end - pin)) for end in ends])
    np.testing.assert_allclose(sum(halves), apart, rtol=1e-9)


def test_the_last_position_leads_to_the_first_over_several_turns() -> None:
    assert measure_error("planetary-gear-external-rim-velocities", [0.995, 0.999]) <= PIXEL


def measure_error(name: str, shares: list[float]) -> float:
    """Millimetres by which points are off at shares of the cycle."""
    solution = solve_template(load_template(name), {})
    path = find_motion(name)
    motion = write_motion(path, solution, ())
    _, window = frame_poses(path)
    (shown,) = move_in_node([motion], shares)["shown"]
    inputs = np.array([each["input"] for each in shown])
    places = path.place(np.radians(inputs) if path.input.is_angle else inputs)
    points = places.frames.mechanism.points.values()
    rows = np.array([np.broadcast_to(part, inputs.shape) for point in points for part in point])
    expected = window.project(rows)
    found = np.array([np.ravel(each["points"])[: len(expected)] for each in shown]).T
    return float(np.abs(found - expected).max())


@pytest.mark.sampled(16, first=4, also=HARD)
@pytest.mark.parametrize("name", DRIVEN)
def test_poles_are_where_the_engines_velocities_say(name: str) -> None:
    """To a pixel, as far as they are in the picture; almost none is left out."""
    template = load_template(name)
    path, solution = find_motion(name), solve_template(template, {})
    motion = write_motion(path, solution, ())
    poles = make_skeleton(path, template, "", "°").poles
    _, window = frame_poses(path)
    shares = np.linspace(0.01, 0.99, 40).tolist()
    (shown,) = move_in_node([motion], shares, [pole.points for pole in poles])["shown"]
    inputs = np.array([each["input"] for each in shown])
    placement = path.place(np.radians(inputs) if path.input.is_angle else inputs)
    centrodes = trace_centrodes(placement, find_poled_bodies(path))
    assert len(centrodes) == len(poles)
    for number, each in enumerate(centrodes):
        expected = window.project(each.fixed)
        found = np.array([_read_pole(place["poles"][number]) for place in shown]).T
        seen = np.abs(expected - 60).max(axis=0) < 130
        off = np.hypot(*(found - expected))[seen]
        assert np.nanmax(off, initial=0.0) <= PIXEL, each.body
        assert np.isnan(off).mean() <= UNKNOWN, each.body


def _read_pole(shown: dict[str, list[float]] | None) -> list[float]:
    return shown["at"] if shown else [np.nan, np.nan]


@pytest.mark.parametrize("name", FEW)
def test_arrows_are_the_velocities_and_accelerations_of_the_engine(name: str) -> None:
    solution = solve_template(load_template(name), {})
    path = find_motion(name)
    table, window = frame_poses(path)
    (shown,) = move_in_node([write_motion(path, solution, ())], SHARES[1:-1])["shown"]
    inputs = np.array([each["input"] for each in shown])
    moving = path.place(np.radians(inputs) if path.input.is_angle else inputs).motion
    order = list(moving.points)
    unit = window.scale * table.extent  # what is next to nothing beside v^2 / r
    for point, body in find_carriers(path.motion.frames.mechanism).items():
        for rate, read in (("velocities", moving.velocity), ("accelerations", moving.acceleration)):
            vector = read(point, body) if body in moving.frames.bases else None
            if vector is None:
                continue
            across, upward = (np.broadcast_to(part, inputs.shape) * window.scale for part in vector)
            found = np.array([each[rate][order.index(point)] for each in shown])
            size = np.hypot(across, upward)
            missed = np.hypot(found[:, 0] - across, found[:, 1] + upward)
            assert np.all(missed <= 0.02 * size.max() + 0.02 * unit), (point, rate)


@pytest.mark.parametrize("name", ["slider-crank", "stone-crusher"])
def test_graphs_have_the_extremes_of_the_whole_cycle_not_of_the_positions_baked(name: str) -> None:
    solution = solve_template(load_template(name), {})
    asks = find_followed(solution)
    motion = write_motion(find_motion(name), solution, asks)
    for (least, greatest, *_), curve in zip(
        motion.curves, make_cycle(solution, asks).curves, strict=True
    ):
        if curve.is_steep:  # it is cut off
            continue
        room = 2e-4 * (greatest - least) + 1e-3 * max(abs(least), abs(greatest))
        assert least == pytest.approx(float(np.nanmin(curve.values)), abs=room), curve.ask.name
        assert greatest == pytest.approx(float(np.nanmax(curve.values)), abs=room), curve.ask.name


@pytest.mark.parametrize("name", [*FEW, "elliptic-trammel-end-driven"])
def test_the_cycle_begins_at_the_instant(name: str) -> None:
    solution = solve_template(load_template(name), {})
    path = find_motion(name)
    motion = write_motion(path, solution, ())
    (place,) = move_in_node([motion], [0.0])["instants"]
    last = motion.moved.count(" ")
    (shown,) = move_in_node([motion], [place / (last + 1 if motion.closed else last)])["shown"]
    assert shown[0]["input"] == pytest.approx(0.0, abs=1e-5 if motion.high < 10 else 2e-3)


def test_a_skeleton_has_what_moves() -> None:
    template = load_template("slider-crank")
    path = find_motion("slider-crank")
    mechanism = path.motion.frames.mechanism
    skeleton = make_skeleton(path, template, "angle", "°")
    order = list(mechanism.points)
    assert {tuple(order[corner] for corner in bar) for bar in skeleton.bars} == {
        ("O", "A"),
        ("A", "B"),
    }
    assert [order[pivot] for pivot in skeleton.pivots] == ["O"]
    assert [order[rider] for rider in skeleton.riders] == ["B"]
    assert skeleton.blocks == (True,)


def test_the_range_of_a_graph_has_the_extremes_between_positions() -> None:
    """The rim point comes to rest for a moment, at no position of the table."""
    solution = solve_template(load_template("wheel-inside-circular-track"), {"beta": "100.1"})
    path = find_path(solution.motion)
    assert isinstance(path, MotionPath)
    ((least, *_),) = write_motion(path, solution, ("v_B",)).curves
    assert least == 0
