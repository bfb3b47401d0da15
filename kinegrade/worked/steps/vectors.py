"""How the vectors of an equation are written: symbol, magnitude and direction.

v_a, v_e, v_r and a_C in a composition of motions, v_BA and a_BA^n, a_BA^t about a base point.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from kinegrade.expressions.expression import Name
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, Role, VectorEquation
from kinegrade.worked.formulas.numbers import (
    NEGLIGIBLE,
    bearing,
    length,
    write_absolute_value,
    write_angle,
    write_short,
)
from kinegrade.worked.steps.known_vectors import find_path_term, is_stated_negative
from kinegrade.worked.words.solution_case import LETTERS, Case

_ROLES: Mapping[Role, str] = {
    "transport": r"\mathrm{e}",
    "relative": r"\mathrm{r}",
    "coriolis": r"\mathrm{C}",
}


def write_letter(equation: VectorEquation) -> str:
    """v or a."""
    return LETTERS[equation.level]


def write_subscript(equation: VectorEquation, part: Part, case: Case) -> str:
    """The subscript of a part: a, e, r, C in a composition (numbered where there are two), else the
    points.
    """
    plain = case.naming.point(part.point)
    point = write_primed(plain) if part.coincident else plain
    match part.role:
        case "transport" | "relative" | "coriolis":
            return _ROLES[part.role] + write_composition_number(equation, part)
        case "absolute":
            return r"\mathrm{a}" if is_composed(equation, part) else point + _find_axis(part)
        case "rotation":
            return point + case.naming.point(part.base)
        case _:
            assert_never(part.role)


def write_primed(point: str) -> str:
    """The letter of the point that coincides with a point: B', and O'_{1} for O_{1}."""
    head, mark, rest = point.partition("_")
    return f"{head}'{mark}{rest}"


def _find_axis(part: Part) -> str:
    """x or y for a component of a free point's motion."""
    kind = part.term.rate.kind if part.term else None
    match kind:
        case "free-x":
            return ",x"
        case "free-y":
            return ",y"
        case "turning" | "sliding" | "circling" | "added-x" | "added-y" | None:
            return ""
        case _:
            assert_never(kind)


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


def write_composition_number(equation: VectorEquation, part: Part) -> str:
    """The number of a part's composition where there are several, else nothing."""
    return str(equation.first + part.composition + 1) if equation.among > 1 else ""


def write_letters(equation: VectorEquation, part: Part, case: Case, *, bold: bool = False) -> str:
    """The letter of a part with its subscript; in bold the vector."""
    head = write_letter(equation)
    head = rf"\boldsymbol{{{head}}}" if bold else head
    upper = rf"^{{\mathrm{{{part.part}}}}}" if part.part else ""
    return f"{head}_{{{write_subscript(equation, part, case)}}}{upper}"


def write_symbol(equation: VectorEquation, part: Part, case: Case) -> str:
    """The symbol of a part in equations: the algebraic value of an unknown one, the magnitude of a
    known one.
    """
    letters = write_letters(equation, part, case)
    known = (
        part.unknown is None
        and part.role == "absolute"
        and part.part != "n"
        and not is_composed(equation, part)
    )
    term = part.term or find_path_term(part.together, case)
    negative = known and term is not None and is_stated_negative(term, case, equation.level)
    return write_absolute_value(letters) if negative else letters


def vanishes(part: Part) -> bool:
    """Whether a known part is zero at this instant."""
    return part.unknown is None and abs(float(part.value.x)) + abs(float(part.value.y)) < NEGLIGIBLE


def find_arm(part: Part, case: Case) -> str:
    """The radius at which a part turns, "AB"; the fixed or base point comes first."""
    return case.naming.point(part.base) + case.naming.point(part.point)


def describe_magnitude(equation: VectorEquation, part: Part, case: Case) -> str:
    """The magnitude of a part in prose: its formula, and its number or a question mark."""
    formula = write_magnitude_formula(equation, part, case)
    if part.unknown:
        return f"? $({formula})$" if formula else "?"
    number = write_short(length(part.value, case.arithmetic))
    return f"${formula}={number}$" if formula else f"${number}$"


def write_magnitude_formula(equation: VectorEquation, part: Part, case: Case) -> str:
    """The formula of a part's magnitude in LaTeX math, "" where it has none."""
    term = part.term
    if term is None:
        return ""
    match part.role:
        case "coriolis":
            relative = rf"v_{{\mathrm{{r}}{write_composition_number(equation, part)}}}"
            return (
                "2"
                + _write_absolute(case.naming.omega(term.frame), _omega_value(case, term.frame))
                + _write_absolute(relative, _signed_speed(case, term))
            )
        case "absolute" | "transport" | "relative" | "rotation":
            return _write_term_magnitude(equation, part, term, case)
        case _:
            assert_never(part.role)


def _write_term_magnitude(equation: VectorEquation, part: Part, term: Term, case: Case) -> str:
    """The formula of the magnitude of a term's velocity, or of a part of its acceleration; "" where
    it has none.
    """
    match term.kind:
        case "sliding":
            return ""
        case "arc":
            speed = _write_relative_speed(equation, part, case)
            return rf"\frac{{{speed}^{{2}}}}{{{find_arm(part, case)}}}" if part.part == "n" else ""
        case "rotation":
            return _write_rotation_magnitude(equation, part, term, case)
        case _:
            assert_never(term.kind)


def _write_rotation_magnitude(equation: VectorEquation, part: Part, term: Term, case: Case) -> str:
    """The length times the angular velocity, its square, or the angular acceleration."""
    body = term.rate.body
    match part.part:
        case "n":
            return rf"{find_arm(part, case)}\cdot {case.naming.omega(body)}^{{2}}"
        case "" | "t":
            rate = case.naming.turning(body, equation.level)
            value = float(case.rates(equation.level)[term.rate])
            return (
                rf"{find_arm(part, case)}\cdot "
                rf"{rate if part.unknown else _write_absolute(rate, value)}"
            )
        case _:
            assert_never(part.part)


def _write_relative_speed(equation: VectorEquation, part: Part, case: Case) -> str:
    """The speed on a circular path: v_r, or v_A on a fixed circle."""
    match part.role:
        case "relative":
            return rf"v_{{\mathrm{{r}}{write_composition_number(equation, part)}}}"
        case "absolute" | "transport" | "rotation" | "coriolis":
            return f"v_{{{case.naming.point(part.point)}}}"
        case _:
            assert_never(part.role)


def _write_absolute(symbol_: str, value: float) -> str:
    """A symbol, between bars where its value is negative."""
    return symbol_ if value >= 0 else write_absolute_value(symbol_)


def _omega_value(case: Case, body: str) -> float:
    """A body's angular velocity as a double."""
    return 0.0 if body == GROUND else float(case.motion.rates[make_turning(body)])


def _signed_speed(case: Case, term: Term) -> float:
    """The rate of a relative motion as a double: its sign is that of the speed."""
    return float(case.motion.rates[term.rate])


def describe_direction(equation: VectorEquation, part: Part, case: Case) -> str:
    """The direction of a part in prose: how it lies, and its angle from +x; of an unknown part its
    positive sense.
    """
    angle = write_angle(bearing(find_heading(part)))
    how = _write_orientation(equation, part, case)
    return f"${how}$, ${angle}$" if how else f"${angle}$"


def _write_orientation(equation: VectorEquation, part: Part, case: Case) -> str:
    """How a part lies in LaTeX math, "" where only its angle describes it."""
    match part.role:
        case "coriolis":
            return rf"\perp v_{{\mathrm{{r}}{write_composition_number(equation, part)}}}"
        case "absolute" | "transport" | "relative" | "rotation":
            return _write_alignment(part, case)
        case _:
            assert_never(part.role)


def find_heading(part: Part) -> Vector:
    """The vector whose direction a part has: itself, or the positive sense of an unknown one."""
    return part.value if part.coefficient is None else part.coefficient


def _write_alignment(part: Part, case: Case) -> str:
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
            return _describe_alignment(part, term, case)
        case _:
            assert_never(part.part)


def _describe_alignment(part: Part, term: Term, case: Case) -> str:
    """The line to which a rotating part is perpendicular, or along which a sliding part lies."""
    match term.kind:
        case "rotation" | "arc":
            return rf"\perp {find_arm(part, case)}"
        case "sliding":
            return _find_track(term, case)
        case _:
            assert_never(term.kind)


def _find_track(term: Term, case: Case) -> str:
    """The line along which a point slides: by two points, or parallel to an axis."""
    ends = find_track_ends(term, case)
    if ends:
        return rf"\parallel {case.naming.point(ends[0])}{case.naming.point(ends[1])}"
    x, y = abs(float(term.vector.x)), abs(float(term.vector.y))
    return r"\parallel x" if y < NEGLIGIBLE else r"\parallel y" if x < NEGLIGIBLE else ""


def find_track_ends(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points by which the line is given along which a point slides, None where it is given
    otherwise.
    """
    sentence = case.joint(term)
    if sentence and sentence.on and len(sentence.on.arguments) == 2:
        start, end = sentence.on.arguments
        if isinstance(start, Name) and isinstance(end, Name) and end.name in case.motion.points:
            return start.name, end.name
    return None
