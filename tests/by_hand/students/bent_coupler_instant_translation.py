"""A crank OA drives a rocker O1B through a bent bar ABC whose end C is free.

Full precision works with complex numbers: x + iy, a direction is exp(i angle), turning by 90
degrees counter-clockwise is a multiplication by i.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from math import pi, radians
from typing import NamedTuple

from tests.by_hand.pad import Answers, Edge, Givens, Method, Mistake, Pad
from tests.by_hand.writing import slips_in_writing


def equations(given: Givens, pad: Pad) -> Answers:
    """A is the base point; the equations on x and y for B are solved by determinants."""
    v_a = pad(given["OA"] * given["omega"])
    s_t, c_t = pad.sin(given["theta"]), pad.cos(given["theta"])
    b_x, b_y = _arm(given["AB"], given["delta"], pad)  # from A
    end_x, end_y = _arm(given["BC"], given["eta"], pad)  # from B
    c_x, c_y = pad(b_x + end_x), pad(b_y + end_y)
    r_x, r_y = _arm(given["O1B"], given["psi"], pad)  # from O1
    a_x, a_y = -pad(v_a * s_t), pad(v_a * c_t)
    # a_x - w b_y = -w1 r_y and a_y + w b_x = w1 r_x
    bottom = pad(pad(b_y * r_x) - pad(b_x * r_y))
    w = pad(pad(pad(a_x * r_x) + pad(a_y * r_y)) / bottom)
    w_1 = pad(pad(pad(a_x * b_x) + pad(a_y * b_y)) / bottom)
    v_x, v_y = pad(a_x - pad(w * c_y)), pad(a_y + pad(w * c_x))
    a_n, a_t = pad(given["OA"] * pad(given["omega"] ** 2)), pad(given["OA"] * given["alpha"])
    p_x, p_y = -pad(pad(a_n * c_t) + pad(a_t * s_t)), pad(pad(a_t * c_t) - pad(a_n * s_t))
    square, square_1 = pad(w**2), pad(w_1**2)
    # k_x - e b_y = -e1 r_y and k_y + e b_x = e1 r_x
    k_x = pad(pad(p_x - pad(square * b_x)) + pad(square_1 * r_x))
    k_y = pad(pad(p_y - pad(square * b_y)) + pad(square_1 * r_y))
    e = pad(pad(pad(k_x * r_x) + pad(k_y * r_y)) / bottom)
    return {
        "omega_ABC": w,
        "v_C": pad.root(pad(pad(v_x**2) + pad(v_y**2))),
        "alpha_ABC": e,
        "a_C_x": pad(pad(p_x - pad(e * c_y)) - pad(square * c_x)),
        "a_C_y": pad(pad(p_y + pad(e * c_x)) - pad(square * c_y)),
    }


def _arm(length: float, direction: float, pad: Pad) -> tuple[float, float]:
    return pad(length * pad.cos(direction)), pad(length * pad.sin(direction))


def projection(given: Givens, pad: Pad) -> Answers:
    """Along the bar AB, then along the rocker; C about the base point B by its components."""
    to_crank = given["theta"] - given["delta"]
    to_rocker = given["psi"] - given["delta"]
    lag = given["theta"] - given["psi"]
    v_a = pad(given["OA"] * given["omega"])
    v_b = pad(pad(v_a * pad.sin(to_crank)) / pad.sin(to_rocker))
    w = pad(pad(v_a * pad.sin(lag)) / pad(given["AB"] * pad.sin(to_rocker)))
    a_n, a_t = pad(given["OA"] * pad(given["omega"] ** 2)), pad(given["OA"] * given["alpha"])
    b_n, about_n = pad(pad(v_b**2) / given["O1B"]), pad(given["AB"] * pad(w**2))
    # along the rocker, outwards: -a_n cos(lag) - a_t sin(lag) - n cos + t sin = -b_n
    crank = pad(pad(a_n * pad.cos(lag)) + pad(a_t * pad.sin(lag)))
    t = pad(pad(pad(crank + pad(about_n * pad.cos(to_rocker))) - b_n) / pad.sin(to_rocker))
    e = pad(t / given["AB"])
    # along the bar AB: a_B's tangential component
    bar = pad(pad(a_n * pad.cos(to_crank)) + pad(pad(a_t * pad.sin(to_crank)) + about_n))
    b_t = pad(pad(bar - pad(b_n * pad.cos(to_rocker))) / pad.sin(to_rocker))
    s, c = pad.sin(given["psi"]), pad.cos(given["psi"])
    x, y = _arm(given["BC"], given["eta"], pad)
    v_x, v_y = pad(pad(-v_b * s) - pad(w * y)), pad(pad(v_b * c) + pad(w * x))
    b_x, b_y = pad(pad(-b_t * s) - pad(b_n * c)), pad(pad(b_t * c) - pad(b_n * s))
    return {
        "omega_ABC": w,
        "v_C": pad.root(pad(pad(v_x**2) + pad(v_y**2))),
        "alpha_ABC": e,
        "a_C_x": pad(pad(b_x - pad(e * y)) - pad(pad(w**2) * x)),
        "a_C_y": pad(pad(b_y + pad(e * x)) - pad(pad(w**2) * y)),
    }


class Slip(NamedTuple):
    """The shares that are kept of the normal accelerations of A and B on their circles, of those
    about the base point, and of the tangential one of A.
    """

    path: float = 1
    about: float = 1
    tangential: float = 1


SOUND = Slip()


def _complex(given: Givens, angle: str) -> complex:
    return exp(1j * radians(given[angle]))


def _arms(given: Givens) -> tuple[complex, complex, complex, complex]:
    """OA, AB, O1B and AC."""
    bar = given["AB"] * _complex(given, "delta")
    end = bar + given["BC"] * _complex(given, "eta")
    rocker = given["O1B"] * _complex(given, "psi")
    return given["OA"] * _complex(given, "theta"), bar, rocker, end


def _rates(given: Givens) -> tuple[float, float]:
    """Of the bar and of the rocker, by OA + AB = O1B turning: r omega + b w = p w1."""
    crank, bar, rocker, _ = _arms(given)
    w = -given["omega"] * (crank * rocker.conjugate()).imag / (bar * rocker.conjugate()).imag
    w_1 = given["omega"] * (crank * bar.conjugate()).imag / (rocker * bar.conjugate()).imag
    return w, w_1


def change(given: Givens, w: float, slip: Slip = SOUND) -> float:
    """The bar's angular acceleration from its angular velocity, along the rocker."""
    _, bar, rocker, _ = _arms(given)
    _, w_1 = _rates(given)
    known = _a(given, slip) - slip.about * w**2 * bar + slip.path * w_1**2 * rocker
    return (known * rocker.conjugate()).real / (bar * rocker.conjugate()).imag


def _a(given: Givens, slip: Slip = SOUND) -> complex:
    """The acceleration of A."""
    tangential = slip.tangential * 1j * given["alpha"]
    return (tangential - slip.path * given["omega"] ** 2) * _arms(given)[0]


def end(given: Givens, w: float, e: float, slip: Slip = SOUND) -> complex:
    """The acceleration of C from the bar's rates."""
    return _a(given, slip) + (1j * e - slip.about * w**2) * _arms(given)[3]


def textbook(given: Givens, slip: Slip = SOUND, w: float | None = None) -> Answers:
    """All figures; what is lost of accelerations and the bar's rate may be mistaken."""
    w = _rates(given)[0] if w is None else w
    e = change(given, w, slip)
    a_c = end(given, w, e, slip)
    return {
        "omega_ABC": w,
        "v_C": speed_about_a(given, w),
        "alpha_ABC": e,
        "a_C_x": a_c.real,
        "a_C_y": a_c.imag,
    }


def only_changes(slip: Slip) -> Mistake:
    return lambda given: {
        ask: textbook(given, slip)[ask] for ask in ("alpha_ABC", "a_C_x", "a_C_y")
    }


def without_tangential(given: Givens) -> Answers:
    """The tangential acceleration forgotten wherever an angular acceleration is known."""
    a_c = _a(given, Slip(tangential=0)) - _rates(given)[0] ** 2 * _arms(given)[3]
    wrong = textbook(given, Slip(tangential=0))
    return {"alpha_ABC": wrong["alpha_ABC"], "a_C_x": a_c.real, "a_C_y": a_c.imag}


def angles(read: Mistake) -> Mistake:
    """Students who work with other angles than the given ones."""
    return lambda given: textbook({**given, **read(given)})


ANGLES = ("theta", "delta", "eta", "psi")


def complements(given: Givens) -> Answers:
    return {angle: 90 - given[angle] for angle in ANGLES}


def numbers_of_radians(given: Givens) -> Answers:
    return {angle: given[angle] * 180 / pi for angle in ANGLES}


def of_crank(given: Givens) -> Answers:
    """The crank's angular velocity used for the bar."""
    return {"omega_ABC": given["omega"], "v_C": speed_about_a(given, given["omega"])}


def translating(given: Givens) -> Answers:
    """The bar moved without turning."""
    return {"omega_ABC": 0, "v_C": given["OA"] * given["omega"]}


def added(given: Givens) -> Answers:
    """The speeds of A and of C about A added."""
    about = abs(_rates(given)[0] * _arms(given)[3])
    return {"v_C": given["OA"] * given["omega"] + about}


def speed_about_a(given: Givens, w: float) -> float:
    crank, _, _, arm = _arms(given)
    return abs(given["omega"] * crank + w * arm)


def speed_about_b(given: Givens, w: float) -> float:
    _, bar, rocker, arm = _arms(given)
    return abs(_rates(given)[1] * rocker + w * (arm - bar))


def speed_about_pole(given: Givens, w: float) -> float:
    """The pole is right, where OA and O1B meet."""
    crank, _, _, arm = _arms(given)
    return abs(w * (arm + given["omega"] / _rates(given)[0] * crank))


def x_by_rate(given: Givens, w: float) -> float:
    return end(given, w, change(given, w)).real


def y_by_rate(given: Givens, w: float) -> float:
    return end(given, w, change(given, w)).imag


def x_by_change(given: Givens, e: float) -> float:
    return end(given, _rates(given)[0], e).real


def y_by_change(given: Givens, e: float) -> float:
    return end(given, _rates(given)[0], e).imag


METHODS: Mapping[str, Method] = {"equations": equations, "projection": projection}
MISTAKES: Mapping[str, Mistake] = {
    "path-normal-dropped": only_changes(Slip(path=0)),
    "relative-normal-dropped": only_changes(Slip(about=0)),
    "relative-normal-outwards": only_changes(Slip(about=-1)),
    "tangential-dropped": without_tangential,
    "sine-for-cosine": angles(complements),
    "degrees-for-radians": angles(numbers_of_radians),
    "wrong-pole": of_crank,
    "translation-assumed": translating,
    "added-as-scalars": added,
    **slips_in_writing(textbook, ("omega_ABC", "alpha_ABC", "a_C_x", "a_C_y")),
}
FOLLOWS: tuple[Edge, ...] = (
    Edge("omega_ABC", "v_C", speed_about_a),
    Edge("omega_ABC", "v_C", speed_about_b),
    Edge("omega_ABC", "v_C", speed_about_pole),
    Edge("omega_ABC", "alpha_ABC", change),
    Edge("omega_ABC", "a_C_x", x_by_rate),
    Edge("omega_ABC", "a_C_y", y_by_rate),
    Edge("alpha_ABC", "a_C_x", x_by_change),
    Edge("alpha_ABC", "a_C_y", y_by_change),
)
