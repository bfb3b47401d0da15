"""Students of a wheel that rolls on the outside of a circular track, touching it in D.

Directions are counted from the prolongation of O1 O (outwards) and from the direction that is a
quarter turn counter-clockwise of it (onwards), to the left for theta = 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, radians, sin

from tests.by_hand.components import magnitude
from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    degrees_for_radians,
    diameter_for_radius,
    sine_for_cosine,
    slip,
)
from tests.by_hand.writing import slips_in_writing


def work_along_the_radius(
    given: Givens,
    p: Pad,
    *,
    path_normal: float = 1,
    relative_normal: float = 1,
    tangential: float = 1,
    square: float = 2,
    inner: float = 1,
    centre: float = 1,
) -> Answers:
    """B from the base point O, on axes outwards and onwards; then turned to x and y."""
    wheel, omega, alpha = given["r"], given["omega"], given["alpha"]
    theta, beta = radians(given["theta"]), radians(given["beta"])
    arm = p(given["R"] + inner * wheel)
    v_o = p(omega * wheel)
    onward_o = p(tangential * p(alpha * wheel))
    inward_o = p(path_normal * p(p(abs(v_o / arm) ** square) * arm))
    out, on = p(cos(beta)), p(sin(beta))
    v_out, v_on = p(-p(v_o * on)), p(centre * v_o + p(v_o * out))
    rim, towards_o = onward_o, p(relative_normal * p(p(abs(omega) ** square) * wheel))
    a_out = p(-inward_o - p(rim * on) - p(towards_o * out))
    a_on = p(onward_o + p(rim * out) - p(towards_o * on))
    v_o_x, v_o_y = _turn(0, v_o, theta, p)
    a_o_x, a_o_y = _turn(-inward_o, onward_o, theta, p)
    v_b_x, v_b_y = _turn(v_out, v_on, theta, p)
    a_b_x, a_b_y = _turn(a_out, a_on, theta, p)
    return {
        "v_O": abs(v_o),
        "v_O_x": v_o_x,
        "v_O_y": v_o_y,
        "a_O": magnitude(inward_o, onward_o, p),
        "a_O_x": a_o_x,
        "a_O_y": a_o_y,
        "a_O_n": inward_o,
        "v_B": magnitude(v_out, v_on, p),
        "v_B_x": v_b_x,
        "v_B_y": v_b_y,
        "a_B": magnitude(a_out, a_on, p),
        "a_B_x": a_b_x,
        "a_B_y": a_b_y,
        "a_B_n": p(-p(a_out * out) - p(a_on * on)),
        "a_B_t": p(p(a_out * on) - p(a_on * out)),
        "a_D": p(abs(towards_o - inward_o)),
        "theta_dot": p(v_o / arm),
    }


def work_from_the_contact(given: Givens, p: Pad) -> Answers:
    """Velocities from the pole D; the acceleration of B along BO and across it."""
    wheel, omega, alpha = given["r"], given["omega"], given["alpha"]
    half, beta = radians(given["beta"]) / 2, radians(given["beta"])
    arm = given["R"] + wheel
    v_o = p(wheel * omega)
    turning = p(v_o / arm)
    v_b = p(p(2 * p(wheel * p(cos(half)))) * omega)  # across DB, which is at half the angle
    inward, onward = p(p(turning**2) * arm), p(wheel * alpha)
    towards_o = p(p(omega**2) * wheel)
    along = p(p(towards_o + p(inward * p(cos(beta)))) - p(onward * p(sin(beta))))
    across = p(-p(p(inward * p(sin(beta))) + p(onward * p(cos(beta)))) - onward)
    v_b_x, v_b_y = _turn(0, v_b, radians(given["theta"]) + half, p)
    return {
        "v_O": abs(v_o),
        "a_O": magnitude(inward, onward, p),
        "a_O_n": inward,
        "v_B": abs(v_b),
        "v_B_x": v_b_x,
        "v_B_y": v_b_y,
        "a_B": magnitude(along, across, p),
        "a_B_n": along,
        "a_B_t": across,
        "a_D": p(towards_o * p(given["R"] / arm)),
        "theta_dot": turning,
    }


def work_on_the_axes(given: Givens, p: Pad) -> Answers:
    """Every vector as x and y components: O from O1, B from O."""
    wheel, omega, alpha = given["r"], given["omega"], given["alpha"]
    arm = given["R"] + wheel
    theta, towards_b = radians(given["theta"]), radians(given["theta"] + given["beta"])
    sine, cosine = p(sin(theta)), p(cos(theta))
    x, y = p(-p(wheel * p(sin(towards_b)))), p(wheel * p(cos(towards_b)))  # of B from O
    v_o, tangential = p(omega * wheel), p(alpha * wheel)
    normal = p(p(v_o**2) / arm)
    v_o_x, v_o_y = p(-p(v_o * cosine)), p(-p(v_o * sine))
    a_o_x = p(p(normal * sine) - p(tangential * cosine))
    a_o_y = p(-p(normal * cosine) - p(tangential * sine))
    v_b_x, v_b_y = p(v_o_x - p(omega * y)), p(v_o_y + p(omega * x))
    square = p(omega**2)
    a_b_x = p(p(a_o_x - p(alpha * y)) - p(square * x))
    a_b_y = p(p(a_o_y + p(alpha * x)) - p(square * y))
    x, y = p(x / wheel), p(y / wheel)
    return {
        "v_O": magnitude(v_o_x, v_o_y, p),
        "v_O_x": v_o_x,
        "v_O_y": v_o_y,
        "a_O": magnitude(a_o_x, a_o_y, p),
        "a_O_x": a_o_x,
        "a_O_y": a_o_y,
        "v_B": magnitude(v_b_x, v_b_y, p),
        "v_B_x": v_b_x,
        "v_B_y": v_b_y,
        "a_B": magnitude(a_b_x, a_b_y, p),
        "a_B_x": a_b_x,
        "a_B_y": a_b_y,
        "a_B_n": p(-p(a_b_x * x) - p(a_b_y * y)),
        "a_B_t": p(p(a_b_x * y) - p(a_b_y * x)),
    }


def _turn(out: float, on: float, theta: float, p: Pad) -> tuple[float, float]:
    """The x and y components of what points outwards and onwards."""
    sine, cosine = p(sin(theta)), p(cos(theta))
    return p(-p(out * sine) - p(on * cosine)), p(p(out * cosine) - p(on * sine))


def whole_speed(given: Givens, v_o: float) -> float:
    """From the pole D: DB is 2 r cos(beta/2)."""
    return abs(2 * v_o * cos(radians(given["beta"]) / 2))


def speed_about_centre(given: Givens, v_o: float) -> float:
    beta, rim = radians(given["beta"]), given["omega"] * given["r"]
    v_o = v_o if rim > 0 else -v_o
    return hypot(v_o + rim * cos(beta), rim * sin(beta))


def of_centre(given: Givens, v_o: float) -> float:
    return hypot(v_o**2 / (given["R"] + given["r"]), given["alpha"] * given["r"])


def _about_centre(given: Givens, v_o: float) -> tuple[float, float]:
    """The components of a_B along BO and across it."""
    beta, onward = radians(given["beta"]), given["alpha"] * given["r"]
    inward = v_o**2 / (given["R"] + given["r"])
    along = inward * cos(beta) - onward * sin(beta) + given["omega"] ** 2 * given["r"]
    return along, -inward * sin(beta) - onward * cos(beta) - onward


def along_by_centre(given: Givens, v_o: float) -> float:
    along, _ = _about_centre(given, v_o)
    return along


def whole_by_centre(given: Givens, v_o: float) -> float:
    along, across = _about_centre(given, v_o)
    return hypot(along, across)


right = slip(work_along_the_radius)
SIGNED = (
    "v_O_x",
    "v_O_y",
    "a_O_x",
    "a_O_y",
    "a_O_n",
    "v_B_x",
    "v_B_y",
    "a_B_x",
    "a_B_y",
    "a_B_n",
    "a_B_t",
    "theta_dot",
)
METHODS: Mapping[str, Method] = {
    "along the radius": work_along_the_radius,
    "contact": work_from_the_contact,
    "axes": work_on_the_axes,
}
MISTAKES: Mapping[str, Mistake] = {
    "path-normal-dropped": slip(work_along_the_radius, path_normal=0),
    "relative-normal-dropped": slip(work_along_the_radius, relative_normal=0),
    "path-normal-outwards": slip(work_along_the_radius, path_normal=-1),
    "relative-normal-outwards": slip(work_along_the_radius, relative_normal=-1),
    "omega-not-squared": slip(work_along_the_radius, square=1),
    "tangential-dropped": slip(work_along_the_radius, tangential=0),
    "arm-for-sum": slip(work_along_the_radius, inner=0),
    "meshing-reversed": slip(work_along_the_radius, inner=-1),
    "centre-for-pole": slip(work_along_the_radius, centre=0),
    "diameter-for-radius": diameter_for_radius(work_along_the_radius, "r", "R"),
    "sine-for-cosine": sine_for_cosine(work_along_the_radius, "theta", "beta"),
    "degrees-for-radians": degrees_for_radians(work_along_the_radius, "theta", "beta"),
    "one-length-for-another": lambda given: right({**given, "r": given["R"]}),
    **slips_in_writing(slip(work_along_the_radius), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_O", "v_B", whole_speed, SIZES),
    Edge("v_O", "v_B", speed_about_centre, SIZES),
    Edge("v_O", "a_O", of_centre, SIZES),
    Edge("v_O", "a_B_n", along_by_centre, SIZES),
    Edge("v_O", "a_B", whole_by_centre, SIZES),
)
