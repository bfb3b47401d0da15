"""Students of the pin M in the slots of a disc and of a rod, which turn about one fixed point O.

M is at (b, b tan phi). The slot of the disc is vertical, that of the rod along OM.
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


def work_in_two_frames(
    given: Givens,
    p: Pad,
    *,
    coriolis: float = 2,
    normal: float = 1,
    tangential: float = 1,
    square: float = 2,
) -> Answers:
    """v_e + v_r for the disc equals v_e + v_r for the rod, on the x and y axes; so does a."""
    phi, b = radians(given["phi"]), given["b"]
    disc, rod = given["omega_1"], given["omega_2"]
    sine, cosine = p(sin(phi)), p(cos(phi))
    y, distance = p(b * p(tan(phi))), p(b / cosine)
    carried_by_disc, carried_by_rod = p(-p(disc * y)), p(-p(rod * y))
    v_rod = p(p(carried_by_disc - carried_by_rod) / cosine)
    v_y = p(p(rod * b) + p(v_rod * sine))
    v_disc = p(v_y - p(disc * b))
    coriolis_disc, coriolis_rod = p(coriolis * p(disc * v_disc)), p(coriolis * p(rod * v_rod))
    normal_disc, normal_rod = normal * p(disc**square), normal * p(rod**square)
    turned_disc, turned_rod = tangential * given["alpha_1"], tangential * given["alpha_2"]
    a_x = p(-p(normal_disc * b) - p(turned_disc * y) - coriolis_disc)
    of_rod_x = p(-p(normal_rod * b) - p(turned_rod * y) - p(coriolis_rod * sine))
    a_rod = p(p(a_x - of_rod_x) / cosine)
    of_rod_y = p(-p(normal_rod * y) + p(turned_rod * b) + p(coriolis_rod * cosine))
    a_y = p(of_rod_y + p(a_rod * sine))
    a_disc = p(a_y - p(-p(normal_disc * y) + p(turned_disc * b)))
    return {
        "OM": abs(distance),
        "v_rel_1": v_disc,
        "v_rel_2": v_rod,
        "v_M_x": carried_by_disc,
        "v_M_y": v_y,
        "v_M": magnitude(carried_by_disc, v_y, p),
        "a_cor_1": coriolis_disc,
        "a_cor_2": coriolis_rod,
        "a_rel_1": a_disc,
        "a_rel_2": a_rod,
        "a_M_x": a_x,
        "a_M_y": a_y,
        "a_M": magnitude(a_x, a_y, p),
    }


def work_along_the_rod(given: Givens, p: Pad) -> Answers:
    """The same equation projected along the rod and across it: no unknown but one in each."""
    phi, b = radians(given["phi"]), given["b"]
    disc, rod = given["omega_1"], given["omega_2"]
    sine, cosine = p(sin(phi)), p(cos(phi))
    om = p(b / cosine)
    v_disc = p(p(p(rod * om) - p(disc * om)) / cosine)  # across
    v_rod = p(v_disc * sine)
    v_x, v_y = p(-p(disc * p(b * p(tan(phi))))), p(p(disc * b) + v_disc)
    coriolis_disc, coriolis_rod = p(2 * p(disc * v_disc)), p(2 * p(rod * v_rod))
    carried_across = p(p(given["alpha_1"] * om) + p(coriolis_disc * sine))
    across = p(p(given["alpha_2"] * om) + coriolis_rod)
    a_disc = p(p(across - carried_across) / cosine)
    along = p(p(-p(p(disc**2) * om) - p(coriolis_disc * cosine)) + p(a_disc * sine))
    a_rod = p(along + p(p(rod**2) * om))
    a_x, a_y = p(p(along * cosine) - p(across * sine)), p(p(along * sine) + p(across * cosine))
    return {
        "OM": om,
        "v_rel_1": v_disc,
        "v_rel_2": v_rod,
        "v_M_x": v_x,
        "v_M_y": v_y,
        "v_M": magnitude(v_x, v_y, p),
        "a_cor_1": coriolis_disc,
        "a_cor_2": coriolis_rod,
        "a_rel_1": a_disc,
        "a_rel_2": a_rod,
        "a_M_x": a_x,
        "a_M_y": a_y,
        "a_M": magnitude(along, across, p),
    }


def differentiate_the_distance(given: Givens, p: Pad) -> Answers:
    """OM = b/cos(chi) with chi the angle between the slots, then polar coordinates of M."""
    phi, b, rod = radians(given["phi"]), given["b"], given["omega_2"]
    sine, cosine, tangent = p(sin(phi)), p(cos(phi)), p(tan(phi))
    rate = rod - given["omega_1"]
    turned = given["alpha_2"] - given["alpha_1"]
    om = p(b / cosine)
    slope = p(om * tangent)
    v_rod = p(slope * rate)
    bend = p(om * p(1 + p(2 * p(tangent**2))))
    grown = p(p(slope * turned) + p(bend * p(rate**2)))
    across = p(om * rod)
    v_x = p(p(v_rod * cosine) - p(across * sine))
    v_y = p(p(v_rod * sine) + p(across * cosine))
    coriolis_rod = p(2 * p(rod * v_rod))
    radial = p(grown - p(om * p(rod**2)))
    transverse = p(p(om * given["alpha_2"]) + coriolis_rod)
    a_x = p(p(radial * cosine) - p(transverse * sine))
    a_y = p(p(radial * sine) + p(transverse * cosine))
    return {
        "OM": om,
        "v_rel_2": v_rod,
        "v_M_x": v_x,
        "v_M_y": v_y,
        "v_M": magnitude(v_x, v_y, p),
        "a_cor_2": coriolis_rod,
        "a_rel_2": grown,
        "a_M_x": a_x,
        "a_M_y": a_y,
        "a_M": magnitude(radial, transverse, p),
    }


def carried_along(given: Givens) -> Answers:
    """The point of the disc under M taken for M."""
    x, y = given["b"], given["b"] * tan(radians(given["phi"]))
    return {
        "v_M": given["omega_1"] * hypot(x, y),
        "v_M_x": -given["omega_1"] * y,
        "v_M_y": given["omega_1"] * x,
    }


def v_x_on_rod(given: Givens, v_rod: float) -> float:
    phi = radians(given["phi"])
    return v_rod * cos(phi) - given["omega_2"] * given["b"] * tan(phi)


def v_y_on_rod(given: Givens, v_rod: float) -> float:
    return v_rod * sin(radians(given["phi"])) + given["omega_2"] * given["b"]


def a_x_on_disc(given: Givens, v_y: float) -> float:
    """The disc as moving frame: M moves in its slot by what the disc does not carry it."""
    b, disc = given["b"], given["omega_1"]
    turned = given["alpha_1"] * b * tan(radians(given["phi"]))
    return -(disc**2) * b - turned - 2 * disc * (v_y - disc * b)


def a_x_after_v_rod(given: Givens, v_rod: float) -> float:
    return a_x_on_disc(given, v_y_on_rod(given, v_rod))


def a_y_on_rod(given: Givens, a_x: float, v_rod: float | None = None) -> float:
    """Across the rod there is no relative acceleration: a_y from a_x."""
    phi, rod, om = radians(given["phi"]), given["omega_2"], given["b"] / cos(radians(given["phi"]))
    right = om * tan(phi) * (rod - given["omega_1"])
    coriolis = 2 * rod * (right if v_rod is None else v_rod)
    return (given["alpha_2"] * om + coriolis + a_x * sin(phi)) / cos(phi)


def a_y_after_v_rod(given: Givens, v_rod: float) -> float:
    return a_y_on_rod(given, a_x_after_v_rod(given, v_rod), v_rod)


SIGNED = (
    "v_M_x",
    "v_M_y",
    "a_M_x",
    "a_M_y",
    "v_rel_1",
    "v_rel_2",
    "a_rel_1",
    "a_rel_2",
    "a_cor_1",
    "a_cor_2",
)
METHODS: Mapping[str, Method] = {
    "two frames": work_in_two_frames,
    "along the rod": work_along_the_rod,
    "distance differentiated": differentiate_the_distance,
}
MISTAKES: Mapping[str, Mistake] = {
    "coriolis-dropped": slip(work_in_two_frames, coriolis=0),
    "coriolis-halved": slip(work_in_two_frames, coriolis=1),
    "coriolis-reversed": slip(work_in_two_frames, coriolis=-2),
    "path-normal-dropped": slip(work_in_two_frames, normal=0),
    "path-normal-outwards": slip(work_in_two_frames, normal=-1),
    "omega-not-squared": slip(work_in_two_frames, square=1),
    "tangential-dropped": slip(work_in_two_frames, tangential=0),
    "transport-for-absolute": carried_along,
    "sine-for-cosine": sine_for_cosine(work_in_two_frames, "phi"),
    "degrees-for-radians": degrees_for_radians(work_in_two_frames, "phi"),
    "supplementary-angle": supplementary_angle(work_in_two_frames, "phi"),
    **slips_in_writing(slip(work_in_two_frames), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_rel_2", "v_M_x", v_x_on_rod),
    Edge("v_rel_2", "v_M_y", v_y_on_rod),
    Edge("v_rel_2", "a_M_x", a_x_after_v_rod),
    Edge("v_rel_2", "a_M_y", a_y_after_v_rod),
    Edge("v_M_y", "a_M_x", a_x_on_disc),
    Edge("a_M_x", "a_M_y", a_y_on_rod),
)
