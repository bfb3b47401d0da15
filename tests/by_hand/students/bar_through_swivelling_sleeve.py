"""A bar whose end A moves to the left and which slides through a sleeve pivoted at O."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, pi, radians, sin, tan

from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def moving_frame(given: Givens, pad: Pad) -> Answers:
    """The sleeve is the moving frame of A: v_a = v_e + v_r, a_a = a_e^t + a_e^n + a_r + a_Cor."""
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    distance = pad(given["l"] / sine)
    transport, relative = pad(given["v"] * sine), pad(given["v"] * cosine)
    w = pad(transport / distance)
    coriolis = pad(pad(2 * w) * relative)
    e = pad(pad(pad(given["a"] * sine) + coriolis) / distance)
    return {"omega_AB": w, "alpha_AB": e, "a_cor": abs(coriolis), "v_O": relative}


def coordinates(given: Givens, pad: Pad) -> Answers:
    """The angle of the bar by x = l cot(phi), differentiated twice; OA = l / sin(phi)."""
    sine, cosine = pad.sin(given["phi"]), pad.cos(given["phi"])
    square = pad(sine**2)
    w = pad(pad(given["v"] * square) / given["l"])
    doubled = pad(pad(pad(2 * given["v"]) * pad(sine * cosine)) * w)
    e = pad(pad(pad(given["a"] * square) + doubled) / given["l"])
    shortening = pad(pad(pad(given["l"] * cosine) / square) * w)
    coriolis = pad(pad(2 * w) * abs(shortening))
    return {"omega_AB": w, "alpha_AB": e, "a_cor": coriolis, "v_O": shortening}


def pole(given: Givens, pad: Pad) -> Answers:
    """The pole P of the bar, above or below A, on the line across the bar through O; then the
    acceleration across the bar of its point at O, about the base point A.
    """
    distance = pad(given["l"] / pad.sin(given["phi"]))
    p_a = pad(distance / pad.sin(given["phi"]))
    p_o = pad(distance / pad(tan(radians(given["phi"]))))
    w = pad(given["v"] / p_a)
    sliding = pad(w * p_o)
    coriolis = pad(pad(2 * w) * sliding)
    e = pad(pad(coriolis + pad(given["a"] * pad.sin(given["phi"]))) / distance)
    return {"omega_AB": w, "alpha_AB": e, "a_cor": abs(coriolis), "v_O": sliding}


def textbook(given: Givens, *, phi: float | None = None, coriolis: float = 1) -> Answers:
    """All figures, with another angle (in radians) or part of the Coriolis acceleration."""
    phi = radians(given["phi"]) if phi is None else phi
    w = given["v"] * sin(phi) ** 2 / given["l"]
    a_cor = coriolis * 2 * w * given["v"] * cos(phi)
    return {
        "omega_AB": w,
        "alpha_AB": (given["a"] * sin(phi) + a_cor) * sin(phi) / given["l"],
        "a_cor": abs(a_cor),
        "v_O": given["v"] * cos(phi),
    }


def dropped(given: Givens) -> Answers:
    return {"alpha_AB": textbook(given, coriolis=0)["alpha_AB"]}


def reversed_sense(given: Givens) -> Answers:
    return {"alpha_AB": textbook(given, coriolis=-1)["alpha_AB"]}


def halved(given: Givens) -> Answers:
    wrong = textbook(given, coriolis=0.5)
    return {ask: wrong[ask] for ask in ("alpha_AB", "a_cor")}


def no_relative_velocity(given: Givens) -> Answers:
    """The whole velocity of A taken for its transport velocity."""
    return {"omega_AB": given["v"] * sin(radians(given["phi"])) / given["l"]}


def coriolis_by_rate(given: Givens, w: float) -> float:
    return abs(2 * w * given["v"] * cos(radians(given["phi"])))


def change_by_rate(given: Givens, w: float) -> float:
    return change_by_coriolis(given, 2 * w * given["v"] * cos(radians(given["phi"])))


def change_by_coriolis(given: Givens, a_cor: float) -> float:
    """The sense of the Coriolis acceleration is right, its magnitude the student's own."""
    sine = sin(radians(given["phi"]))
    return (given["a"] * sine + a_cor) * sine / given["l"]


def change_by_magnitude(given: Givens, a_cor: float) -> float:
    leaning = 1 if given["phi"] < 90 else -1
    return change_by_coriolis(given, leaning * a_cor)


def coriolis_by_sliding(given: Givens, sliding: float) -> float:
    return abs(2 * textbook(given)["omega_AB"] * sliding)


def change_by_sliding(given: Givens, sliding: float) -> float:
    return change_by_coriolis(given, 2 * textbook(given)["omega_AB"] * sliding)


def sliding_about_pole(given: Givens, w: float) -> float:
    phi = radians(given["phi"])
    return w * given["l"] / sin(phi) / tan(phi)


METHODS: Mapping[str, Method] = {
    "moving frame": moving_frame,
    "coordinates": coordinates,
    "pole": pole,
}
MISTAKES: Mapping[str, Mistake] = {
    "coriolis-dropped": dropped,
    "coriolis-reversed": reversed_sense,
    "coriolis-halved": halved,
    "transport-for-absolute": no_relative_velocity,
    "sine-for-cosine": lambda given: textbook(given, phi=pi / 2 - radians(given["phi"])),
    "degrees-for-radians": lambda given: textbook(given, phi=given["phi"]),
    "supplementary-angle": lambda given: textbook(given, phi=pi - radians(given["phi"])),
    **slips_in_writing(textbook, ("omega_AB", "alpha_AB", "v_O")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_AB", "a_cor", coriolis_by_rate),
    Edge("omega_AB", "alpha_AB", change_by_rate),
    Edge("omega_AB", "v_O", sliding_about_pole),
    Edge("a_cor", "alpha_AB", change_by_magnitude, SIZES),
    Edge("v_O", "a_cor", coriolis_by_sliding),
    Edge("v_O", "alpha_AB", change_by_sliding),
)
