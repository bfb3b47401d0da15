"""A flat-faced follower on a cam whose radius of curvature at the contact is known."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, pi, radians, sin

from tests.by_hand.pad import Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def relative_to_follower(given: Givens, pad: Pad) -> Answers:
    """The follower is the moving frame: in it the cam's point at A has -rho omega^2 along y."""
    sine, cosine = pad.sin(given["theta"]), pad.cos(given["theta"])
    square = pad(given["omega"] ** 2)
    v_c = pad(given["r"] * given["omega"])
    normal, tangential = pad(given["r"] * square), pad(given["r"] * given["eps"])
    a_c = pad(pad(tangential * sine) - pad(normal * cosine))
    bending = pad(given["rho"] * square)
    v_rel = pad(v_c * cosine)
    coriolis = pad(pad(2 * given["omega"]) * v_rel)
    return {
        "v_BC_y": pad(v_c * sine),
        "v_rel_x": v_rel,
        "a_BC_y": pad(a_c + bending),
        "a_cor_y": coriolis,
        "a_rel_y": pad(bending - coriolis),
    }


def centre_of_curvature(given: Givens, pad: Pad) -> Answers:
    """The follower moves as the height of K, which is a point of the cam; then the cam is the
    moving frame of the follower's point A.
    """
    x = pad(given["r"] * pad.sin(given["theta"]))
    y = pad(given["r"] * pad.cos(given["theta"]))
    square = pad(given["omega"] ** 2)
    a_k = pad(pad(given["eps"] * x) - pad(square * pad(y - given["rho"])))
    v_rel = pad(given["omega"] * y)
    coriolis = pad(pad(2 * given["omega"]) * v_rel)
    transport = pad(pad(given["eps"] * x) - pad(square * y))
    return {
        "v_BC_y": pad(given["omega"] * x),
        "v_rel_x": v_rel,
        "a_BC_y": a_k,
        "a_cor_y": coriolis,
        "a_rel_y": pad(pad(a_k - transport) - coriolis),
    }


def support_function(given: Givens, pad: Pad) -> Answers:
    """The height h of the face as a function of the cam's angle: h' = x_A, h + h'' = rho."""
    height = pad(given["r"] * pad.cos(given["theta"]))
    slope = pad(given["r"] * pad.sin(given["theta"]))
    second = pad(given["rho"] - height)
    square = pad(given["omega"] ** 2)
    v_rel = pad(height * given["omega"])
    return {
        "v_BC_y": pad(slope * given["omega"]),
        "v_rel_x": v_rel,
        "a_BC_y": pad(pad(second * square) + pad(slope * given["eps"])),
        "a_cor_y": pad(2 * pad(height * square)),
        "a_rel_y": pad(pad(given["rho"] - pad(2 * height)) * square),
    }


def textbook(
    given: Givens,
    *,
    theta: float | None = None,
    coriolis: float = 1,
    power: int = 2,
) -> Answers:
    """All figures, with what may be mistaken: the angle in radians, the share of the Coriolis
    acceleration, the power of omega in normal accelerations.
    """
    theta = radians(given["theta"]) if theta is None else theta
    omega, x, y = given["omega"], given["r"] * sin(theta), given["r"] * cos(theta)
    a_c = given["eps"] * x - abs(omega) ** power * y
    bending = given["rho"] * abs(omega) ** power
    a_cor = coriolis * 2 * omega**2 * y
    return {
        "v_BC_y": omega * x,
        "v_rel_x": omega * y,
        "a_BC_y": a_c + bending,
        "a_cor_y": a_cor,
        "a_rel_y": bending - a_cor,
    }


def only(mistake: Mistake, *asks: str) -> Mistake:
    """The mistake where a student makes it: in these asks."""
    return lambda given: {ask: mistake(given)[ask] for ask in asks}


def without_normal_of_centre(given: Givens) -> Answers:
    """The height of K followed without the normal acceleration of K."""
    return {"a_BC_y": given["eps"] * given["r"] * sin(radians(given["theta"]))}


def in_translation(given: Givens) -> Answers:
    """A Coriolis acceleration put in although the follower, the moving frame, does not turn."""
    right = textbook(given)
    return {"a_BC_y": right["a_BC_y"] + right["a_cor_y"]}


def swapped(given: Givens) -> Answers:
    """rho for r."""
    return {
        "v_BC_y": textbook({**given, "r": given["rho"]})["v_BC_y"],
        "v_rel_x": textbook({**given, "r": given["rho"]})["v_rel_x"],
    }


def coriolis_by_sliding(given: Givens, v_rel: float) -> float:
    return 2 * given["omega"] * v_rel


def relative_by_coriolis(given: Givens, a_cor: float) -> float:
    return given["rho"] * given["omega"] ** 2 - a_cor


def relative_by_sliding(given: Givens, v_rel: float) -> float:
    return relative_by_coriolis(given, coriolis_by_sliding(given, v_rel))


def cam_point(given: Givens) -> float:
    """The acceleration along y of the cam's point at A."""
    theta = radians(given["theta"])
    return given["r"] * (given["eps"] * sin(theta) - given["omega"] ** 2 * cos(theta))


def relative_by_follower(given: Givens, a_bc: float) -> float:
    return a_bc - cam_point(given) - textbook(given)["a_cor_y"]


METHODS: Mapping[str, Method] = {
    "relative to follower": relative_to_follower,
    "centre of curvature": centre_of_curvature,
    "support function": support_function,
}
MISTAKES: Mapping[str, Mistake] = {
    "coriolis-dropped": only(lambda given: textbook(given, coriolis=0), "a_rel_y"),
    "coriolis-reversed": only(lambda given: textbook(given, coriolis=-1), "a_rel_y"),
    "coriolis-halved": only(lambda given: textbook(given, coriolis=0.5), "a_cor_y", "a_rel_y"),
    "path-normal-dropped": without_normal_of_centre,
    "omega-not-squared": only(lambda given: textbook(given, power=1), "a_BC_y"),
    "tangential-dropped": only(lambda given: textbook({**given, "eps": 0}), "a_BC_y"),
    "coriolis-wrong-omega": in_translation,
    "one-length-for-another": swapped,
    "sine-for-cosine": lambda given: textbook(given, theta=pi / 2 - radians(given["theta"])),
    "degrees-for-radians": lambda given: textbook(given, theta=given["theta"]),
    **slips_in_writing(textbook, ("v_BC_y", "v_rel_x", "a_BC_y", "a_cor_y", "a_rel_y")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_rel_x", "a_cor_y", coriolis_by_sliding),
    Edge("v_rel_x", "a_rel_y", relative_by_sliding),
    Edge("a_cor_y", "a_rel_y", relative_by_coriolis),
    Edge("a_BC_y", "a_rel_y", relative_by_follower),
)
