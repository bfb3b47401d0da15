"""Students of a rod AB with A on the ground and B on an incline that leans back from O.

In the triangle OAB the angles are gamma at O and theta at A. The end B slides down the incline.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, radians, sin, tan

from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    degrees_for_radians,
    slip,
)
from tests.by_hand.writing import slips_in_writing


def work_with_projections(given: Givens, p: Pad, *, normal: float = 1, square: int = 2) -> Answers:
    """Velocities projected on the rod, omega from the level of B; accelerations the same way."""
    theta, gamma = radians(given["theta"]), radians(given["gamma"])
    length, lean = given["l"], p(cos(radians(180) - theta - gamma))  # of the incline from the rod
    rising, level = p(sin(gamma)), p(cos(theta))
    v_b = p(p(given["v_A"] * level) / lean)
    omega = p(p(v_b * rising) / p(length * level))
    towards_a = p(normal * p(p(omega**square) * length))
    a_b = p(p(p(given["a_A"] * level) + towards_a) / lean)
    down = p(p(a_b * rising) - p(towards_a * p(sin(theta))))
    whole = p(length / rising)
    return {
        "v_B": abs(v_b),
        "v_B_down": v_b,
        "omega_AB": omega,
        "a_B": abs(a_b),
        "a_B_down": a_b,
        "alpha_AB": p(down / p(length * level)),
        "OA": p(whole * p(sin(theta + gamma))),
        "OB": abs(p(whole * p(sin(theta)))),
    }


def work_from_the_pole(given: Givens, p: Pad) -> Answers:
    """Velocities from the pole S; accelerations on the x and y axes, with alpha eliminated."""
    theta, gamma, length = radians(given["theta"]), radians(given["gamma"]), given["l"]
    behind = radians(180) - gamma  # angle of the incline with the ground on the left
    o_a = p(p(length * p(sin(behind - theta))) / p(sin(behind)))
    o_b = p(p(length * p(sin(theta))) / p(sin(behind)))
    s_a = p(p(p(o_a * p(cos(behind))) + o_b) / p(sin(behind)))
    s_b = p(p(o_a + p(o_b * p(cos(behind)))) / p(sin(behind)))
    omega = p(given["v_A"] / s_a)
    v_b = p(omega * s_b)
    towards_a = p(p(omega**2) * length)
    right = p(given["a_A"] + p(towards_a * p(cos(theta))))
    slope = p(tan(theta))
    eliminated = p(right + p(p(towards_a * p(sin(theta))) * slope))
    a_b = p(eliminated / p(p(cos(behind)) + p(p(sin(behind)) * slope)))
    down = p(p(a_b * p(sin(behind))) - p(towards_a * p(sin(theta))))
    return {
        "v_B": abs(v_b),
        "v_B_down": v_b,
        "omega_AB": omega,
        "a_B": abs(a_b),
        "a_B_down": a_b,
        "alpha_AB": p(p(down / p(cos(theta))) / length),
        "x_S": o_a,
        "y_S": s_a,
        "OA": o_a,
        "OB": abs(o_b),
    }


def differentiate_the_sides(given: Givens, p: Pad) -> Answers:
    """OA and OB by the sine law, differentiated twice; theta falls at the rate omega."""
    theta, gamma, length = radians(given["theta"]), radians(given["gamma"]), given["l"]
    whole = p(length / p(sin(gamma)))
    sine, cosine = p(sin(theta + gamma)), p(cos(theta + gamma))
    omega = p(-given["v_A"] / p(whole * cosine))
    o_a, o_b = p(whole * sine), p(whole * p(sin(theta)))
    bend = p(o_a * p(omega**2))
    alpha = p(-p(given["a_A"] + bend) / p(whole * cosine))
    reach = p(whole * p(cos(theta)))
    a_b = p(p(o_b * p(omega**2)) + p(reach * alpha))
    return {
        "v_B": p(reach * omega),
        "v_B_down": p(reach * omega),
        "omega_AB": omega,
        "a_B": abs(a_b),
        "a_B_down": a_b,
        "alpha_AB": alpha,
        "OA": o_a,
        "OB": o_b,
    }


def _shape(given: Givens) -> tuple[float, float, float]:
    """theta, gamma, and the length of the rod over sin gamma: the circle through O, A and B."""
    gamma = radians(given["gamma"])
    return radians(given["theta"]), gamma, given["l"] / sin(gamma)


def rate_by_pole_height(given: Givens, y: float) -> float:
    return given["v_A"] / y


def speed_by_pole(given: Givens, omega: float) -> float:
    """SB is the chord over the angle 90 degrees - theta in the circle with the diameter OS."""
    theta, _, whole = _shape(given)
    return abs(omega) * whole * cos(theta)


def speed_by_level(given: Givens, omega: float) -> float:
    """Along the ground: v_B cos(180 degrees - gamma) is v_A less the rod's share."""
    theta, gamma, _ = _shape(given)
    return abs((given["v_A"] - omega * given["l"] * sin(theta)) / -cos(gamma))


def rate_by_pole_distance(given: Givens, v_b: float) -> float:
    theta, _, whole = _shape(given)
    return v_b / (whole * cos(theta))


def slide_by_rate(given: Givens, omega: float) -> float:
    """Projected on the rod."""
    theta, gamma, _ = _shape(given)
    along = given["a_A"] * cos(theta) + omega**2 * given["l"]
    return abs(along / cos(theta + gamma))


def turned_by_rate(given: Givens, omega: float) -> float:
    """Projected across the incline, where B has no acceleration."""
    theta, gamma, _ = _shape(given)
    across = given["a_A"] * sin(gamma) / given["l"] + omega**2 * sin(theta + gamma)
    return -across / cos(theta + gamma)


def go_on(given: Givens, omega: float) -> Answers:
    """What a student finds who has taken this for the turning of the rod."""
    a_b, alpha = slide_by_rate(given, omega), turned_by_rate(given, omega)
    return {"omega_AB": omega, "a_B": a_b, "alpha_AB": alpha}


def in_translation(given: Givens) -> Answers:
    """The rod taken to be in instantaneous translation."""
    return go_on(given, 0) | {"v_B": given["v_A"]}


def about_b(given: Givens) -> Answers:
    """The rod taken to turn about its end B."""
    return go_on(given, given["v_A"] / given["l"]) | {
        "y_S": given["l"] * sin(radians(given["theta"]))
    }


def about_o(given: Givens) -> Answers:
    """The pole taken where the directions of v_A and v_B meet."""
    theta, gamma, whole = _shape(given)
    omega = given["v_A"] / (whole * sin(theta + gamma))
    return go_on(given, omega) | {"v_B": omega * whole * sin(theta), "y_S": 0}


def exchange_sines(given: Givens) -> Answers:
    """Sine and cosine exchanged, of the acute angle that the incline makes with the ground."""
    theta, gamma = 90 - given["theta"], 270 - given["gamma"]
    return work_from_the_pole({**given, "theta": theta, "gamma": gamma}, Pad.exact())


SIGNED = ("v_B_down", "omega_AB", "a_B_down", "alpha_AB", "x_S", "y_S", "OA")
METHODS: Mapping[str, Method] = {
    "projections": work_with_projections,
    "pole": work_from_the_pole,
    "sides differentiated": differentiate_the_sides,
}
MISTAKES: Mapping[str, Mistake] = {
    "relative-normal-dropped": slip(work_with_projections, normal=0),
    "relative-normal-outwards": slip(work_with_projections, normal=-1),
    "omega-not-squared": slip(work_with_projections, square=1),
    "far-end-for-pole": about_b,
    "pole-on-velocities": about_o,
    "translation-assumed": in_translation,
    "sine-for-cosine": exchange_sines,
    "degrees-for-radians": degrees_for_radians(work_from_the_pole, "theta", "gamma"),
    **slips_in_writing(slip(work_from_the_pole), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("y_S", "omega_AB", rate_by_pole_height),
    Edge("v_B", "omega_AB", rate_by_pole_distance, SIZES),
    Edge("omega_AB", "v_B", speed_by_pole),
    Edge("omega_AB", "v_B", speed_by_level),
    Edge("omega_AB", "a_B", slide_by_rate),
    Edge("omega_AB", "alpha_AB", turned_by_rate),
)
