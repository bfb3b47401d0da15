"""Students of a crank OA that moves a rocker CBD through a level rod AB; DE tows a wheel.

CD has the direction beta, DE is perpendicular to it and comes down to E on the level of A and B.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, radians, sin, tan

from tests.by_hand.components import magnitude
from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    degrees_for_radians,
    diameter_for_radius,
    sine_for_cosine,
    slip,
    supplementary_angle,
)
from tests.by_hand.writing import slips_in_writing


def work_from_base_points(
    given: Givens,
    p: Pad,
    *,
    relative_normal: float = 1,
    path_normal: float = 1,
    tangential: float = 1,
    square: float = 2,
) -> Answers:
    """B from the base point A, E from the base point D, on the x and y axes."""
    crank, rod, arm, omega = given["OA"], given["AB"], given["CB"], given["omega"]
    sine, cosine = p.sin(given["psi"]), p.cos(given["psi"])
    up, right = p.sin(given["beta"]), p.cos(given["beta"])
    v_a = p(omega * crank)
    v_b = p(p(v_a * sine) / up)
    v_ba = p(p(v_b * right) - p(v_a * cosine))
    rocker, rate = p(v_b / arm), p(v_ba / rod)
    whole = p(given["n"] * arm)
    v_d = p(rocker * whole)
    link = p(p(p(given["n"] - 1) * arm) * p(up / right))
    v_ed = p(-p(v_d * right) / up)
    v_e_x = p(p(v_ed * right) - p(v_d * up))
    towing = p(v_ed / link)
    normal_a = p(path_normal * p(p(omega**square) * crank))
    tangential_a = p(tangential * given["alpha"] * crank)
    a_a_x = p(-p(normal_a * cosine) - p(tangential_a * sine))
    a_a_y = p(p(tangential_a * cosine) - p(normal_a * sine))
    normal_b = p(path_normal * p(p(rocker**square) * arm))
    a_b_x = p(a_a_x - p(relative_normal * p(p(abs(rate) ** square) * rod)))
    tangential_b = p(-p(a_b_x + p(normal_b * right)) / up)
    a_b_y = p(p(tangential_b * right) - p(normal_b * up))
    turned = p(tangential_b / arm)
    normal_d, tangential_d = p(path_normal * p(p(rocker**square) * whole)), p(turned * whole)
    a_d_x = p(-p(normal_d * right) - p(tangential_d * up))
    a_d_y = p(p(tangential_d * right) - p(normal_d * up))
    normal_e = p(relative_normal * p(p(abs(towing) ** square) * link))
    tangential_e = p(-p(a_d_y + p(normal_e * right)) / up)
    a_e_x = p(p(a_d_x + p(tangential_e * right)) - p(normal_e * up))
    return {
        "v_A": v_a,
        "v_B": abs(v_b),
        "v_D": abs(v_d),
        "v_E": abs(v_e_x),
        "v_E_x": v_e_x,
        "omega_AB": rate,
        "omega_CD": rocker,
        "omega_DE": towing,
        "omega_W": p(-v_e_x / given["R"]),
        "alpha_AB": p(p(a_b_y - a_a_y) / rod),
        "alpha_CD": turned,
        "alpha_DE": p(tangential_e / link),
        "alpha_W": p(-a_e_x / given["R"]),
        "a_B": magnitude(normal_b, tangential_b, p),
        "a_D": magnitude(normal_d, tangential_d, p),
        "a_E_x": a_e_x,
    }


def work_with_projections(given: Givens, p: Pad) -> Answers:
    """Velocities and accelerations along the rods; the rod's own rate from what lies across it."""
    crank, rod, arm, omega = given["OA"], given["AB"], given["CB"], given["omega"]
    psi, beta = radians(given["psi"]), radians(given["beta"])
    lean = p(cos(radians(given["beta"] - 90)))  # of v_B from the rod
    v_a = p(omega * crank)
    v_b = p(p(v_a * p(sin(psi))) / lean)
    v_d = p(given["n"] * v_b)
    v_e = p(v_d / lean)
    link = p(p(p(given["n"] - 1) * arm) * p(tan(beta)))
    rate = p(p(p(v_b * p(cos(beta))) - p(v_a * p(cos(psi)))) / rod)
    towing = p(p(v_e * p(cos(beta))) / link)  # clockwise
    rocker = p(v_b / arm)
    normal_a, tangential_a = p(p(omega**2) * crank), p(given["alpha"] * crank)
    towards_a, normal_b = p(p(rate**2) * rod), p(p(rocker**2) * arm)
    left = p(p(p(normal_a * p(cos(psi))) + p(tangential_a * p(sin(psi)))) + towards_a)
    tangential_b = p(p(left - p(normal_b * p(cos(beta)))) / lean)
    upwards_a = p(p(tangential_a * p(cos(psi))) - p(normal_a * p(sin(psi))))
    upwards_b = p(p(tangential_b * p(cos(beta))) - p(normal_b * p(sin(beta))))
    tangential_d, normal_d = p(given["n"] * tangential_b), p(given["n"] * normal_b)
    towards_d = p(p(towing**2) * link)
    a_e = p(p(tangential_d + towards_d) / lean)  # to the left
    across = p(normal_d - p(a_e * p(cos(beta))))  # of E from D, along CD
    return {
        "v_A": v_a,
        "v_B": v_b,
        "v_D": v_d,
        "v_E": v_e,
        "v_E_x": -v_e,
        "omega_AB": rate,
        "omega_CD": rocker,
        "omega_DE": -towing,
        "omega_W": p(v_e / given["R"]),
        "alpha_AB": p(p(upwards_b - upwards_a) / rod),
        "alpha_CD": p(tangential_b / arm),
        "alpha_DE": p(across / link),
        "alpha_W": p(a_e / given["R"]),
        "a_B": magnitude(normal_b, tangential_b, p),
        "a_D": p(given["n"] * magnitude(normal_b, tangential_b, p)),
        "a_E_x": -a_e,
    }


def work_from_poles(given: Givens, p: Pad) -> Answers:
    """Velocities from the poles: OA and CB meet in that of AB, CD and the plumb line of E in that
    of DE.
    """
    crank, rod, arm, omega = given["OA"], given["AB"], given["CB"], given["omega"]
    psi, beta = radians(given["psi"]), radians(given["beta"])
    v_a = v_b = p(omega * crank)
    rate = 0.0  # where OA and CB are parallel: AB is in translation at the instant
    if given["psi"] != given["beta"]:
        to_a = p(p(rod * p(sin(beta))) / p(sin(beta - psi)))
        to_b = p(p(rod * p(sin(psi))) / p(sin(beta - psi)))
        rate = p(-v_a / to_a)
        v_b = p(abs(rate * to_b))
    rocker = p(v_b / arm)
    link = p(p(p(given["n"] - 1) * arm) * p(tan(beta)))
    v_d = p(rocker * p(given["n"] * arm))
    to_d = p(link * p(tan(beta)))
    to_e = p(link / p(cos(beta)))
    towing = p(v_d / to_d)
    v_e = p(towing * to_e)
    return {
        "v_A": v_a,
        "v_B": v_b,
        "omega_AB": rate,
        "omega_CD": rocker,
        "v_D": v_d,
        "v_E": v_e,
        "v_E_x": -v_e,
        "omega_DE": -towing,
        "omega_W": p(v_e / given["R"]),
    }


def go_on(given: Givens, rate: float, v_b: float | None = None) -> Answers:
    """What a student finds who has taken these for the turning of AB and the speed of B."""
    psi, beta = radians(given["psi"]), radians(given["beta"])
    v_b = given["omega"] * given["OA"] * sin(psi) / sin(beta) if v_b is None else v_b
    alpha = _turned(given, v_b, rate)
    return {"omega_AB": rate, "v_B": v_b, "v_D": given["n"] * v_b, "alpha_CD": alpha}


def about_o(given: Givens) -> Answers:
    """The rod AB taken to turn with the crank about O."""
    right = given["OA"] * cos(radians(given["psi"])) + given["AB"]
    arm = hypot(right, given["OA"] * sin(radians(given["psi"])))
    return go_on(given, given["omega"], given["omega"] * arm)


def in_translation(given: Givens) -> Answers:
    """The rods AB and DE taken to be in instantaneous translation."""
    found = go_on(given, 0, given["omega"] * given["OA"])
    return {**found, "v_E": found["v_D"]}


def about_b(given: Givens) -> Answers:
    """omega_AB taken to be v_A/AB."""
    return go_on(given, given["omega"] * given["OA"] / given["AB"])


def end_of_rocker(given: Givens, v_b: float) -> float:
    return given["n"] * v_b


def wheel_after_pin(given: Givens, v_b: float) -> float:
    return wheel_after_rocker(given, end_of_rocker(given, v_b))


def wheel_after_rocker(given: Givens, v_d: float) -> float:
    """v_D lies along DE, v_E at 90 degrees - beta to it."""
    return v_d / sin(radians(given["beta"]))


def turned_after_pin(given: Givens, v_b: float) -> float:
    """v_B gives omega_CD and omega_AB."""
    across = v_b * cos(radians(given["beta"]))
    v_ba = across - given["omega"] * given["OA"] * cos(radians(given["psi"]))
    return _turned(given, v_b, v_ba / given["AB"])


def _turned(given: Givens, v_b: float, rate: float) -> float:
    """alpha_CD from the x components of a_B."""
    psi, beta, omega = radians(given["psi"]), radians(given["beta"]), given["omega"]
    left = given["OA"] * (omega**2 * cos(psi) + given["alpha"] * sin(psi)) + rate**2 * given["AB"]
    return (left - v_b**2 / given["CB"] * cos(beta)) / (sin(beta) * given["CB"])


SIGNED = [
    "v_E_x",
    "a_E_x",
    "omega_AB",
    "omega_CD",
    "omega_DE",
    "omega_W",
    "alpha_AB",
    "alpha_CD",
    "alpha_DE",
    "alpha_W",
]
METHODS: Mapping[str, Method] = {
    "base points": work_from_base_points,
    "projections": work_with_projections,
    "poles": work_from_poles,
}
MISTAKES: Mapping[str, Mistake] = {
    "relative-normal-dropped": slip(work_from_base_points, relative_normal=0),
    "path-normal-dropped": slip(work_from_base_points, path_normal=0),
    "relative-normal-outwards": slip(work_from_base_points, relative_normal=-1),
    "path-normal-outwards": slip(work_from_base_points, path_normal=-1),
    "omega-not-squared": slip(work_from_base_points, square=1),
    "tangential-dropped": slip(work_from_base_points, tangential=0),
    "wrong-pole": about_o,
    "far-end-for-pole": about_b,
    "translation-assumed": in_translation,
    "neighbours-omega": lambda given: go_on(given, given["omega"]),
    "diameter-for-radius": diameter_for_radius(work_from_base_points, "R"),
    "sine-for-cosine": sine_for_cosine(work_from_base_points, "psi", "beta"),
    "degrees-for-radians": degrees_for_radians(work_from_base_points, "psi", "beta"),
    "supplementary-angle": supplementary_angle(work_from_base_points, "beta"),
    **slips_in_writing(slip(work_from_base_points), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_B", "v_D", end_of_rocker, SIZES),
    Edge("v_B", "v_E", wheel_after_pin, SIZES),
    Edge("v_B", "alpha_CD", turned_after_pin, SIZES),
    Edge("v_D", "v_E", wheel_after_rocker, SIZES),
)
