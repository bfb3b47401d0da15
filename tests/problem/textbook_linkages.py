"""Linkages and cams of textbooks, worked out by hand: positions at the time t from the loop of the
mechanism, differentiated.
"""

from __future__ import annotations

from collections.abc import Callable

from mpmath import acos, arg, asin, cos, diff, exp, mpc, mpf, pi, radians, sin, sqrt

from tests.problem.textbook import METRE, MINUTE, Answers, Case, Given


def turn_at(given: Given, speed: mpf) -> Callable[[mpf], mpf]:
    """The angle phi of a crank in radians at the time t."""
    return lambda t: radians(given["phi"]) + 2 * pi * speed / MINUTE * t


def turn_cylinder(given: Given) -> Answers:
    """The rod from A = (r, 0) ends on the ray from O: the law of sines, then the sides along it."""
    short, rod, cylinder = given["r"], given["l"], turn_at(given, given["n"])

    def lean(t: mpf) -> mpf:
        return cylinder(t) + asin(short * sin(cylinder(t)) / rod)

    def reach(t: mpf) -> mpf:
        """The distance OB."""
        return abs(short + rod * exp(1j * lean(t)))

    return {
        "omega_AB": diff(lean, 0),
        "v_r": diff(reach, 0) / METRE,
        "a_C": 2 * diff(cylinder, 0) * abs(diff(reach, 0)) / METRE,
        "alpha_AB": diff(lean, 0, 2),
    }


def turn_four_bar(given: Given) -> Answers:
    """The triangle BCD by its three sides."""
    crank = turn_at(given, -given["n"])

    def coupler(t: mpf) -> mpc:
        """C seen from B."""
        diagonal = given["d"] - given["a"] * exp(1j * crank(t))
        squares = abs(diagonal) ** 2 + given["b"] ** 2 - given["c"] ** 2
        opening = acos(squares / (2 * abs(diagonal) * given["b"]))
        return given["b"] * exp(1j * (arg(diagonal) + opening))

    def rocker(t: mpf) -> mpc:
        """C seen from D."""
        return given["a"] * exp(1j * crank(t)) + coupler(t) - given["d"]

    return {
        "omega_BC": diff(lambda t: arg(coupler(t)), 0),
        "omega_CD": diff(lambda t: arg(rocker(t)), 0),
        "v_C": abs(diff(rocker, 0)) / METRE,
        "alpha_CD": diff(lambda t: arg(rocker(t)), 0, 2),
    }


def guide_straight(given: Given) -> Answers:
    """The triangle BCD by its three sides, DC being as long as AB."""
    end = given["d"] + 1j * given["h"]

    def first(t: mpf) -> mpc:
        return given["a"] * exp(1j * (radians(given["phi"]) + given["omega"] * t))

    def coupler(t: mpf) -> mpc:
        """C seen from B."""
        diagonal = end - first(t)
        squares = abs(diagonal) ** 2 + given["b"] ** 2 - given["a"] ** 2
        opening = acos(squares / (2 * abs(diagonal) * given["b"]))
        return given["b"] * exp(1j * (arg(diagonal) + opening))

    return {
        "omega_BC": diff(lambda t: arg(coupler(t)), 0),
        "omega_CD": diff(lambda t: arg(end - first(t) - coupler(t)), 0),
        "v_P": abs(diff(lambda t: first(t) + coupler(t) / 2, 0)) / METRE,
    }


def turn_tangent_cam(given: Given) -> Answers:
    """The centre of the roller is r + q from a line through O that turns; the roller has gone along
    the flank what it has turned on it.
    """
    offset = given["r"] + given["q"]

    def flank(t: mpf) -> mpf:
        """The direction of the flank from the right."""
        return radians(given["theta"]) + 2 * pi * given["n"] / MINUTE * t

    def height(t: mpf) -> mpf:
        return offset / cos(flank(t))

    def along(t: mpf) -> mpf:
        """The contact from E."""
        return height(t) * sin(flank(t))

    return {
        "y_C": height(mpf(0)),
        "v_C": diff(height, 0) / METRE,
        "omega_C": diff(lambda t: flank(t) - along(t) / given["q"], 0),
        "a_C": diff(height, 0, 2) / METRE,
    }


def rock_flat_face(given: Given) -> Answers:
    """The face is a tangent from Q: its angle with QC has the sine R / QC."""
    disc = turn_at(given, given["n"])
    along_face = exp(1j * radians(given["psi"]))
    pivot = (given["s"] - 1j * given["R"]) * along_face - given["e"] * exp(1j * disc(mpf(0)))

    def centre(t: mpf) -> mpc:
        """C seen from Q."""
        return pivot + given["e"] * exp(1j * disc(t))

    def face(t: mpf) -> mpf:
        return arg(centre(t)) + asin(given["R"] / abs(centre(t)))

    def along(t: mpf) -> mpf:
        """The contact from Q."""
        return sqrt(abs(centre(t)) ** 2 - given["R"] ** 2)

    return {
        "omega_Q": diff(face, 0),
        "v_r": diff(along, 0) / METRE,
        "alpha_Q": diff(face, 0, 2),
    }


CASES: tuple[Case, ...] = (
    ("rotary-engine", turn_cylinder, {"r": 60, "l": 200, "phi": 40, "n": 900}),
    ("rotary-engine", turn_cylinder, {"r": 75, "l": 160, "phi": 130, "n": 700}),
    (
        "four-bar-by-lengths",
        turn_four_bar,
        {"a": 40, "b": 150, "c": 80, "d": 150, "phi": 60, "n": 120},
    ),
    (
        "four-bar-by-lengths",
        turn_four_bar,
        {"a": 50, "b": 140, "c": 120, "d": 160, "phi": 110, "n": 80},
    ),
    (
        "watt-linkage",
        guide_straight,
        {"a": 400, "b": 200, "d": 800, "h": 200, "phi": 10, "omega": 2},
    ),
    (
        "watt-linkage",
        guide_straight,
        {"a": 350, "b": 260, "d": 720, "h": 240, "phi": 18, "omega": "-1.5"},
    ),
    ("tangent-cam-with-roller", turn_tangent_cam, {"r": 30, "q": 12, "theta": 25, "n": 240}),
    ("tangent-cam-with-roller", turn_tangent_cam, {"r": 50, "q": 17, "theta": 40, "n": 600}),
    (
        "oscillating-flat-faced-follower",
        rock_flat_face,
        {"R": 60, "e": 25, "s": 120, "psi": 10, "phi": -45, "n": 90},
    ),
    (
        "oscillating-flat-faced-follower",
        rock_flat_face,
        {"R": 50, "e": 30, "s": 90, "psi": 25, "phi": 135, "n": 270},
    ),
)
