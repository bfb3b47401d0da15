"""Slider-crank: the crank turns clockwise, the slider runs to the right of the crank pin.

The rod falls by the angle psi from A to B: r sin(phi) = L sin(psi).
"""

from __future__ import annotations

from collections.abc import Mapping
from math import asin, cos, degrees, pi, radians, sin, sqrt, tan

from tests.by_hand.pad import Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def base_point(given: Givens, pad: Pad) -> Answers:
    """A is the base point of the rod; components along x and y."""
    r, omega = given["r"], given["omega"]
    length = pad(given["k"] * r)
    sin_phi, cos_phi = pad.sin(given["phi"]), pad.cos(given["phi"])
    sin_psi = pad(pad(r * sin_phi) / length)
    cos_psi = pad.root(1 - pad(sin_psi**2))
    v_a = pad(r * omega)
    # v_A = (v_A sin, -v_A cos), v_BA = w (L sin_psi, L cos_psi), v_By = 0
    w = pad(pad(v_a * cos_phi) / pad(length * cos_psi))
    v_b = pad(pad(v_a * sin_phi) + pad(w * pad(length * sin_psi)))
    a_n, a_t = pad(r * pad(omega**2)), pad(r * given["alpha"])
    a_ax = pad(pad(a_t * sin_phi) - pad(a_n * cos_phi))
    a_ay = -pad(pad(a_n * sin_phi) + pad(a_t * cos_phi))
    n = pad(length * pad(w**2))
    e = -pad(pad(a_ay + pad(n * sin_psi)) / pad(length * cos_psi))
    a_b = pad(pad(a_ax - pad(n * cos_psi)) + pad(pad(length * e) * sin_psi))
    return {"v_B": abs(v_b), "omega_AB": w, "alpha_AB": e, "a_B": a_b}


def projection(given: Givens, pad: Pad) -> Answers:
    """Components along and across the rod, with its angle in degrees."""
    r, omega = given["r"], given["omega"]
    length = pad(given["k"] * r)
    psi = pad(degrees(asin(pad(pad(r * pad.sin(given["phi"])) / length))))
    between = pad.angle(given["phi"] + psi)
    along, across = pad.sin(between), pad.cos(between)
    sin_psi, cos_psi = pad.sin(psi), pad.cos(psi)
    v_a = pad(r * omega)
    v_b = pad(pad(v_a * along) / cos_psi)
    w = pad(pad(pad(v_b * sin_psi) + pad(v_a * across)) / length)
    a_n, a_t = pad(r * pad(omega**2)), pad(r * given["alpha"])
    a_along = pad(pad(pad(a_t * along) - pad(a_n * across)) - pad(length * pad(w**2)))
    a_b = pad(a_along / cos_psi)
    e = pad(pad(pad(a_b * sin_psi) + pad(pad(a_n * along) + pad(a_t * across))) / length)
    return {"v_B": abs(v_b), "omega_AB": w, "alpha_AB": e, "a_B": a_b}


def loop(given: Givens, pad: Pad) -> Answers:
    """The loop r sin(phi) = L sin(psi), x = r cos(phi) + L cos(psi), differentiated twice."""
    r, rate, change = given["r"], -given["omega"], -given["alpha"]  # of phi
    length = pad(given["k"] * r)
    sin_phi, cos_phi = pad.sin(given["phi"]), pad.cos(given["phi"])
    psi = pad(degrees(asin(pad(pad(r * sin_phi) / length))))
    height, reach = pad(r * sin_phi), pad(length * pad.cos(psi))
    psi_rate = pad(pad(pad(r * cos_phi) * rate) / reach)
    v_b = -pad(pad(height * rate) + pad(height * psi_rate))
    falling = pad(pad(pad(r * cos_phi) * change) - pad(height * pad(rate**2)))
    psi_change = pad(pad(falling + pad(height * pad(psi_rate**2))) / reach)
    of_crank = pad(pad(height * change) + pad(pad(r * cos_phi) * pad(rate**2)))
    of_rod = pad(pad(height * psi_change) + pad(reach * pad(psi_rate**2)))
    return {
        "v_B": abs(v_b),
        "omega_AB": -psi_rate,
        "alpha_AB": -psi_change,
        "a_B": -pad(of_crank + of_rod),
    }


def pole(given: Givens, pad: Pad) -> Answers:
    """The pole P of the rod, on the line OA and above or below B; velocities alone."""
    r = given["r"]
    length = pad(given["k"] * r)
    sin_phi, cos_phi = pad.sin(given["phi"]), pad.cos(given["phi"])
    psi = pad(degrees(asin(pad(pad(r * sin_phi) / length))))
    distance = pad(pad(r * cos_phi) + pad(length * pad.cos(psi)))
    p_a = pad(pad(distance / cos_phi) - r)
    p_b = pad(distance * pad(tan(radians(given["phi"]))))
    w = pad(pad(r * given["omega"]) / p_a)
    return {"v_B": abs(pad(w * p_b)), "omega_AB": w}


def textbook(
    given: Givens,
    *,
    phi: float | None = None,
    side: int = 1,
    crank_normal: float = 1,
    rod_normal: float = 1,
) -> Answers:
    """All figures, with what a student may have mistaken: the angle in radians, the side of A on
    which B is, what becomes of the normal accelerations of A and of B about A.
    """
    r, omega, alpha = given["r"], given["omega"], given["alpha"]
    phi = radians(given["phi"]) if phi is None else phi
    length = given["k"] * r
    height = r * sin(phi)
    reach = side * sqrt(length**2 - height**2)
    w = r * omega * cos(phi) / reach
    a_x = r * alpha * sin(phi) - crank_normal * r * omega**2 * cos(phi)
    a_y = -r * alpha * cos(phi) - crank_normal * r * omega**2 * sin(phi)
    e = -(a_y + rod_normal * w**2 * height) / reach
    return {
        "v_B": abs(height * (omega + w)),
        "omega_AB": w,
        "alpha_AB": e,
        "a_B": a_x - rod_normal * w**2 * reach + e * height,
    }


def turned_about_o(given: Givens) -> Answers:
    """The rod's pole is taken to be O."""
    phi = radians(given["phi"])
    distance = given["r"] * (cos(phi) + sqrt(given["k"] ** 2 - sin(phi) ** 2))
    return {"v_B": given["omega"] * distance, "omega_AB": -given["omega"]}


def _shape(given: Givens) -> tuple[float, float, float, float]:
    """sin and cos of the crank's angle, sin and cos of psi."""
    phi = radians(given["phi"])
    sin_psi = sin(phi) / given["k"]
    return sin(phi), cos(phi), sin_psi, sqrt(1 - sin_psi**2)


def speed_about_base(given: Givens, w: float) -> float:
    sin_phi, *_ = _shape(given)
    return abs(given["r"] * sin_phi * (given["omega"] + w))


def speed_about_pole(given: Givens, w: float) -> float:
    sin_phi, cos_phi, _, cos_psi = _shape(given)
    return abs(w * given["r"] * (cos_phi + given["k"] * cos_psi) * sin_phi / cos_phi)


def rod_change(given: Givens, w: float) -> float:
    """The rod's angular acceleration from its angular velocity."""
    sin_phi, cos_phi, sin_psi, cos_psi = _shape(given)
    crank = given["omega"] ** 2 * sin_phi + given["alpha"] * cos_phi
    return (crank - given["k"] * w**2 * sin_psi) / (given["k"] * cos_psi)


def slider_by_rate(given: Givens, w: float) -> float:
    return slider_by_change(given, rod_change(given, w), w)


def slider_by_change(given: Givens, e: float, w: float | None = None) -> float:
    sin_phi, cos_phi, sin_psi, cos_psi = _shape(given)
    w = given["omega"] * cos_phi / (given["k"] * cos_psi) if w is None else w
    crank = given["alpha"] * sin_phi - given["omega"] ** 2 * cos_phi
    return given["r"] * (crank + given["k"] * (e * sin_psi - w**2 * cos_psi))


METHODS: Mapping[str, Method] = {
    "base point": base_point,
    "projection": projection,
    "loop": loop,
    "pole": pole,
}
MISTAKES: Mapping[str, Mistake] = {
    "relative-normal-dropped": lambda given: textbook(given, rod_normal=0),
    "path-normal-dropped": lambda given: textbook(given, crank_normal=0),
    "other-branch": lambda given: textbook(given, side=-1),
    "sine-for-cosine": lambda given: textbook(given, phi=pi / 2 - radians(given["phi"])),
    "degrees-for-radians": lambda given: textbook(given, phi=given["phi"]),
    "wrong-pole": turned_about_o,
    **slips_in_writing(textbook, ("omega_AB", "alpha_AB", "a_B")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_AB", "v_B", speed_about_base),
    Edge("omega_AB", "v_B", speed_about_pole),
    Edge("omega_AB", "alpha_AB", rod_change),
    Edge("omega_AB", "a_B", slider_by_rate),
    Edge("alpha_AB", "a_B", slider_by_change),
)
