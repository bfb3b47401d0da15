"""Students of two rods AC and BC, pinned in C; OACB is a parallelogram, A and B are driven.

So AC is parallel to the x axis and BC to the guide of A, at the angle gamma.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, radians, sin, tan

from tests.by_hand.components import magnitude
from tests.by_hand.pad import Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    degrees_for_radians,
    sine_for_cosine,
    slip,
    supplementary_angle,
)
from tests.by_hand.writing import slips_in_writing


def work_on_the_axes(given: Givens, p: Pad, *, normal: float = 1, square: int = 2) -> Answers:
    """C from the base points A and B, on the x and y axes."""
    sine, cosine = p.sin(given["gamma"]), p.cos(given["gamma"])
    level, slanted = given["AC"], given["BC"]
    v_a_x, v_a_y = p(given["v_A"] * cosine), p(given["v_A"] * sine)
    across = p(p(given["v_B"] - v_a_x) / sine)  # of C from B
    v_y = p(across * cosine)
    omega_bc = p(across / slanted)
    omega_ac = p(p(v_y - v_a_y) / level)
    towards_a = p(normal * p(p(abs(omega_ac) ** square) * level))
    towards_b = p(normal * p(p(abs(omega_bc) ** square) * slanted))
    a_x = p(p(given["a_A"] * cosine) - towards_a)
    turned = p(p(given["a_B"] - p(towards_b * cosine) - a_x) / sine)
    a_y = p(p(turned * cosine) - p(towards_b * sine))
    return {
        "v_C_x": v_a_x,
        "v_C_y": v_y,
        "v_C": magnitude(v_a_x, v_y, p),
        "omega_AC": omega_ac,
        "omega_BC": omega_bc,
        "a_C_x": a_x,
        "a_C_y": a_y,
        "a_C": magnitude(a_x, a_y, p),
        "alpha_AC": p(p(a_y - p(given["a_A"] * sine)) / level),
        "alpha_BC": p(turned / slanted),
    }


def work_along_each_rod(given: Givens, p: Pad) -> Answers:
    """v_A + v_CA = v_B + v_CB projected on BC, which leaves omega_AC, and on AC: omega_BC."""
    sine, cosine = p.sin(given["gamma"]), p.cos(given["gamma"])
    level, slanted = given["AC"], given["BC"]
    v_ca = p(p(p(given["v_B"] * cosine) - given["v_A"]) / sine)
    v_cb = p(p(given["v_B"] - p(given["v_A"] * cosine)) / sine)
    omega_ac, omega_bc = p(v_ca / level), p(v_cb / slanted)
    v_x, v_y = p(given["v_A"] * cosine), p(p(given["v_A"] * sine) + v_ca)
    n_a, n_b = p(p(omega_ac**2) * level), p(p(omega_bc**2) * slanted)
    along_bc = p(p(given["a_B"] * cosine) - n_b)
    a_ca = p(p(along_bc - p(given["a_A"] - p(n_a * cosine))) / sine)
    along_ac = p(p(given["a_A"] * cosine) - n_a)
    a_cb = p(p(p(given["a_B"] - p(n_b * cosine)) - along_ac) / sine)
    a_y = p(p(given["a_A"] * sine) + a_ca)
    return {
        "v_C_x": v_x,
        "v_C_y": v_y,
        "v_C": magnitude(v_x, v_y, p),
        "omega_AC": omega_ac,
        "omega_BC": omega_bc,
        "a_C_x": along_ac,
        "a_C_y": a_y,
        "a_C": magnitude(along_ac, a_y, p),
        "alpha_AC": p(a_ca / level),
        "alpha_BC": p(a_cb / slanted),
    }


def work_with_projections(given: Givens, p: Pad) -> Answers:
    """The components of v_C along AC and along BC are those of v_A and v_B; the rest follows."""
    gamma, level, slanted = radians(given["gamma"]), given["AC"], given["BC"]
    sine, cosine, tangent = p(sin(gamma)), p(cos(gamma)), p(tan(gamma))
    v_x = p(given["v_A"] * cosine)
    v_y = p(p(p(given["v_B"] * cosine) - p(v_x * cosine)) / sine)
    omega_ac = p(p(v_y - p(given["v_A"] * sine)) / level)
    v_cb = magnitude(p(v_x - given["v_B"]), v_y, p)
    omega_bc = p(v_cb / slanted) * (1 if v_x < given["v_B"] else -1)
    a_x = p(p(given["a_A"] * cosine) - p(p(omega_ac**2) * level))
    along_bc = p(p(given["a_B"] * cosine) - p(p(omega_bc**2) * slanted))
    a_y = p(p(along_bc / sine) - p(a_x / tangent))
    across_bc = p(p(p(a_y * cosine) - p(a_x * sine)) + p(given["a_B"] * sine))
    return {
        "v_C_x": v_x,
        "v_C_y": v_y,
        "v_C": magnitude(v_x, v_y, p),
        "omega_AC": omega_ac,
        "omega_BC": omega_bc,
        "a_C_x": a_x,
        "a_C_y": a_y,
        "a_C": magnitude(a_x, a_y, p),
        "alpha_AC": p(p(a_y - p(given["a_A"] * sine)) / level),
        "alpha_BC": p(across_bc / slanted),
    }


def speed_from_a(given: Givens, omega_ac: float) -> float:
    gamma = radians(given["gamma"])
    return hypot(given["v_A"] * cos(gamma), given["v_A"] * sin(gamma) + omega_ac * given["AC"])


def speed_from_b(given: Givens, omega_bc: float) -> float:
    gamma, v_cb = radians(given["gamma"]), omega_bc * given["BC"]
    return hypot(given["v_B"] - v_cb * sin(gamma), v_cb * cos(gamma))


def a_x_from_a(given: Givens, omega_ac: float) -> float:
    """AC is level, so that alpha_AC has no share in a_C_x."""
    return given["a_A"] * cos(radians(given["gamma"])) - omega_ac**2 * given["AC"]


def _a_y(given: Givens, a_x: float, omega_bc: float) -> float:
    """Projected on BC, from the base point B."""
    gamma = radians(given["gamma"])
    along = given["a_B"] * cos(gamma) - omega_bc**2 * given["BC"]
    return (along - a_x * cos(gamma)) / sin(gamma)


def _rates(given: Givens) -> tuple[float, float]:
    """omega_AC and omega_BC."""
    gamma, v_a, v_b = radians(given["gamma"]), given["v_A"], given["v_B"]
    level, slanted = given["AC"] * sin(gamma), given["BC"] * sin(gamma)
    return (v_b * cos(gamma) - v_a) / level, (v_b - v_a * cos(gamma)) / slanted


def a_y_after_a_x(given: Givens, a_x: float) -> float:
    _, omega_bc = _rates(given)
    return _a_y(given, a_x, omega_bc)


def a_y_after_level_rod(given: Givens, omega_ac: float) -> float:
    return a_y_after_a_x(given, a_x_from_a(given, omega_ac))


def a_y_after_slanted_rod(given: Givens, omega_bc: float) -> float:
    omega_ac, _ = _rates(given)
    return _a_y(given, a_x_from_a(given, omega_ac), omega_bc)


SIGNED = ("v_C_x", "v_C_y", "omega_AC", "omega_BC", "a_C_x", "a_C_y", "alpha_AC", "alpha_BC")
METHODS: Mapping[str, Method] = {
    "axes": work_on_the_axes,
    "along each rod": work_along_each_rod,
    "projections": work_with_projections,
}
MISTAKES: Mapping[str, Mistake] = {
    "relative-normal-dropped": slip(work_on_the_axes, normal=0),
    "relative-normal-outwards": slip(work_on_the_axes, normal=-1),
    "omega-not-squared": slip(work_on_the_axes, square=1),
    "sine-for-cosine": sine_for_cosine(work_on_the_axes, "gamma"),
    "degrees-for-radians": degrees_for_radians(work_on_the_axes, "gamma"),
    "supplementary-angle": supplementary_angle(work_on_the_axes, "gamma"),
    **slips_in_writing(slip(work_on_the_axes), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_AC", "v_C", speed_from_a),
    Edge("omega_BC", "v_C", speed_from_b),
    Edge("omega_AC", "a_C_x", a_x_from_a),
    Edge("omega_AC", "a_C_y", a_y_after_level_rod),
    Edge("omega_BC", "a_C_y", a_y_after_slanted_rod),
    Edge("a_C_x", "a_C_y", a_y_after_a_x),
)
