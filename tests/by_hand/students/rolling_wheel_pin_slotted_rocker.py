"""Students of the pin B on the rim of a rolling wheel, in the slot of a rocker tangent to the rim.

The rocker turns about D, the wheel touches the ground in P; DB = DP = R (1 + cos phi)/sin phi, and
PB = 2 R cos(phi/2). Across DB means here the side to which the wheel rolls: it turns the rocker
counter-clockwise. A wheel that rolls to the right is seen in a mirror.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, radians, sin, tan

from tests.by_hand.components import magnitude
from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.slips import (
    Steps,
    degrees_for_radians,
    diameter_for_radius,
    sine_for_cosine,
    slip,
    supplementary_angle,
)
from tests.by_hand.writing import slips_in_writing

TURNING = ("omega_1", "alpha_1", "omega_2", "alpha_2")


def in_a_mirror(steps: Steps) -> Steps:
    """The method where the wheel rolls to the left; in a mirror for one that rolls to the right."""

    def work(given: Givens, p: Pad, **slipped: float) -> Answers:
        found = steps(_mirror(given), p, **slipped)
        return {name: _side(given) * x if name in TURNING else x for name, x in found.items()}

    return work


def _side(given: Givens) -> int:
    return 1 if given["v_O"] > 0 else -1


def _mirror(given: Givens) -> Givens:
    return {**given, **{name: _side(given) * given[name] for name in ("v_O", "a_O")}}


@in_a_mirror
def work_along_the_slot(
    given: Givens,
    p: Pad,
    *,
    coriolis: float = 2,
    relative_normal: float = 1,
    path_normal: float = 1,
    tangential: float = 1,
    square: float = 2,
    rocking: float = 1,
    centre: float = 1,
    relative: float = 1,
) -> Answers:
    """v_O + v_BO = v_e + v_r along DB and across it, and the same of accelerations."""
    phi, radius, v_o, a_o = (given[name] for name in ("phi", "R", "v_O", "a_O"))
    sine, cosine = p(sin(radians(phi))), p(cos(radians(phi)))
    arm = p(radius * p(p(1 + cosine) / sine))
    turning, turned = p(v_o / radius), p(a_o / radius)
    along, across = p(centre * p(v_o * cosine) + v_o), p(centre * p(v_o * sine))
    rocker = p(across / arm) if relative else p(magnitude(along, across, p) / arm)
    cor = p(coriolis * p((rocker if rocking else turning) * along))
    normal = p(relative_normal * p(p(turning**square) * radius))
    a_along = p(p(a_o * cosine) + tangential * a_o)
    a_across = p(p(a_o * sine) + normal)
    return {
        "omega_1": turning,
        "alpha_1": turned,
        "v_B": magnitude(along, across, p),
        "v_rel": along,
        "omega_2": rocker,
        "a_cor": abs(cor),
        "a_B": magnitude(a_along, a_across, p),
        "a_rel": p(a_along + p(path_normal * p(p(rocker**square) * arm))),
        "alpha_2": p(p(a_across - cor) / arm),
    }


@in_a_mirror
def work_from_the_pole(given: Givens, p: Pad) -> Answers:
    """v_B from the pole P, at phi/2 to the slot; accelerations with x to the left and y upwards."""
    phi, radius, v_o, a_o = radians(given["phi"]), given["R"], given["v_O"], given["a_O"]
    half = phi / 2
    arm = p(radius / p(tan(half)))
    turning, turned = p(v_o / radius), p(a_o / radius)
    v_b = p(turning * p(2 * p(radius * p(cos(half)))))
    v_rel, carried = p(v_b * p(cos(half))), p(v_b * p(sin(half)))
    rocker = p(carried / arm)
    sine, cosine = p(sin(phi)), p(cos(phi))
    rim, inwards = p(turned * radius), p(p(turning**2) * radius)
    left = p(p(a_o + p(rim * cosine)) + p(inwards * sine))
    up = p(p(rim * sine) - p(inwards * cosine))
    along, across = p(p(left * cosine) + p(up * sine)), p(p(left * sine) - p(up * cosine))
    cor = p(2 * p(rocker * v_rel))
    return {
        "omega_1": turning,
        "alpha_1": turned,
        "v_B": v_b,
        "v_rel": v_rel,
        "omega_2": rocker,
        "a_cor": cor,
        "a_B": magnitude(left, up, p),
        "a_rel": p(along + p(p(rocker**2) * arm)),
        "alpha_2": p(p(across - cor) / arm),
    }


@in_a_mirror
def work_with_components(given: Givens, p: Pad) -> Answers:
    """Both sides on x to the left and y upwards: two equations for omega_2 and v_r, two for rates.

    x: v_r cos phi + omega_2 DB sin phi = v_Bx and y: v_r sin phi - omega_2 DB cos phi = v_By, of
    which the first, divided by sin phi, leaves omega_2 after the second is put in.
    """
    phi, radius, v_o, a_o = radians(given["phi"]), given["R"], given["v_O"], given["a_O"]
    sine, cosine, cotangent = p(sin(phi)), p(cos(phi)), p(1 / p(tan(phi)))
    arm = p(radius * p(p(1 + cosine) / sine))
    turning, turned = p(v_o / radius), p(a_o / radius)
    v_x, v_y = p(v_o + p(v_o * cosine)), p(v_o * sine)
    carried = p(p(v_x - p(v_y * cotangent)) * sine)
    v_rel = p(p(v_y + p(carried * cosine)) / sine)
    rocker = p(carried / arm)
    inwards = p(p(turning**2) * radius)
    a_x = p(p(a_o + p(a_o * cosine)) + p(inwards * sine))
    a_y = p(p(a_o * sine) - p(inwards * cosine))
    cor = p(2 * p(rocker * v_rel))
    across = p(p(a_x - p(a_y * cotangent)) * sine)
    along = p(p(a_y + p(across * cosine)) / sine)
    return {
        "omega_1": turning,
        "alpha_1": turned,
        "v_B": magnitude(v_x, v_y, p),
        "v_rel": v_rel,
        "omega_2": rocker,
        "a_cor": cor,
        "a_B": magnitude(a_x, a_y, p),
        "a_rel": p(along + p(p(rocker**2) * arm)),
        "alpha_2": p(p(across - cor) / arm),
    }


def v_rel_of_pin(given: Givens, v_b: float) -> float:
    return v_b * cos(radians(given["phi"]) / 2)


def rocker_of_pin(given: Givens, v_b: float) -> float:
    half = radians(given["phi"]) / 2
    return _side(given) * v_b * sin(half) * tan(half) / given["R"]


def v_rel_of_rocker(given: Givens, rocker: float) -> float:
    """The triangle of v_B = v_e + v_r, in which v_B is at phi/2 to the slot."""
    return _side(given) * rocker * given["R"] / tan(radians(given["phi"]) / 2) ** 2


def _turned(given: Givens, rocker: float | None = None, v_rel: float | None = None) -> float:
    """alpha_2 from what of the velocities is the student's own."""
    side, given = _side(given), _mirror(given)
    phi, radius, v_o = radians(given["phi"]), given["R"], given["v_O"]
    rocker = v_o / radius * (1 - cos(phi)) if rocker is None else side * rocker
    v_rel = v_o * (1 + cos(phi)) if v_rel is None else v_rel
    across = given["a_O"] * sin(phi) + v_o**2 / radius - 2 * rocker * v_rel
    return side * across * tan(phi / 2) / radius


def turned_by_rocker(given: Givens, rocker: float) -> float:
    return _turned(given, rocker=rocker)


def turned_by_v_rel(given: Givens, v_rel: float) -> float:
    return _turned(given, v_rel=v_rel)


def turned_by_pin(given: Givens, v_b: float) -> float:
    return _turned(given, rocker_of_pin(given, v_b), v_rel_of_pin(given, v_b))


SIGNED = ("omega_1", "alpha_1", "omega_2", "alpha_2", "v_rel", "a_rel")
METHODS: Mapping[str, Method] = {
    "along the slot": work_along_the_slot,
    "pole": work_from_the_pole,
    "components": work_with_components,
}
MISTAKES: Mapping[str, Mistake] = {
    "coriolis-dropped": slip(work_along_the_slot, coriolis=0),
    "coriolis-halved": slip(work_along_the_slot, coriolis=1),
    "coriolis-reversed": slip(work_along_the_slot, coriolis=-2),
    "relative-normal-dropped": slip(work_along_the_slot, relative_normal=0),
    "path-normal-dropped": slip(work_along_the_slot, path_normal=0),
    "coriolis-wrong-omega": slip(work_along_the_slot, rocking=0),
    "relative-normal-outwards": slip(work_along_the_slot, relative_normal=-1),
    "path-normal-outwards": slip(work_along_the_slot, path_normal=-1),
    "omega-not-squared": slip(work_along_the_slot, square=1),
    "tangential-dropped": slip(work_along_the_slot, tangential=0),
    "centre-for-pole": slip(work_along_the_slot, centre=0),
    "transport-for-absolute": slip(work_along_the_slot, relative=0),
    "sine-for-cosine": sine_for_cosine(work_along_the_slot, "phi"),
    "degrees-for-radians": degrees_for_radians(work_along_the_slot, "phi"),
    "diameter-for-radius": diameter_for_radius(work_along_the_slot, "R"),
    "supplementary-angle": supplementary_angle(work_along_the_slot, "phi"),
    **slips_in_writing(slip(work_along_the_slot), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_B", "v_rel", v_rel_of_pin, SIZES),
    Edge("v_B", "omega_2", rocker_of_pin, SIZES),
    Edge("v_B", "alpha_2", turned_by_pin, SIZES),
    Edge("omega_2", "v_rel", v_rel_of_rocker),
    Edge("omega_2", "alpha_2", turned_by_rocker),
    Edge("v_rel", "alpha_2", turned_by_v_rel),
)
