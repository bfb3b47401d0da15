"""The jaw of a stone crusher, driven by a crank through three bars that meet in the pin G.

Full precision works with complex numbers: x + iy, turning by 90 degrees counter-clockwise is a
multiplication by i.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from math import atan2, copysign, degrees, pi, radians, sin

from tests.by_hand.pad import SIZES, Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def equations(given: Givens, pad: Pad) -> Answers:
    """E is a point of the rod GE, G its base point; components on x and y everywhere."""
    e_x, e_y = pad(given["OE"] * pad.cos(given["psi"])), pad(given["OE"] * pad.sin(given["psi"]))
    lean = pad(given["GD"] * pad.sin(given["delta"]))
    height = pad(given["GD"] * pad.cos(given["delta"]))
    x, y = pad(pad(given["d"] + lean) + e_x), e_y  # from G to E; G = D + (-lean, height)
    v_x, v_y = -pad(given["omega"] * e_y), pad(given["omega"] * e_x)
    # v_E = v_G + v_EG: v_x = -u height - w y, v_y = -u lean + w x
    bottom = pad(pad(height * x) + pad(lean * y))
    u = -pad(pad(pad(v_x * x) + pad(v_y * y)) / bottom)
    w = pad(pad(pad(v_y * height) - pad(v_x * lean)) / bottom)
    square, alpha = pad(given["omega"] ** 2), given["alpha"]
    a_x = -pad(pad(square * e_x) + pad(alpha * e_y))
    a_y = pad(pad(alpha * e_x) - pad(square * e_y))
    of_rod, of_strut = pad(w**2), pad(u**2)
    k_x = pad(pad(a_x + pad(of_rod * x)) - pad(of_strut * lean))
    k_y = pad(pad(a_y + pad(of_rod * y)) + pad(of_strut * height))
    change = -pad(pad(pad(k_x * x) + pad(k_y * y)) / bottom)
    g_x, g_y = -pad(u * height), -pad(u * lean)
    bar = given["delta"] + given["beta"] + 90
    b_x, b_y = pad.cos(bar), pad.sin(bar)
    jaw = bar + given["gamma"] - 180  # of BA; B moves across it
    across_x, across_y = pad(given["AB"] * pad.sin(jaw)), -pad(given["AB"] * pad.cos(jaw))
    along = pad(pad(g_x * b_x) + pad(g_y * b_y))
    rate = pad(along / pad(pad(across_x * b_x) + pad(across_y * b_y)))
    return {
        "v_G": pad.root(pad(pad(g_x**2) + pad(g_y**2))),
        "omega_GE": w,
        "omega_AB": rate,
        "alpha_GD": change,
    }


def poles(given: Givens, pad: Pad) -> Answers:
    """The poles C1 of GE and C2 of BG by the law of sines in the triangles O G C1 and G B C2."""
    o_g = pad(given["d"] + pad(given["GD"] * pad.sin(given["delta"])))
    at_c1 = pad.sin(given["delta"] - 90 - given["psi"])
    g_c1 = pad(pad(o_g * -pad.sin(given["psi"])) / at_c1)
    e_c1 = pad(pad(pad(o_g * pad.cos(given["delta"])) / at_c1) - given["OE"])
    w = -pad(pad(given["omega"] * given["OE"]) / e_c1)
    v_g = -pad(w * g_c1)  # to the right
    at_c2 = pad.sin(given["beta"] + given["gamma"])
    g_c2 = pad(pad(given["BG"] * pad.sin(given["gamma"])) / at_c2)
    b_c2 = pad(pad(given["BG"] * pad.sin(given["beta"])) / at_c2)
    v_b = pad(pad(v_g / g_c2) * b_c2)
    return {
        "v_G": abs(v_g),
        "omega_GE": w,
        "omega_AB": pad(v_b / given["AB"]),
        "alpha_GD": _strut(given, pad, v_g, w),
    }


def projection(given: Givens, pad: Pad) -> Answers:
    """Velocities projected along and across GE, along BG; the rod's angle in degrees."""
    rod, length = _rod(given, pad)
    lag, slope = given["psi"] - rod, given["delta"] - rod
    v_e = pad(given["omega"] * given["OE"])
    v_g = pad(-pad(v_e * pad.sin(pad.angle(lag))) / pad.cos(pad.angle(slope)))
    across = pad(pad(v_e * pad.cos(pad.angle(lag))) - pad(v_g * pad.sin(pad.angle(slope))))
    w = pad(across / length)
    v_b = pad(pad(v_g * pad.sin(given["beta"])) / pad.sin(given["gamma"]))
    return {
        "v_G": abs(v_g),
        "omega_GE": w,
        "omega_AB": pad(v_b / given["AB"]),
        "alpha_GD": _strut(given, pad, v_g, w),
    }


def _rod(given: Givens, pad: Pad) -> tuple[float, float]:
    """The direction of GE in degrees, and its length."""
    x = pad(given["d"] + pad(given["GD"] * pad.sin(given["delta"])))
    x = pad(x + pad(given["OE"] * pad.cos(given["psi"])))
    y = pad(given["OE"] * pad.sin(given["psi"]))
    return pad.angle(degrees(atan2(y, x))), pad.root(pad(pad(x**2) + pad(y**2)))


def _strut(given: Givens, pad: Pad, v_g: float, w: float) -> float:
    """The angular acceleration of GD: accelerations projected along the rod GE."""
    rod, length = _rod(given, pad)
    lag, slope = pad.angle(given["psi"] - rod), pad.angle(given["delta"] - rod)
    e_n = pad(given["OE"] * pad(given["omega"] ** 2))
    e_t = pad(given["OE"] * given["alpha"])
    g_n = pad(pad(v_g**2) / given["GD"])
    crank = pad(pad(e_n * pad.cos(lag)) + pad(e_t * pad.sin(lag)))
    rest = pad(pad(crank + pad(g_n * pad.sin(slope))) - pad(pad(w**2) * length))
    return pad(pad(rest / pad.cos(slope)) / given["GD"])


def _arms(given: Givens) -> tuple[complex, complex, complex]:
    """OE, GE and DG."""
    crank = given["OE"] * exp(1j * radians(given["psi"]))
    strut = 1j * given["GD"] * exp(1j * radians(given["delta"]))
    return crank, crank + given["d"] - strut.real, strut


def _rates(given: Givens) -> tuple[float, float]:
    """Of the rod GE and of the strut GD, by crank omega = strut u + rod w."""
    crank, rod, strut = _arms(given)
    w = given["omega"] * (crank * strut.conjugate()).imag / (rod * strut.conjugate()).imag
    u = given["omega"] * (crank * rod.conjugate()).imag / (strut * rod.conjugate()).imag
    return w, u


def strut_change(
    given: Givens, w: float, u: float, *, path: float = 1, about: float = 1, tangential: float = 1
) -> float:
    """The angular acceleration of GD from the rates of GE and GD; the keywords are the shares that
    are kept of the normal accelerations on circles and about G, and of the tangential one of E.
    """
    crank, rod, strut = _arms(given)
    a_e = (tangential * 1j * given["alpha"] - path * given["omega"] ** 2) * crank
    known = a_e + about * w**2 * rod + path * u**2 * strut
    return -(known * rod.conjugate()).real / (strut * rod.conjugate()).imag


def jaw(given: Givens, v_g: float) -> float:
    """The angular velocity of the jaw, from the speed of G with its sense, by BG."""
    ratio = sin(radians(given["beta"])) / sin(radians(given["gamma"]))
    return v_g * ratio / given["AB"]


def textbook(given: Givens, **shares: float) -> Answers:
    """All figures; shares of accelerations may be lost."""
    w, u = _rates(given)
    return {
        "v_G": abs(u) * given["GD"],
        "omega_GE": w,
        "omega_AB": jaw(given, -u * given["GD"]),
        "alpha_GD": strut_change(given, w, u, **shares),
    }


def strut_only(**shares: float) -> Mistake:
    return lambda given: {"alpha_GD": textbook(given, **shares)["alpha_GD"]}


ANGLES = ("delta", "beta", "gamma", "psi")


def complements(given: Givens) -> Answers:
    """Sines for cosines; of omega_AB nothing, where gamma is 90 degrees."""
    read = {angle: 90 - given[angle] for angle in ANGLES}
    wrong = textbook({**given, **read, "gamma": 90})
    return {ask: wrong[ask] for ask in ("v_G", "omega_GE", "alpha_GD")}


def numbers_of_radians(given: Givens) -> Answers:
    return textbook({**given, **{angle: given[angle] * 180 / pi for angle in ANGLES}})


def of_crank(given: Givens) -> Answers:
    """The crank's angular velocity used for GE."""
    return {"omega_GE": given["omega"]}


def translating(given: Givens) -> Answers:
    """GE moved without turning."""
    return {"omega_GE": 0, "v_G": given["OE"] * given["omega"]}


def added(given: Givens) -> Answers:
    """The speeds of E and of G about E added."""
    return {"v_G": given["OE"] * given["omega"] + abs(_rates(given)[0] * _arms(given)[1])}


def _sense(given: Givens) -> float:
    """1 where G moves to the right."""
    return copysign(1, -_rates(given)[1])


def jaw_by_speed(given: Givens, v_g: float) -> float:
    return jaw(given, _sense(given) * v_g)


def _lever(given: Givens) -> float:
    """GC1, negative where the pole is above G."""
    w, u = _rates(given)
    return u * given["GD"] / w


def rod_by_speed(given: Givens, v_g: float) -> float:
    return -_sense(given) * v_g / _lever(given)


def speed_by_rod(given: Givens, w: float) -> float:
    return abs(w * _lever(given))


def jaw_by_rod(given: Givens, w: float) -> float:
    return jaw(given, -w * _lever(given))


def change_by_rod(given: Givens, w: float) -> float:
    return strut_change(given, w, _rates(given)[1])


def change_by_pole(given: Givens, w: float) -> float:
    """The strut's rate found by the pole from the rod's."""
    return strut_change(given, w, w * _lever(given) / given["GD"])


def change_by_speed(given: Givens, v_g: float) -> float:
    return strut_change(given, _rates(given)[0], v_g / given["GD"])


METHODS: Mapping[str, Method] = {
    "equations": equations,
    "poles": poles,
    "projection": projection,
}
MISTAKES: Mapping[str, Mistake] = {
    "path-normal-dropped": strut_only(path=0),
    "relative-normal-dropped": strut_only(about=0),
    "relative-normal-outwards": strut_only(about=-1),
    "tangential-dropped": strut_only(tangential=0),
    "sine-for-cosine": complements,
    "degrees-for-radians": numbers_of_radians,
    "wrong-pole": of_crank,
    "translation-assumed": translating,
    "added-as-scalars": added,
    **slips_in_writing(textbook, ("omega_GE", "omega_AB", "alpha_GD")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("v_G", "omega_GE", rod_by_speed, SIZES),
    Edge("v_G", "omega_AB", jaw_by_speed, SIZES),
    Edge("v_G", "alpha_GD", change_by_speed, SIZES),
    Edge("omega_GE", "v_G", speed_by_rod),
    Edge("omega_GE", "omega_AB", jaw_by_rod),
    Edge("omega_GE", "alpha_GD", change_by_rod),
    Edge("omega_GE", "alpha_GD", change_by_pole),
)
