"""A four-bar linkage ABCD and the velocity pole S of its coupler BC.

S lies on the lines AB and DC; distances on them count from A and from D.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import acos, atan2, cos, degrees, hypot, pi, radians, sin, sqrt

from tests.by_hand.pad import Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing

Point = tuple[float, float]


def law_of_sines(given: Givens, pad: Pad) -> Answers:
    """The angles by triangles ABD and BCD, the pole by the triangle ADS."""
    b, d, rocker = given["b"], given["d"], given["l_CD"]
    sine, cosine = pad.sin(given["theta"]), pad.cos(given["theta"])
    square = pad(pad(pad(b**2) + pad(d**2)) - pad(pad(2 * b * d) * cosine))
    diagonal = pad.root(square)
    first = pad.angle(degrees(atan2(pad(b * sine), pad(d - pad(b * cosine)))))
    difference = pad(pad(square + pad(rocker**2)) - pad(given["l_BC"] ** 2))
    second = pad.angle(degrees(acos(pad(difference / pad(pad(2 * diagonal) * rocker)))))
    at_d = pad.angle(first + second)
    at_s = pad.angle(180 - given["theta"] - at_d)
    a_s = pad(pad(d * pad.sin(at_d)) / pad.sin(at_s))
    d_s = pad(pad(d * sine) / pad.sin(at_s))
    w = pad(pad(given["omega"] * b) / pad(b - a_s))
    v_c = pad(w * pad(rocker - d_s))
    return {
        "x_S": pad(a_s * cosine),
        "y_S": pad(a_s * sine),
        "omega_BC": w,
        "omega_CD": pad(v_c / rocker),
        "v_C": abs(v_c),
    }


def intersection(given: Givens, pad: Pad) -> Answers:
    """C in coordinates from the diagonal BD; the pole where the lines y = m x meet."""
    b, d, rocker = given["b"], given["d"], given["l_CD"]
    b_x, b_y = pad(b * pad.cos(given["theta"])), pad(b * pad.sin(given["theta"]))
    gap = pad(d - b_x)
    square = pad(pad(gap**2) + pad(b_y**2))
    along = pad(pad(pad(square + pad(given["l_BC"] ** 2)) - pad(rocker**2)) / pad(2 * square))
    across = pad.root(pad(pad(pad(given["l_BC"] ** 2) / square) - pad(along**2)))
    c_x = pad(pad(b_x + pad(along * gap)) + pad(across * b_y))
    c_y = pad(pad(b_y - pad(along * b_y)) + pad(across * gap))
    # S = s B = D + t (C - D): s and t by Cramer's rule
    run = pad(c_x - d)
    bottom = pad(pad(b_x * c_y) - pad(b_y * run))
    s, t = pad(pad(d * c_y) / bottom), pad(pad(d * b_y) / bottom)
    w = pad(given["omega"] / pad(1 - s))
    rate = pad(w * pad(1 - t))
    return {
        "x_S": pad(s * b_x),
        "y_S": pad(s * b_y),
        "omega_BC": w,
        "omega_CD": rate,
        "v_C": abs(pad(rate * rocker)),
    }


def base_point(given: Givens, pad: Pad) -> Answers:
    """v_C = v_B + v_CB projected across the rocker and along the coupler; then SB = v_B / w."""
    b, rocker = given["b"], given["l_CD"]
    coupler, of_rocker = _directions(given)
    beta, gamma = pad.angle(coupler), pad.angle(180 - of_rocker)  # of BC; of DC from DA
    v_b = pad(given["omega"] * b)
    between = pad.sin(pad.angle(gamma + beta))
    w = -pad(pad(v_b * pad.sin(pad.angle(given["theta"] + gamma))) / pad(given["l_BC"] * between))
    v_c = pad(pad(v_b * pad.sin(pad.angle(given["theta"] - beta))) / between)
    a_s = pad(b - pad(v_b / w))
    return {
        "x_S": pad(a_s * pad.cos(given["theta"])),
        "y_S": pad(a_s * pad.sin(given["theta"])),
        "omega_BC": w,
        "omega_CD": pad(v_c / rocker),
        "v_C": abs(v_c),
    }


def _points(given: Givens, theta: float | None = None, side: int = 1) -> tuple[Point, Point]:
    """B and C; `side` is 1 where C is above the line BD."""
    theta = radians(given["theta"]) if theta is None else theta
    x, y = given["b"] * cos(theta), given["b"] * sin(theta)
    gap = given["d"] - x
    square = gap**2 + y**2
    along = (square + given["l_BC"] ** 2 - given["l_CD"] ** 2) / (2 * square)
    across = side * sqrt(given["l_BC"] ** 2 / square - along**2)
    return (x, y), (x + along * gap + across * y, y - along * y + across * gap)


def _directions(given: Givens) -> tuple[float, float]:
    """The directions of BC and DC in degrees."""
    (b_x, b_y), (c_x, c_y) = _points(given)
    return degrees(atan2(c_y - b_y, c_x - b_x)), degrees(atan2(c_y, c_x - given["d"]))


def textbook(given: Givens, theta: float | None = None, side: int = 1) -> Answers:
    """All figures; the crank's angle in radians or the branch may be mistaken."""
    (b_x, b_y), (c_x, c_y) = _points(given, theta, side)
    run = c_x - given["d"]
    bottom = b_x * c_y - b_y * run
    s, t = given["d"] * c_y / bottom, given["d"] * b_y / bottom
    w = given["omega"] / (1 - s)
    return {
        "x_S": s * b_x,
        "y_S": s * b_y,
        "omega_BC": w,
        "omega_CD": w * (1 - t),
        "v_C": abs(w * (1 - t)) * given["l_CD"],
    }


def about_a(given: Givens) -> Answers:
    """The coupler taken to turn about A with the crank."""
    _, c = _points(given)
    return {"y_S": 0, "omega_BC": given["omega"], "v_C": given["omega"] * hypot(*c)}


def translating(given: Givens) -> Answers:
    """The coupler moved without turning."""
    v_b = given["omega"] * given["b"]
    return {"omega_BC": 0, "v_C": v_b}


def on_velocities(given: Givens) -> Answers:
    """The pole sought on the lines along the velocities of B and C."""
    (b_x, b_y), (c_x, c_y) = _points(given)
    run = c_x - given["d"]
    # (S - B) . B = 0 and (S - C) . (C - D) = 0
    first, second = b_x**2 + b_y**2, c_x * run + c_y * c_y
    bottom = b_x * c_y - b_y * run
    return {
        "x_S": (first * c_y - b_y * second) / bottom,
        "y_S": (b_x * second - first * run) / bottom,
    }


def added(given: Givens) -> Answers:
    """The speeds of B and of C about B added."""
    about = abs(textbook(given)["omega_BC"]) * given["l_BC"]
    return {"v_C": given["omega"] * given["b"] + about}


def _ratios(given: Givens) -> tuple[float, float]:
    """AS / AB and DS / DC."""
    right = textbook(given)
    s = 1 - given["omega"] / right["omega_BC"]
    return s, 1 - right["omega_CD"] / right["omega_BC"]


def rate_by_y(given: Givens, y: float) -> float:
    """By the distance SB on the line AB."""
    return given["omega"] / (1 - y / (given["b"] * sin(radians(given["theta"]))))


def x_by_y(given: Givens, y: float) -> float:
    return y * cos(radians(given["theta"])) / sin(radians(given["theta"]))


def y_by_rate(given: Givens, w: float) -> float:
    return given["b"] * sin(radians(given["theta"])) * (1 - given["omega"] / w)


def rocker_by_rate(given: Givens, w: float) -> float:
    return w * (1 - _ratios(given)[1])


def speed_by_rate(given: Givens, w: float) -> float:
    return abs(rocker_by_rate(given, w)) * given["l_CD"]


def speed_by_rocker(given: Givens, w: float) -> float:
    return abs(w) * given["l_CD"]


def rate_by_rocker(given: Givens, w: float) -> float:
    return w / (1 - _ratios(given)[1])


METHODS: Mapping[str, Method] = {
    "law of sines": law_of_sines,
    "intersection": intersection,
    "base point": base_point,
}
MISTAKES: Mapping[str, Mistake] = {
    "wrong-pole": about_a,
    "translation-assumed": translating,
    "pole-on-velocities": on_velocities,
    "added-as-scalars": added,
    "other-branch": lambda given: textbook(given, side=-1),
    "degrees-for-radians": lambda given: textbook(given, theta=given["theta"]),
    "supplementary-angle": lambda given: textbook(given, theta=pi - radians(given["theta"])),
    **slips_in_writing(textbook, ("x_S", "y_S", "omega_BC", "omega_CD")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("y_S", "x_S", x_by_y),
    Edge("y_S", "omega_BC", rate_by_y),
    Edge("omega_BC", "y_S", y_by_rate),
    Edge("omega_BC", "omega_CD", rocker_by_rate),
    Edge("omega_BC", "v_C", speed_by_rate),
    Edge("omega_CD", "v_C", speed_by_rocker),
    Edge("omega_CD", "omega_BC", rate_by_rocker),
)
