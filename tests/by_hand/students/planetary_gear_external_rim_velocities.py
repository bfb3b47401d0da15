"""A planet gear that an arm carries round a fixed sun gear: velocities of its rim."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, pi, radians, sin, sqrt

from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def pole(given: Givens, pad: Pad) -> Answers:
    """The planet turns about its point of contact D."""
    v_a = pad(given["omega0"] * pad(given["r1"] + given["r2"]))
    w = pad(v_a / given["r2"])
    v_b = pad(w * pad(pad(sqrt(2)) * given["r2"]))
    v_c = pad(w * pad(2 * given["r2"]))
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    return {
        "omega_II": w,
        "v_B": v_b,
        "v_C": v_c,
        "v_C_x": -pad(v_c * sine),
        "v_C_y": pad(v_c * cosine),
    }


def base_point(given: Givens, pad: Pad) -> Answers:
    """A is the base point; components on x and y, D standing still gives the rate."""
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    v_a = pad(given["omega0"] * pad(given["r1"] + given["r2"]))
    a_x, a_y = -pad(v_a * sine), pad(v_a * cosine)
    w = pad(v_a / given["r2"])
    about = pad(w * given["r2"])
    b_x, b_y = pad(a_x - pad(about * cosine)), pad(a_y - pad(about * sine))
    c_x, c_y = pad(a_x - pad(about * sine)), pad(a_y + pad(about * cosine))
    return {
        "omega_II": w,
        "v_B": pad.root(pad(pad(b_x**2) + pad(b_y**2))),
        "v_C": pad.root(pad(pad(c_x**2) + pad(c_y**2))),
        "v_C_x": c_x,
        "v_C_y": c_y,
    }


def willis(given: Givens, pad: Pad) -> Answers:
    """The arm is the moving frame, in which the planet turns by omega0 r1 / r2."""
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    relative = pad(given["omega0"] * pad(given["r1"] / given["r2"]))
    slip = pad(relative * given["r2"])
    arm = pad(given["r1"] + given["r2"])
    across = pad(given["omega0"] * arm)
    inwards = pad(pad(given["omega0"] * given["r2"]) + slip)
    v_c = pad(pad(given["omega0"] * pad(arm + given["r2"])) + slip)
    return {
        "omega_II": pad(given["omega0"] + relative),
        "v_B": pad.root(pad(pad(across**2) + pad(inwards**2))),
        "v_C": v_c,
        "v_C_x": -pad(v_c * sine),
        "v_C_y": pad(v_c * cosine),
    }


def rim(given: Givens, v_a: float, w: float, phi: float | None = None) -> Answers:
    """What follows from the speed of A and the planet's rate; the angle may be another one."""
    phi = radians(given["phi"]) if phi is None else phi
    about = w * given["r2"]
    v_c = v_a + about
    return {
        "omega_II": w,
        "v_B": hypot(v_a, about),
        "v_C": abs(v_c),
        "v_C_x": -v_c * sin(phi),
        "v_C_y": v_c * cos(phi),
    }


def speed(given: Givens) -> float:
    """The speed of the planet's centre."""
    return given["omega0"] * (given["r1"] + given["r2"])


def textbook(given: Givens, phi: float | None = None) -> Answers:
    return rim(given, speed(given), speed(given) / given["r2"], phi)


def turning(rate: Mistake) -> Mistake:
    """Students who have another rate of the planet."""

    def answers(given: Givens) -> Answers:
        return rim(given, speed(given), rate(given)["omega_II"])

    return answers


def relative_to_arm(given: Givens) -> Answers:
    return {"omega_II": given["omega0"] * given["r1"] / given["r2"]}


def meshing_inside(given: Givens) -> Answers:
    return {"omega_II": given["omega0"] * (1 - given["r1"] / given["r2"])}


def inverse(given: Givens) -> Answers:
    return {"omega_II": given["omega0"] * given["r2"] / (given["r1"] + given["r2"])}


def about_centre(given: Givens) -> Answers:
    """The rim's speed counted from the centre A, as if that stood still."""
    wrong = rim(given, 0, speed(given) / given["r2"])
    return {ask: wrong[ask] for ask in ("v_B", "v_C", "v_C_x", "v_C_y")}


def sun_for_arm(given: Givens) -> Answers:
    """The sun's radius taken for the length of the arm."""
    v_a = given["omega0"] * given["r1"]
    return rim(given, v_a, v_a / given["r2"])


def added(given: Givens) -> Answers:
    return {"v_B": 2 * speed(given)}


def doubled(given: Givens) -> Answers:
    """Both diameters for radii."""
    return textbook({**given, "r1": 2 * given["r1"], "r2": 2 * given["r2"]})


def v_b_about_pole(given: Givens, w: float) -> float:
    return abs(w) * sqrt(2) * given["r2"]


def v_b_about_centre(given: Givens, w: float) -> float:
    return rim(given, speed(given), w)["v_B"]


def v_c_about_pole(given: Givens, w: float) -> float:
    return abs(2 * w * given["r2"])


def v_c_about_centre(given: Givens, w: float) -> float:
    return rim(given, speed(given), w)["v_C"]


def v_c_x_about_centre(given: Givens, w: float) -> float:
    return rim(given, speed(given), w)["v_C_x"]


def v_c_y_about_pole(given: Givens, w: float) -> float:
    return 2 * w * given["r2"] * cos(radians(given["phi"]))


def v_c_x_by_size(given: Givens, v_c: float) -> float:
    return -v_c * sin(radians(given["phi"]))


def v_c_y_by_size(given: Givens, v_c: float) -> float:
    return v_c * cos(radians(given["phi"]))


METHODS: Mapping[str, Method] = {"pole": pole, "base point": base_point, "Willis": willis}
MISTAKES: Mapping[str, Mistake] = {
    "relative-for-absolute": turning(relative_to_arm),
    "meshing-reversed": turning(meshing_inside),
    "inverse-ratio": turning(inverse),
    "centre-for-pole": about_centre,
    "arm-for-sum": sun_for_arm,
    "added-as-scalars": added,
    "diameter-for-radius": doubled,
    "sine-for-cosine": lambda given: textbook(given, pi / 2 - radians(given["phi"])),
    "degrees-for-radians": lambda given: textbook(given, given["phi"]),
    **slips_in_writing(textbook, ("omega_II", "v_C_x", "v_C_y")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_II", "v_B", v_b_about_pole),
    Edge("omega_II", "v_B", v_b_about_centre),
    Edge("omega_II", "v_C", v_c_about_pole),
    Edge("omega_II", "v_C", v_c_about_centre, SIZES),  # reversed, C stands still: 0 is no answer
    Edge("omega_II", "v_C_x", v_c_x_about_centre, SIZES),
    Edge("omega_II", "v_C_y", v_c_y_about_pole),
    Edge("v_C", "v_C_x", v_c_x_by_size, SIZES),
    Edge("v_C", "v_C_y", v_c_y_by_size, SIZES),
)
