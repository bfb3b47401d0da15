"""A planet gear that an arm carries round the outside of a fixed gear: accelerations.

Components are counted along the arm, outwards, and across it, counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, degrees, hypot

from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def find_arm(given: Givens) -> float:
    """The length of the arm, from centre to centre."""
    return given["R"] + given["r"]


def centre_as_base(given: Givens, pad: Pad) -> Answers:
    """The centre O is the base point; components along and across the arm."""
    radius, arm = given["r"], find_arm(given)
    w, e = pad(pad(arm * given["omega1"]) / radius), pad(pad(arm * given["alpha1"]) / radius)
    o_n, o_t = pad(arm * pad(given["omega1"] ** 2)), pad(arm * given["alpha1"])
    n, t = pad(radius * pad(w**2)), pad(radius * e)
    a_a = pad.root(pad(pad(pad(o_n + n) ** 2) + pad(pad(o_t + t) ** 2)))
    outwards, across = pad(o_n + t), pad(n - o_t)  # B's, both reversed
    a_b = pad.root(pad(pad(outwards**2) + pad(across**2)))
    theta = pad(degrees(atan2(outwards, across)))
    return {"omega": w, "alpha": e, "a_A": a_a, "a_B": a_b, "theta": theta}


def contact_as_base(given: Givens, pad: Pad) -> Answers:
    """The pole C gives the rates; it is the base point, whose acceleration points to O."""
    radius, arm = given["r"], find_arm(given)
    v_o = pad(arm * given["omega1"])
    w = pad(v_o / radius)
    e = pad(pad(arm * given["alpha1"]) / radius)
    n, t = pad(radius * pad(w**2)), pad(radius * e)
    a_c = pad(n - pad(pad(v_o**2) / arm))
    a_a = pad.root(pad(pad(pad(2 * n) - a_c) ** 2 + pad(2 * t) ** 2))
    inwards, backwards = pad(pad(n - a_c) + t), pad(n - t)
    a_b = pad.root(pad(pad(inwards**2) + pad(backwards**2)))
    theta = pad(degrees(atan2(pad(inwards / a_b), pad(backwards / a_b))))
    return {"omega": w, "alpha": e, "a_A": a_a, "a_B": a_b, "theta": theta}


def coordinates(given: Givens, pad: Pad) -> Answers:
    """Components on x and y, every term apart; theta by the scalar product of a_B and BO."""
    radius, arm = given["r"], find_arm(given)
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    relative = pad(pad(pad(arm - radius) / radius) * given["omega1"])  # Willis
    w = pad(given["omega1"] + relative)
    e = pad(pad(arm / radius) * given["alpha1"])
    o_n, o_t = pad(arm * pad(given["omega1"] ** 2)), pad(arm * given["alpha1"])
    n, t = pad(radius * pad(w**2)), pad(radius * e)
    o_x = pad(-pad(o_n * cosine) - pad(o_t * sine))
    o_y = pad(pad(o_t * cosine) - pad(o_n * sine))
    a_x = pad(pad(o_x - pad(n * cosine)) - pad(t * sine))
    a_y = pad(pad(o_y - pad(n * sine)) + pad(t * cosine))
    b_x = pad(pad(o_x + pad(n * sine)) - pad(t * cosine))
    b_y = pad(pad(o_y - pad(n * cosine)) - pad(t * sine))
    a_b = pad.root(pad(pad(b_x**2) + pad(b_y**2)))
    along = pad(pad(b_x * sine) - pad(b_y * cosine))
    across = pad(pad(b_x * cosine) + pad(b_y * sine))
    return {
        "omega": w,
        "alpha": e,
        "a_A": pad.root(pad(pad(a_x**2) + pad(a_y**2))),
        "a_B": a_b,
        "theta": pad(degrees(atan2(abs(across), along))),
    }


def accelerations(given: Givens, w: float, e: float, *, path: float = 1, rim: float = 1) -> Answers:
    """What follows from the planet's rates; `path` and `rim` are the shares of the normal
    accelerations of O and of the rim about O that are kept.
    """
    o_n, o_t = path * find_arm(given) * given["omega1"] ** 2, find_arm(given) * given["alpha1"]
    n, t = rim * given["r"] * w**2, given["r"] * e
    return {
        "a_A": hypot(o_n + n, o_t + t),
        "a_B": hypot(o_n + t, n - o_t),
        "theta": degrees(atan2(abs(o_n + t), n - o_t)),
    }


def rates(given: Givens) -> tuple[float, float]:
    """The planet's angular velocity and acceleration."""
    return find_arm(given) * given["omega1"] / given["r"], find_arm(given) * given[
        "alpha1"
    ] / given["r"]


def textbook(given: Givens, *, ratio: float | None = None, **shares: float) -> Answers:
    """All figures, with another ratio of the planet's rates to the arm's."""
    ratio = find_arm(given) / given["r"] if ratio is None else ratio
    w, e = ratio * given["omega1"], ratio * given["alpha1"]
    return {"omega": w, "alpha": e, **accelerations(given, w, e, **shares)}


def relative_to_arm(given: Givens) -> Answers:
    """The planet's rates relative to the arm."""
    return textbook(given, ratio=(find_arm(given) - given["r"]) / given["r"])


def meshing_inside(given: Givens) -> Answers:
    """The sense of the rotation relative to the arm reversed."""
    return textbook(given, ratio=1 - (find_arm(given) - given["r"]) / given["r"])


def no_tangential(given: Givens) -> Answers:
    """The tangential accelerations of O and about O forgotten."""
    wrong = textbook({**given, "alpha1": 0})
    return {ask: wrong[ask] for ask in ("a_A", "a_B", "theta")}


def linear(given: Givens) -> Answers:
    """The angular velocities not squared in the normal accelerations."""
    w, e = rates(given)
    o_n, o_t, n, t = (
        find_arm(given) * given["omega1"],
        find_arm(given) * given["alpha1"],
        given["r"] * w,
        given["r"] * e,
    )
    return {"a_A": hypot(o_n + n, o_t + t), "a_B": hypot(o_n + t, n - o_t)}


def added(given: Givens) -> Answers:
    """The magnitudes of the terms added as if they pointed one way."""
    w, e = rates(given)
    o_n, o_t = find_arm(given) * given["omega1"] ** 2, find_arm(given) * given["alpha1"]
    total = o_n + o_t + given["r"] * w**2 + given["r"] * e
    return {"a_A": total, "a_B": total}


def a_a_by_rate(given: Givens, w: float) -> float:
    return accelerations(given, w, rates(given)[1])["a_A"]


def a_b_by_rate(given: Givens, w: float) -> float:
    return accelerations(given, w, rates(given)[1])["a_B"]


def theta_by_rate(given: Givens, w: float) -> float:
    return accelerations(given, w, rates(given)[1])["theta"]


def a_a_by_change(given: Givens, e: float) -> float:
    return accelerations(given, rates(given)[0], e)["a_A"]


def a_b_by_change(given: Givens, e: float) -> float:
    return accelerations(given, rates(given)[0], e)["a_B"]


def theta_by_change(given: Givens, e: float) -> float:
    return accelerations(given, rates(given)[0], e)["theta"]


METHODS: Mapping[str, Method] = {
    "centre as base": centre_as_base,
    "contact as base": contact_as_base,
    "coordinates": coordinates,
}
MISTAKES: Mapping[str, Mistake] = {
    "path-normal-dropped": lambda given: textbook(given, path=0),
    "relative-normal-dropped": lambda given: textbook(given, rim=0),
    "relative-normal-outwards": lambda given: textbook(given, rim=-1),
    "relative-for-absolute": relative_to_arm,
    "meshing-reversed": meshing_inside,
    "tangential-dropped": no_tangential,
    "omega-not-squared": linear,
    "added-as-scalars": added,
    "inverse-ratio": lambda given: textbook(given, ratio=given["r"] / find_arm(given)),
    **slips_in_writing(textbook, ("omega", "alpha")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega", "a_A", a_a_by_rate),
    Edge("omega", "a_B", a_b_by_rate),
    Edge("omega", "theta", theta_by_rate),
    Edge("alpha", "a_A", a_a_by_change),
    Edge("alpha", "a_B", a_b_by_change),
    Edge("alpha", "theta", theta_by_change, SIZES),
)
