"""Students of an eccentric disc under a pointed follower, whose guide misses O by h.

CA leans by delta from the plumb line, sin(delta) = (h - e cos phi)/r; A is at the height
e sin phi + r cos delta.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, radians, sin, sqrt

from tests.by_hand.components import magnitude
from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    degrees_for_radians,
    diameter_for_radius,
    sine_for_cosine,
    slip,
)
from tests.by_hand.writing import slips_in_writing


def work_in_the_turning_frame(
    given: Givens,
    p: Pad,
    *,
    coriolis: float = 2,
    relative_normal: float = 1,
    transport_normal: float = 1,
    tangential: float = 1,
    square: float = 2,
    upper: float = 1,
) -> Answers:
    """v_A = v_e + v_r with the disc as moving frame, on the x and y axes; so for a."""
    radius, offset, omega = given["r"], given["h"], given["omega"]
    phi = radians(given["phi"])
    aside, above = p(offset - p(given["e"] * p(cos(phi)))), p(given["e"] * p(sin(phi)))
    rise = upper * p.root(p(p(radius**2) - p(aside**2)))
    height = p(above + rise)
    sine, cosine = p(aside / radius), p(rise / radius)
    v_r = p(p(omega * height) / cosine)
    v_a = p(p(omega * offset) - p(v_r * sine))
    normal = p(relative_normal * p(p(v_r**2) / radius))
    cor = p(coriolis * p(omega * v_r))
    squared, alpha = transport_normal * p(omega**square), tangential * given["alpha"]
    carried_x = p(-p(squared * offset) - p(alpha * height))
    carried_y = p(-p(squared * height) + p(alpha * offset))
    a_t = p(-p(p(carried_x - p(normal * sine)) + p(cor * sine)) / cosine)
    a_a = p(p(carried_y - p(a_t * sine)) + p(p(cor - normal) * cosine))
    return {
        "OA": magnitude(offset, height, p),
        "v_rel": v_r,
        "v_A": abs(v_a),
        "v_A_y": v_a,
        "a_rel_n": normal,
        "a_cor": abs(cor),
        "a_rel_t": a_t,
        "a_A": abs(a_a),
        "a_A_y": a_a,
    }


def work_with_the_normal(given: Givens, p: Pad) -> Answers:
    """The same terms projected on AC, which leaves v_A and a_A, and on the rim for the rest."""
    radius, offset, omega, alpha = given["r"], given["h"], given["omega"], given["alpha"]
    phi = radians(given["phi"])
    aside, above = p(offset - p(given["e"] * p(cos(phi)))), p(given["e"] * p(sin(phi)))
    rise = p.root(p(p(radius**2) - p(aside**2)))
    height = p(above + rise)
    sine, cosine = p(aside / radius), p(rise / radius)
    outwards = p(p(omega * offset) * cosine) - p(p(omega * height) * sine)  # of v_e
    v_a = p(p(outwards) / cosine)
    on_the_rim = p(p(-p(omega * height) * cosine) - p(p(omega * offset) * sine))
    v_r = p(p(-v_a * sine) - on_the_rim)
    normal, cor = p(p(v_r**2) / radius), p(2 * p(omega * v_r))
    e_x = p(-p(p(omega**2) * offset) - p(alpha * height))
    e_y = p(p(alpha * offset) - p(p(omega**2) * height))
    a_a = p(p(p(p(e_x * sine) + p(e_y * cosine)) + p(cor - normal)) / cosine)
    a_t = p(p(-a_a * sine) - p(p(e_x * cosine) - p(e_y * sine)))
    return {
        "OA": magnitude(offset, height, p),
        "v_rel": v_r,
        "v_A": abs(v_a),
        "v_A_y": v_a,
        "a_rel_n": normal,
        "a_cor": abs(cor),
        "a_rel_t": a_t,
        "a_A": abs(a_a),
        "a_A_y": a_a,
    }


def work_with_a_connecting_rod(given: Givens, p: Pad) -> Answers:
    """CA keeps its length r: a slider-crank with the crank OC and the rod CA in its place."""
    crank, rod, omega, alpha = given["e"], given["r"], given["omega"], given["alpha"]
    sine, cosine = p.sin(given["phi"]), p.cos(given["phi"])
    aside = p(given["h"] - p(crank * cosine))
    rise = p.root(p(p(rod**2) - p(aside**2)))
    v_c = p(omega * crank)
    turning = p(-p(v_c * sine) / rise)  # of CA
    v_a = p(p(v_c * cosine) + p(turning * aside))
    v_r = p(p(omega - turning) * rod)
    normal_c, tangential_c = p(p(omega**2) * crank), p(alpha * crank)
    c_x = p(-p(normal_c * cosine) - p(tangential_c * sine))
    c_y = p(p(tangential_c * cosine) - p(normal_c * sine))
    turned = p(p(c_x - p(p(turning**2) * aside)) / rise)
    a_a = p(p(c_y + p(turned * aside)) - p(p(turning**2) * rise))
    height = p(p(crank * sine) + rise)
    return {
        "OA": magnitude(given["h"], height, p),
        "v_rel": v_r,
        "v_A": abs(v_a),
        "v_A_y": v_a,
        "a_rel_n": p(p(p(omega - turning) ** 2) * rod),
        "a_cor": abs(p(2 * p(omega * v_r))),
        "a_rel_t": p(p(alpha - turned) * rod),
        "a_A": abs(a_a),
        "a_A_y": a_a,
    }


def carried_along(given: Givens) -> Answers:
    """The speed of the point of the disc under A taken for that of A."""
    aside = given["h"] - given["e"] * cos(radians(given["phi"]))
    height = given["e"] * sin(radians(given["phi"])) + sqrt(given["r"] ** 2 - aside**2)
    return {"v_A": given["omega"] * hypot(given["h"], height)}


def _shape(given: Givens) -> tuple[float, float, float]:
    """sin(delta), cos(delta) and the height of A."""
    phi = radians(given["phi"])
    sine = (given["h"] - given["e"] * cos(phi)) / given["r"]
    cosine = sqrt(1 - sine**2)
    return sine, cosine, given["e"] * sin(phi) + given["r"] * cosine


def follower_by_v_r(given: Givens, v_r: float) -> float:
    sine, _, _ = _shape(given)
    return given["omega"] * given["h"] - v_r * sine


def coriolis_by_v_r(given: Givens, v_r: float) -> float:
    return abs(2 * given["omega"] * v_r)


def _lift(given: Givens, v_r: float, coriolis: float) -> float:
    """a_A, projected on CA: the tangential relative acceleration has no share."""
    sine, cosine, height = _shape(given)
    square, alpha = given["omega"] ** 2, given["alpha"]
    aside = (-square * given["h"] - alpha * height) * sine
    above = (alpha * given["h"] - square * height) * cosine
    return (aside + above + coriolis - v_r**2 / given["r"]) / cosine


def lift_by_v_r(given: Givens, v_r: float) -> float:
    return _lift(given, v_r, 2 * given["omega"] * v_r)


def lift_by_coriolis(given: Givens, coriolis: float) -> float:
    _, cosine, height = _shape(given)
    return _lift(given, given["omega"] * height / cosine, coriolis)


SIGNED = ("v_A_y", "a_A_y", "v_rel", "a_rel_n", "a_rel_t")
METHODS: Mapping[str, Method] = {
    "turning frame": work_in_the_turning_frame,
    "normal": work_with_the_normal,
    "connecting rod": work_with_a_connecting_rod,
}
MISTAKES: Mapping[str, Mistake] = {
    "coriolis-dropped": slip(work_in_the_turning_frame, coriolis=0),
    "coriolis-halved": slip(work_in_the_turning_frame, coriolis=1),
    "coriolis-reversed": slip(work_in_the_turning_frame, coriolis=-2),
    "path-normal-dropped": slip(work_in_the_turning_frame, relative_normal=0, transport_normal=0),
    "path-normal-outwards": slip(
        work_in_the_turning_frame, relative_normal=-1, transport_normal=-1
    ),
    "omega-not-squared": slip(work_in_the_turning_frame, square=1),
    "tangential-dropped": slip(work_in_the_turning_frame, tangential=0),
    "transport-for-absolute": carried_along,
    "other-branch": slip(work_in_the_turning_frame, upper=-1),
    "diameter-for-radius": diameter_for_radius(work_in_the_turning_frame, "r"),
    "sine-for-cosine": sine_for_cosine(work_in_the_turning_frame, "phi"),
    "degrees-for-radians": degrees_for_radians(work_in_the_turning_frame, "phi"),
    **slips_in_writing(slip(work_in_the_turning_frame), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_rel", "v_A_y", follower_by_v_r),
    Edge("v_rel", "a_cor", coriolis_by_v_r),
    Edge("v_rel", "a_A_y", lift_by_v_r),
    Edge("a_cor", "a_A_y", lift_by_coriolis, SIZES),
)
