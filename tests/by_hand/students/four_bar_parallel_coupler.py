"""Students of the four-bar linkage whose coupler BD is parallel to the ground line AE.

B and D are at the height l_AB sin theta_A; ED leans back to the left.
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


def work_from_the_base_point(
    given: Givens,
    p: Pad,
    *,
    relative_normal: float = 1,
    path_normal: float = 1,
    tangential: float = 1,
    square: float = 2,
) -> Answers:
    """D from the base point B, on the x and y axes."""
    crank, coupler, omega = given["l_AB"], given["l_BD"], given["omega_AB"]
    sine, cosine = p.sin(given["theta_A"]), p.cos(given["theta_A"])
    height, reach = p(crank * sine), p(crank * cosine)
    rocker = p(height / p.sin(given["theta_E"]))
    lean = p(rocker * p.cos(given["theta_E"]))
    v_b_x, v_b_y = p(-p(omega * height)), p(omega * reach)
    turning = p(-v_b_x / height)  # of the rocker
    v_d_y = p(-p(turning * lean))
    v_db = p(v_d_y - v_b_y)
    rate = p(v_db / coupler)
    v_c_y = p(v_b_y + p(v_db / 2))
    squared, alpha = path_normal * p(omega**square), tangential * given["alpha_AB"]
    a_b_x = p(-p(alpha * height) - p(squared * reach))
    a_b_y = p(p(alpha * reach) - p(squared * height))
    towards_b = p(relative_normal * p(p(abs(rate) ** square) * coupler))
    a_d_x = p(a_b_x - towards_b)
    squared = path_normal * p(turning**square)
    turned = p(p(p(squared * lean) - a_d_x) / height)
    a_d_y = p(-p(turned * lean) - p(squared * height))
    across = p(a_d_y - a_b_y)
    a_c_x, a_c_y = p(a_b_x - p(towards_b / 2)), p(a_b_y + p(across / 2))
    return {
        "l_DE": rocker,
        "v_B": p(omega * crank),
        "v_D": p(turning * rocker),
        "v_DB": abs(v_db),
        "omega_BD": rate,
        "omega_DE": turning,
        "v_CB": p(abs(v_db) / 2),
        "v_C_x": v_b_x,
        "v_C_y": v_c_y,
        "v_C": magnitude(v_b_x, v_c_y, p),
        "a_B": magnitude(a_b_x, a_b_y, p),
        "a_D": magnitude(a_d_x, a_d_y, p),
        "alpha_DE": turned,
        "alpha_BD": p(across / coupler),
        "a_C_x": a_c_x,
        "a_C_y": a_c_y,
        "a_C": magnitude(a_c_x, a_c_y, p),
    }


def work_from_the_pole(given: Givens, p: Pad) -> Answers:
    """Velocities from the pole P, where AB and ED meet; accelerations along DE and across it."""
    crank, coupler, omega = given["l_AB"], given["l_BD"], given["omega_AB"]
    angle_a, angle_e = radians(given["theta_A"]), radians(given["theta_E"])
    sine_a, cosine_a = p(sin(angle_a)), p(cos(angle_a))
    sine_e, cosine_e = p(sin(angle_e)), p(cos(angle_e))
    rocker = p(p(crank * sine_a) / sine_e)
    at_pole = p(sin(angle_a + angle_e))
    to_b, to_d = p(p(coupler * sine_e) / at_pole), p(p(coupler * sine_a) / at_pole)
    v_b = p(omega * crank)
    rate = p(v_b / to_b)
    v_d = p(rate * to_d)
    turning = p(v_d / rocker)
    pole_x, pole_y = p(p(crank + to_b) * cosine_a), p(p(crank + to_b) * sine_a)
    right = p(p(p(crank * cosine_a) + p(coupler / 2)) - pole_x)  # of C from the pole
    below = p(pole_y - p(crank * sine_a))
    v_c_x, v_c_y = p(-p(rate * below)), p(-p(rate * right))
    normal_b, tangential_b = p(p(omega**2) * crank), p(given["alpha_AB"] * crank)
    normal_d, towards_b = p(p(turning**2) * rocker), p(p(rate**2) * coupler)
    a_b_x = p(-p(normal_b * cosine_a) - p(tangential_b * sine_a))
    a_b_y = p(p(tangential_b * cosine_a) - p(normal_b * sine_a))
    along = p(-normal_d)  # from E to D: the x axis eliminates alpha_BD
    across = p(p(p(along * cosine_e) + p(a_b_x - towards_b)) / sine_e)
    turned = p(-across / rocker)
    a_d_y = p(p(along * sine_e) + p(across * cosine_e))
    a_c_x, a_c_y = p(a_b_x - p(towards_b / 2)), p(p(a_b_y + a_d_y) / 2)
    return {
        "l_DE": rocker,
        "v_B": v_b,
        "v_D": v_d,
        "v_DB": p(rate * coupler),
        "omega_BD": -rate,
        "omega_DE": turning,
        "v_CB": p(p(rate * coupler) / 2),
        "v_C_x": v_c_x,
        "v_C_y": v_c_y,
        "v_C": p(abs(rate) * magnitude(right, below, p)),
        "ic_x": pole_x,
        "ic_y": pole_y,
        "a_B": magnitude(normal_b, tangential_b, p),
        "a_D": magnitude(along, across, p),
        "alpha_DE": turned,
        "alpha_BD": p(p(a_d_y - a_b_y) / coupler),
        "a_C_x": a_c_x,
        "a_C_y": a_c_y,
        "a_C": magnitude(a_c_x, a_c_y, p),
    }


def _shape(given: Givens) -> tuple[float, float, float]:
    """The height of BD, how far B is to the right of A, and D to the left of E."""
    height = given["l_AB"] * sin(radians(given["theta_A"]))
    reach = given["l_AB"] * cos(radians(given["theta_A"]))
    return height, reach, height / tan(radians(given["theta_E"]))


def go_on(given: Givens, rate: float, rocker: float | None = None) -> Answers:
    """What a student finds who has taken these for the turning of BD and of DE."""
    rocker = given["omega_AB"] if rocker is None else rocker
    return {
        "omega_BD": rate,
        "omega_DE": rocker,
        "v_C": middle_about_b(given, rate),
        "alpha_DE": _turned(given, rate, rocker),
    }


def about_a(given: Givens) -> Answers:
    """The coupler taken to turn with the crank about A."""
    height, reach, lean = _shape(given)
    v_d = given["omega_AB"] * hypot(height, reach + given["l_BD"])
    return go_on(given, given["omega_AB"], v_d / hypot(height, lean))


def about_e(given: Givens) -> Answers:
    """The coupler taken to turn with the rocker about E."""
    height, _, lean = _shape(given)
    rate = given["omega_AB"] * given["l_AB"] / hypot(height, lean + given["l_BD"])
    v_c = rate * hypot(height, lean + given["l_BD"] / 2)
    return go_on(given, -rate, rate) | {"v_C": v_c}


def about_the_velocities(given: Givens) -> Answers:
    """The pole sought where the directions of v_B and v_D meet, below BD."""
    height, reach, lean = _shape(given)
    below = given["l_BD"] / (height / reach + height / lean)
    left = below * height / reach  # of the pole, from B to the right
    rate = given["omega_AB"] * given["l_AB"] / hypot(below, left)
    v_c = rate * hypot(below, left - given["l_BD"] / 2)
    v_d = rate * hypot(below, left - given["l_BD"])
    return go_on(given, -rate, v_d / hypot(height, lean)) | {"v_C": v_c}


def in_translation(given: Givens) -> Answers:
    """The coupler taken to be in instantaneous translation: v_D is v_B."""
    height, _, lean = _shape(given)
    return go_on(given, 0, given["omega_AB"] * given["l_AB"] / hypot(height, lean))


def about_d(given: Givens) -> Answers:
    """omega_BD taken to be v_B/BD."""
    rate = -given["omega_AB"] * given["l_AB"] / given["l_BD"]
    return {"omega_BD": rate, "alpha_DE": _turned(given, rate, given["omega_AB"])}


def rocker_about_b(given: Givens, rate: float) -> float:
    _, reach, lean = _shape(given)
    return -(given["omega_AB"] * reach + rate * given["l_BD"]) / lean


def rocker_by_pole(given: Givens, rate: float) -> float:
    """v_D = omega_BD PD = omega_DE DE, in triangles with the height of the pole."""
    height, reach, lean = _shape(given)
    whole = reach + given["l_BD"] + lean
    return -rate * (height * whole / (reach + lean) - height) / height


def middle_about_b(given: Givens, rate: float) -> float:
    height, reach, _ = _shape(given)
    omega = given["omega_AB"]
    return hypot(omega * height, omega * reach + rate * given["l_BD"] / 2)


def middle_by_pole(given: Givens, rate: float) -> float:
    height, reach, lean = _shape(given)
    grown = given["l_BD"] / (reach + lean)  # of the triangle over BD to that below it
    right = reach + given["l_BD"] / 2 - reach * (1 + grown)
    return abs(rate) * hypot(grown * height, right)


def turned_by_rate(given: Givens, rate: float) -> float:
    return _turned(given, rate, given["omega_AB"])


def turned_by_rocker(given: Givens, rocker: float) -> float:
    _, reach, lean = _shape(given)
    return _turned(given, -given["omega_AB"] * (reach + lean) / given["l_BD"], rocker)


def _turned(given: Givens, rate: float, rocker: float) -> float:
    """alpha_DE: along BD there is no unknown but it."""
    height, reach, lean = _shape(given)
    normals = given["omega_AB"] ** 2 * reach + rocker**2 * lean + rate**2 * given["l_BD"]
    return given["alpha_AB"] + normals / height


SIGNED = ("omega_BD", "omega_DE", "alpha_DE", "alpha_BD", "v_C_x", "v_C_y", "a_C_x", "a_C_y")
METHODS: Mapping[str, Method] = {
    "base point": work_from_the_base_point,
    "pole": work_from_the_pole,
}
MISTAKES: Mapping[str, Mistake] = {
    "relative-normal-dropped": slip(work_from_the_base_point, relative_normal=0),
    "path-normal-dropped": slip(work_from_the_base_point, path_normal=0),
    "relative-normal-outwards": slip(work_from_the_base_point, relative_normal=-1),
    "path-normal-outwards": slip(work_from_the_base_point, path_normal=-1),
    "omega-not-squared": slip(work_from_the_base_point, square=1),
    "tangential-dropped": slip(work_from_the_base_point, tangential=0),
    "wrong-pole": about_a,
    "far-pivot-for-pole": about_e,
    "far-end-for-pole": about_d,
    "pole-on-velocities": about_the_velocities,
    "translation-assumed": in_translation,
    "neighbours-omega": lambda given: go_on(given, given["omega_AB"]),
    "sine-for-cosine": sine_for_cosine(work_from_the_base_point, "theta_A", "theta_E"),
    "degrees-for-radians": degrees_for_radians(work_from_the_base_point, "theta_A", "theta_E"),
    "supplementary-angle": supplementary_angle(work_from_the_base_point, "theta_E"),
    **slips_in_writing(slip(work_from_the_base_point), SIGNED),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_BD", "omega_DE", rocker_about_b),
    Edge("omega_BD", "omega_DE", rocker_by_pole),
    Edge("omega_BD", "v_C", middle_about_b),
    Edge("omega_BD", "v_C", middle_by_pole),
    Edge("omega_BD", "alpha_DE", turned_by_rate),
    Edge("omega_DE", "alpha_DE", turned_by_rocker),
)
