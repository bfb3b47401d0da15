"""How the vectors of an equation are written: symbol, magnitude and direction.

v_a, v_e, v_r and a_C in a composition of motions, v_BA and a_BA^n, a_BA^t about a base point.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from kinegrade.expression import Name
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.relations import Term, omega_of
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, Role, VectorEquation
from kinegrade.worked.known_vectors import is_told_negative, path_of
from kinegrade.worked.numbers import NEGLIGIBLE, absolute_value, angle_text, bearing, length, short
from kinegrade.worked.solution_case import LETTERS, Case

ROLES: Mapping[Role, str] = {
    "transport": r"\mathrm{e}",
    "relative": r"\mathrm{r}",
    "coriolis": r"\mathrm{C}",
}


def letter(equation: VectorEquation) -> str:
    """v or a."""
    return LETTERS[equation.level]


def subscript(equation: VectorEquation, part: Part, case: Case) -> str:
    """The subscript of a part: a, e, r, C in a composition (numbered where there are two), else the
    points.
    """
    plain = case.naming.point(part.point)
    point = primed(plain) if part.coincident else plain
    match part.role:
        case "transport" | "relative" | "coriolis":
            return ROLES[part.role] + number_of(equation, part)
        case "absolute":
            return r"\mathrm{a}" if is_composed(equation, part) else point + axis_of(part)
        case "rotation":
            return point + case.naming.point(part.base)
        case _:
            assert_never(part.role)


def primed(point: str) -> str:
    """The letter of the point that coincides with a point: B', and O'_{1} for O_{1}."""
    head, mark, rest = point.partition("_")
    return f"{head}'{mark}{rest}"


def axis_of(part: Part) -> str:
    """x or y for a component of a free point's motion."""
    return f",{part.term.rate[-1]}" if part.term and part.term.rate.startswith("free ") else ""


def is_composed(equation: VectorEquation, part: Part) -> bool:
    """Whether a part is the absolute motion of the only composition: alone on its side, the other
    one opposite.
    """
    side, other = (
        (equation.left, equation.right)
        if part in equation.left
        else (equation.right, equation.left)
    )
    whole = {(one.role, one.point) for one in side} == {("absolute", part.point)}
    return whole and equation.among == 1 and any(one in other for one in equation.compositions)


def number_of(equation: VectorEquation, part: Part) -> str:
    """The number of a part's composition where there are several, else nothing."""
    return str(equation.first + part.composition + 1) if equation.among > 1 else ""


def letters_of(equation: VectorEquation, part: Part, case: Case, *, bold: bool = False) -> str:
    """The letter of a part with its subscript; in bold the vector."""
    head = letter(equation)
    head = rf"\boldsymbol{{{head}}}" if bold else head
    upper = rf"^{{\mathrm{{{part.part}}}}}" if part.part else ""
    return f"{head}_{{{subscript(equation, part, case)}}}{upper}"


def symbol(equation: VectorEquation, part: Part, case: Case) -> str:
    """The symbol of a part in equations: the algebraic value of an unknown one, the magnitude of a
    known one.
    """
    letters = letters_of(equation, part, case)
    known = (
        part.unknown is None
        and part.role == "absolute"
        and part.part != "n"
        and not is_composed(equation, part)
    )
    term = part.term or path_of(part.together, case)
    negative = known and term is not None and is_told_negative(term, case, equation.level)
    return absolute_value(letters) if negative else letters


def vanishes(part: Part) -> bool:
    """Whether a known part is zero at this instant."""
    return part.unknown is None and abs(float(part.value.x)) + abs(float(part.value.y)) < NEGLIGIBLE


def arm(part: Part, case: Case) -> str:
    """The radius at which a part turns, "AB"; the fixed or base point comes first."""
    return case.naming.point(part.base) + case.naming.point(part.point)


def magnitude(equation: VectorEquation, part: Part, case: Case) -> str:
    """The magnitude of a part in prose: its formula, and its number or a question mark."""
    formula = magnitude_formula(equation, part, case)
    if part.unknown:
        return f"? $({formula})$" if formula else "?"
    number = short(length(part.value, case.arithmetic))
    return f"${formula}={number}$" if formula else f"${number}$"


def magnitude_formula(equation: VectorEquation, part: Part, case: Case) -> str:
    """The formula of a part's magnitude in LaTeX math, "" where it has none."""
    term = part.term
    if term is None:
        return ""
    match part.role:
        case "coriolis":
            relative = rf"v_{{\mathrm{{r}}{number_of(equation, part)}}}"
            return (
                "2"
                + absolute(case.naming.omega(term.frame), omega_value(case, term.frame))
                + absolute(relative, signed_speed(case, term))
            )
        case "absolute" | "transport" | "relative" | "rotation":
            return magnitude_of_term(equation, part, term, case)
        case _:
            assert_never(part.role)


def magnitude_of_term(equation: VectorEquation, part: Part, term: Term, case: Case) -> str:
    """The formula of the magnitude of a term's velocity, or of a part of its acceleration; "" where
    it has none.
    """
    match term.kind:
        case "sliding":
            return ""
        case "arc":
            speed = relative_speed(equation, part, case)
            return rf"\frac{{{speed}^{{2}}}}{{{arm(part, case)}}}" if part.part == "n" else ""
        case "rotation":
            return magnitude_of_rotation(equation, part, term, case)
        case _:
            assert_never(term.kind)


def magnitude_of_rotation(equation: VectorEquation, part: Part, term: Term, case: Case) -> str:
    """The length times the angular velocity, its square, or the angular acceleration."""
    body = term.rate.removeprefix("omega ")
    match part.part:
        case "n":
            return rf"{arm(part, case)}\cdot {case.naming.omega(body)}^{{2}}"
        case "" | "t":
            rate = case.naming.turning(body, equation.level)
            value = float(case.rates(equation.level)[term.rate])
            return rf"{arm(part, case)}\cdot {rate if part.unknown else absolute(rate, value)}"
        case _:
            assert_never(part.part)


def relative_speed(equation: VectorEquation, part: Part, case: Case) -> str:
    """The speed on a circular path: v_r, or v_A on a fixed circle."""
    match part.role:
        case "relative":
            return rf"v_{{\mathrm{{r}}{number_of(equation, part)}}}"
        case "absolute" | "transport" | "rotation" | "coriolis":
            return f"v_{{{case.naming.point(part.point)}}}"
        case _:
            assert_never(part.role)


def absolute(symbol_: str, value: float) -> str:
    """A symbol, between bars where its value is negative."""
    return symbol_ if value >= 0 else absolute_value(symbol_)


def omega_value(case: Case, body: str) -> float:
    """A body's angular velocity as a double."""
    return 0.0 if body == GROUND else float(case.motion.rates[omega_of(body)])


def signed_speed(case: Case, term: Term) -> float:
    """The rate of a relative motion as a double: its sign is that of the speed."""
    return float(case.motion.rates[term.rate])


def direction(equation: VectorEquation, part: Part, case: Case) -> str:
    """The direction of a part in prose: how it lies, and its angle from +x; of an unknown part its
    positive sense.
    """
    angle = angle_text(bearing(heading(part)))
    how = way_of(equation, part, case)
    return f"${how}$, ${angle}$" if how else f"${angle}$"


def way_of(equation: VectorEquation, part: Part, case: Case) -> str:
    """How a part lies in LaTeX math, "" where only its angle describes it."""
    match part.role:
        case "coriolis":
            return rf"\perp v_{{\mathrm{{r}}{number_of(equation, part)}}}"
        case "absolute" | "transport" | "relative" | "rotation":
            return lie(part, case)
        case _:
            assert_never(part.role)


def heading(part: Part) -> Vector:
    """The vector whose direction a part has: itself, or the positive sense of an unknown one."""
    return part.value if part.coefficient is None else part.coefficient


def lie(part: Part, case: Case) -> str:
    """How a part lies in LaTeX math: perpendicular to or along what; "" where only its angle
    describes it.
    """
    term = part.term
    if term is None:
        return ""
    match part.part:
        case "n":
            return rf"{case.naming.point(part.point)}\to {case.naming.point(part.base)}"
        case "" | "t":
            return across_or_along(part, term, case)
        case _:
            assert_never(part.part)


def across_or_along(part: Part, term: Term, case: Case) -> str:
    """The line to which a rotating part is perpendicular, or along which a sliding part lies."""
    match term.kind:
        case "rotation" | "arc":
            return rf"\perp {arm(part, case)}"
        case "sliding":
            return track(term, case)
        case _:
            assert_never(term.kind)


def track(term: Term, case: Case) -> str:
    """The line along which a point slides: by two points, or parallel to an axis."""
    ends = ends_of_track(term, case)
    if ends:
        return rf"\parallel {case.naming.point(ends[0])}{case.naming.point(ends[1])}"
    x, y = abs(float(term.vector.x)), abs(float(term.vector.y))
    return r"\parallel x" if y < NEGLIGIBLE else r"\parallel y" if x < NEGLIGIBLE else ""


def ends_of_track(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points by which the line is given along which a point slides, None where it is given
    otherwise.
    """
    sentence = case.joint(term)
    if sentence and sentence.on and len(sentence.on.arguments) == 2:
        start, end = sentence.on.arguments
        if isinstance(start, Name) and isinstance(end, Name) and end.name in case.motion.points:
            return start.name, end.name
    return None
