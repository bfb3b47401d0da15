"""Gear trains, racks and ropes of textbooks, worked out by hand: arcs that roll off each
other and lengths of rope, at the time t, differentiated.
"""

from __future__ import annotations

from collections.abc import Callable

from mpmath import diff, exp, mpf, pi

from tests.problem.textbook import METRE, MINUTE, Answers, Case, Given


def count_turns(angle: Callable[[mpf], mpf]) -> mpf:
    """The revolutions a minute of what has turned by an angle at the time t."""
    return diff(angle, 0) * MINUTE / (2 * pi)


def turn_differential(given: Given) -> Answers:
    """Arcs in teeth, seen from the arm: the planet on the sun, the ring on the planet."""
    teeth = (given["z_R"] - given["z_S"]) / 2

    def arm(t: mpf) -> mpf:
        return 2 * pi * given["n_A"] / MINUTE * t

    def sun(t: mpf) -> mpf:
        return 2 * pi * given["n_S"] / MINUTE * t

    def planet(t: mpf) -> mpf:
        return arm(t) - given["z_S"] / teeth * (sun(t) - arm(t))

    def ring(t: mpf) -> mpf:
        return arm(t) + teeth / given["z_R"] * (planet(t) - arm(t))

    return {
        "n_P": count_turns(planet),
        "n_R": count_turns(ring),
        "v_P": abs(diff(lambda t: given["l"] * exp(1j * arm(t)), 0)) / METRE,
    }


def lift_stepped_drum(given: Given) -> Answers:
    """Each end has risen by what the centre has and what its rope has run off or on."""
    wide, narrow = given["R"], given["r"]

    def left(t: mpf) -> mpf:
        return given["u"] * t + given["w"] * t**2 / 2

    def turned(t: mpf) -> mpf:
        """By left = centre - wide * turned and right = centre + narrow * turned."""
        return (given["v"] * t - left(t)) / (wide + narrow)

    def centre(t: mpf) -> mpf:
        return left(t) + wide * turned(t)

    return {
        "omega": diff(turned, 0),
        "v_C": diff(centre, 0),
        "x_P": -diff(centre, 0) / diff(turned, 0),
        "a_C": diff(centre, 0, 2),
    }


def push_racks(given: Given) -> Answers:
    """The pinion rolls off the lower rack forwards and the upper one backwards."""
    radius = given["r"]

    def lower(t: mpf) -> mpf:
        return given["u"] * t

    def upper(t: mpf) -> mpf:
        return given["v"] * t + given["a"] * t**2 / 2

    def turned(t: mpf) -> mpf:
        return (lower(t) - upper(t)) / (2 * radius)

    def edge(t: mpf) -> mpf:
        return (lower(t) + upper(t)) / 2 + radius * exp(1j * turned(t))

    return {
        "omega": diff(turned, 0),
        "v_C": diff(lambda t: (lower(t) + upper(t)) / 2, 0),
        "v_E": abs(diff(edge, 0)),
        "alpha": diff(turned, 0, 2),
        "a_E": abs(diff(edge, 0, 2)),
    }


CASES: tuple[Case, ...] = (
    (
        "differential-epicyclic-train",
        turn_differential,
        {"z_S": 24, "z_R": 72, "l": 120, "phi": 45, "n_S": -180, "n_A": 60},
    ),
    (
        "differential-epicyclic-train",
        turn_differential,
        {"z_S": 40, "z_R": 96, "l": 80, "phi": 120, "n_S": 300, "n_A": 75},
    ),
    (
        "stepped-drum-on-two-ropes",
        lift_stepped_drum,
        {"R": 30, "r": 18, "u": 40, "w": -20, "v": -10},
    ),
    (
        "stepped-drum-on-two-ropes",
        lift_stepped_drum,
        {"R": 24, "r": 12, "u": -30, "w": -30, "v": -60},
    ),
    ("pinion-between-two-racks", push_racks, {"r": 70, "u": 250, "v": -100, "a": 400}),
    ("pinion-between-two-racks", push_racks, {"r": 40, "u": -50, "v": -350, "a": -600}),
)
