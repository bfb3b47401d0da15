"""An epicyclic train, a spool, the Geneva drive, the scotch yoke, belts and a hoist, worked out by
hand: positions at the time t from the loop of the mechanism, differentiated.
"""

from __future__ import annotations

from mpmath import acos, arg, cos, diff, exp, mpc, mpf, pi, radians, sqrt

from tests.problem.textbook import HOUR, METRE, MINUTE, Answers, Case, Given


def turn_epicyclic_train(given: Given) -> Answers:
    """Arcs that roll off each other: on the annular gear at rest, and on C seen from the arm."""
    annular, sun = (given["m"] / 1000 * given[teeth] / 2 for teeth in ("z_A", "z_C"))
    planet = (annular - sun) / 2

    def arm(t: mpf) -> mpf:
        return 2 * pi * given["n"] / MINUTE * t

    def roll(t: mpf) -> mpf:
        return arm(t) - annular / planet * arm(t)

    def sun_turned(t: mpf) -> mpf:
        return arm(t) - planet / sun * (roll(t) - arm(t))

    def centre(t: mpf) -> mpc:
        return (sun + planet) * exp(1j * arm(t))

    return {
        "n_B": diff(roll, 0) * MINUTE / (2 * pi),
        "n_C": diff(sun_turned, 0) * MINUTE / (2 * pi),
        "v_P": abs(diff(centre, 0)),
    }


def pull_spool(given: Given) -> Answers:
    """The rim rolls off the floor, the hub off the cord, whose end has moved by u t + w t^2/2."""
    rim, hub = given["R"], given["r"]

    def turned(t: mpf) -> mpf:
        return -(given["u"] * t + given["w"] * t**2 / 2) / (rim - hub)

    def centre(t: mpf) -> mpf:
        return -rim * turned(t)

    def highest(t: mpf) -> mpc:
        return centre(t) + 1j * rim * exp(1j * turned(t))

    return {
        "omega": diff(turned, 0),
        "v_C": diff(centre, 0),
        "v_E": diff(highest, 0).real,
        "a_C": diff(centre, 0, 2),
        "a_E": abs(diff(highest, 0, 2)),
    }


def index_geneva_wheel(given: Given) -> Answers:
    """The slot points from C to the pin."""
    crank = given["a"] / sqrt(mpf(2))

    def pin(t: mpf) -> mpc:
        """The pin seen from C."""
        turned = radians(given["phi"]) + 2 * pi * given["n"] / MINUTE * t
        return crank * exp(1j * turned) - given["a"]

    def wheel(t: mpf) -> mpf:
        return arg(-pin(t))

    return {
        "v_r": -diff(lambda t: abs(pin(t)), 0),
        "omega_C": diff(wheel, 0),
        "alpha_C": diff(wheel, 0, 2),
    }


def push_yoke(given: Given) -> Answers:
    """The pin stays above the point B of the yoke, at the distance r from O."""
    start = given["r"] * cos(radians(given["phi"]))

    def slot(t: mpf) -> mpf:
        return start + given["v"] * t + given["a"] * t**2 / 2

    def crank(t: mpf) -> mpf:
        return acos(slot(t) / given["r"])

    return {
        "omega_OA": diff(crank, 0) * MINUTE / (2 * pi),
        "v_r": diff(lambda t: sqrt(given["r"] ** 2 - slot(t) ** 2), 0),
        "alpha_OA": diff(crank, 0, 2),
    }


def run_belts(given: Given) -> Answers:
    """Each belt has run off one rim what it has run on to the other."""

    def engine(t: mpf) -> mpf:
        return 2 * pi * given["n"] / MINUTE * t

    def shaft(t: mpf) -> mpf:
        return given["r1"] * engine(t) / given["r2"]

    def dynamo(t: mpf) -> mpf:
        return given["r3"] * shaft(t) / given["r4"]

    def rim(t: mpf) -> mpc:
        return given["r4"] / 100 * exp(1j * dynamo(t))

    return {
        "n_A": diff(shaft, 0) * MINUTE / (2 * pi),
        "n_C": diff(dynamo, 0) * MINUTE / (2 * pi),
        "v_B": abs(diff(rim, 0)),
        "a_B": abs(diff(rim, 0, 2)),
    }


def hoist_load(given: Given) -> Answers:
    """The pinion has run off what the gear has run; the drum has wound up as much rope as it ran."""

    def pinion(t: mpf) -> mpf:
        return -2 * pi * given["n"] / MINUTE * t - given["alpha"] * t**2 / 2

    def gear(t: mpf) -> mpf:
        return -given["r1"] * pinion(t) / given["r2"]

    def height(t: mpf) -> mpf:
        return given["r3"] / METRE * gear(t)

    return {
        "omega_B": diff(gear, 0),
        "v_C": diff(height, 0),
        "a_C": diff(height, 0, 2),
    }


def ride_bicycle(given: Given) -> Answers:
    """The belt has run off the front pulley what the rear one ran, and the wheel has rolled as far
    as its rim.
    """

    def crank(t: mpf) -> mpf:
        return 2 * pi * given["n"] / MINUTE * t

    def wheel(t: mpf) -> mpf:
        return given["r1"] * crank(t) / given["r2"]

    def centre(t: mpf) -> mpf:
        return given["R"] / METRE * wheel(t)

    def rim(t: mpf) -> mpc:
        return centre(t) + given["r1"] / METRE * exp(-1j * crank(t))

    return {
        "n_A": diff(wheel, 0) * MINUTE / (2 * pi),
        "v_A": diff(centre, 0) * HOUR / METRE,
        "v_B": abs(diff(rim, 0)),
        "a_B": abs(diff(rim, 0, 2)),
    }


CASES: tuple[Case, ...] = (
    ("hoist-with-gears", hoist_load, {"r1": 120, "r2": 180, "r3": 90, "n": 120, "alpha": 3}),
    ("hoist-with-gears", hoist_load, {"r1": 100, "r2": 190, "r3": 75, "n": 70, "alpha": "1.5"}),
    ("belt-driven-bicycle", ride_bicycle, {"r1": 96, "r2": 72, "R": 180, "n": 60}),
    ("belt-driven-bicycle", ride_bicycle, {"r1": 106, "r2": 75, "R": 165, "n": 85}),
    ("two-stage-belt-drive", run_belts, {"r1": 40, "r2": 20, "r3": 50, "r4": 10, "n": 200}),
    ("two-stage-belt-drive", run_belts, {"r1": 26, "r2": 18, "r3": 34, "r4": 16, "n": 140}),
    (
        "epicyclic-train-by-tooth-counts",
        turn_epicyclic_train,
        {"z_A": 72, "z_C": 32, "m": 8, "phi": 60, "n": 18},
    ),
    (
        "epicyclic-train-by-tooth-counts",
        turn_epicyclic_train,
        {"z_A": 96, "z_C": 28, "m": 5, "phi": 135, "n": 42},
    ),
    ("spool-pulled-by-cord", pull_spool, {"R": 50, "r": 30, "u": 25, "w": 10}),
    ("spool-pulled-by-cord", pull_spool, {"R": 40, "r": 12, "u": 35, "w": -20}),
    ("geneva-drive", index_geneva_wheel, {"a": 10, "phi": 30, "n": 60}),
    ("geneva-drive", index_geneva_wheel, {"a": 14, "phi": -20, "n": 105}),
    ("scotch-yoke-driven-by-guide", push_yoke, {"r": 180, "phi": 150, "v": -100, "a": 300}),
    ("scotch-yoke-driven-by-guide", push_yoke, {"r": 120, "phi": 35, "v": 400, "a": 900}),
)
