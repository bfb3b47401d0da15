"""Machines of textbooks, worked out by hand: coordinates at the time t, differentiated."""

from __future__ import annotations

from mpmath import acos, arg, cos, diff, exp, mpc, mpf, pi, radians, sin, sqrt, tan

from tests.problem.textbook import Answers, Case, Given


def lift_slotted_link(given: Given) -> Answers:
    """The link points from A to the peg, which has risen by v t."""

    def peg(t: mpf) -> mpc:
        return given["d"] * (1 + 1j * tan(radians(given["theta"]))) + 1j * given["v"] * t

    def turned(t: mpf) -> mpf:
        return arg(peg(t))

    return {
        "omega": diff(turned, 0),
        "v_r": diff(lambda t: abs(peg(t)), 0),
        "v_C": abs(diff(lambda t: given["l"] * exp(1j * turned(t)), 0)),
        "alpha": diff(turned, 0, 2),
    }


def raise_scissors(given: Given) -> Answers:
    """AB and the height are the legs of a right triangle with the hypotenuse AD = 2 a."""
    bar = 2 * given["a"]
    start = bar * cos(radians(given["theta"]))

    def base(t: mpf) -> mpf:
        return start - given["v"] * t

    def height(t: mpf) -> mpf:
        return sqrt(bar**2 - base(t) ** 2)

    return {
        "omega_AD": diff(lambda t: acos(base(t) / bar), 0),
        "v_C": diff(height, 0),
        "a_C": diff(height, 0, 2),
    }


def press_toggle(given: Given) -> Answers:
    """B on the circle about C, at the distance m from A, which stays at the height it has now."""
    side, rod = given["l"], given["m"]
    depth, start = side * cos(radians(given["beta"])), -side * sin(radians(given["beta"]))

    def joint(t: mpf) -> mpc:
        """B, as far from the middle of CA as its distance from C leaves."""
        end = start - rod + given["v"] * t - 1j * depth
        along = (side**2 - rod**2 + abs(end) ** 2) / (2 * abs(end))
        return end / abs(end) * (along + 1j * sqrt(side**2 - along**2))

    def ram(t: mpf) -> mpf:
        """How far D is below C."""
        return -joint(t).imag + sqrt(side**2 - joint(t).real ** 2)

    def lower(t: mpf) -> mpf:
        return arg(-1j * ram(t) - joint(t))

    return {
        "omega_BC": diff(lambda t: arg(joint(t)), 0),
        "omega_BD": diff(lower, 0),
        "v_D": diff(ram, 0),
        "a_D": diff(ram, 0, 2),
    }


def reach_with_arm(given: Given) -> Answers:
    """The forearm turns with the upper arm and relative to it."""

    def upper(t: mpf) -> mpf:
        return radians(given["phi"]) + given["omega_1"] * t

    def fore(t: mpf) -> mpf:
        return upper(t) + radians(given["psi"]) + given["omega_r"] * t

    def hand(t: mpf) -> mpc:
        return given["l1"] * exp(1j * upper(t)) + given["l2"] * exp(1j * fore(t))

    return {
        "omega_AB": diff(fore, 0),
        "v_B_x": diff(hand, 0).real,
        "v_B_y": diff(hand, 0).imag,
    }


def steer(given: Given) -> Answers:
    """B is where the circle about A meets that about C, which has moved by v t."""
    arm, rod = given["a"], given["l"]
    now = arm * exp(1j * (radians(given["phi"]) - pi / 2))
    start = now.real + sqrt(rod**2 - (now.imag + given["h"]) ** 2)

    def end(t: mpf) -> mpc:
        return start + given["v"] * t - 1j * given["h"]

    def joint(t: mpf) -> mpc:
        along = (arm**2 - rod**2 + abs(end(t)) ** 2) / (2 * abs(end(t)))
        return end(t) / abs(end(t)) * (along - 1j * sqrt(arm**2 - along**2))

    return {
        "omega_AB": diff(lambda t: arg(joint(t)), 0),
        "omega_BC": diff(lambda t: arg(end(t) - joint(t)), 0),
        "v_B": abs(diff(joint, 0)),
    }


CASES: tuple[Case, ...] = (
    (
        "slotted-link-on-cylinder",
        lift_slotted_link,
        {"d": "0.6", "l": "2", "theta": "45", "v": "0.5"},
    ),
    (
        "slotted-link-on-cylinder",
        lift_slotted_link,
        {"d": "0.4", "l": "1.6", "theta": "25", "v": "0.7"},
    ),
    ("scissor-lift", raise_scissors, {"a": "1", "theta": "30", "v": "0.2"}),
    ("scissor-lift", raise_scissors, {"a": "0.65", "theta": "55", "v": "0.12"}),
    ("toggle-press", press_toggle, {"l": 240, "m": 200, "beta": 30, "v": 100}),
    ("toggle-press", press_toggle, {"l": 290, "m": 160, "beta": 15, "v": 50}),
    ("rack-steering", steer, {"a": 150, "l": 300, "h": 200, "phi": 30, "v": 60}),
    ("rack-steering", steer, {"a": 120, "l": 360, "h": 240, "phi": 15, "v": -100}),
    (
        "two-link-robot-arm",
        reach_with_arm,
        {"l1": "0.6", "l2": "0.5", "phi": 60, "psi": -60, "omega_1": 1, "omega_r": -2},
    ),
    (
        "two-link-robot-arm",
        reach_with_arm,
        {"l1": "0.75", "l2": "0.4", "phi": 25, "psi": 40, "omega_1": "-0.5", "omega_r": "2.25"},
    ),
)
