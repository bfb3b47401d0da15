"""The magnitude and direction of each vector of an equation, as the table below it states them."""

from __future__ import annotations

from typing import Any, assert_never

from kinegrade.expressions.tree import Name
from kinegrade.language.math.tree import Letter, Row, Sign
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import NEGLIGIBLE, double, length
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.positions.stated_angles import state_bearing
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.known_vectors import find_path_term
from kinegrade.worked.vectors.vectors import (
    UNITS,
    name_arm,
    name_by_role,
    name_point_vector,
    number_composition,
)


def describe_magnitude(equation: VectorEquation, part: Part, case: Case) -> str:
    """The magnitude of a part in prose: its formula, and its number or a question mark."""
    formula = state_magnitude(equation, part, case)
    if part.unknown:
        return f"? $({case.text(formula)})$" if formula else "?"
    *_, number = state_number(length(part.value, case.arithmetic), UNITS[equation.level, False])
    if formula is None:
        return f"${case.text(number.right)}$"
    return case.tell(Equation(formula, (number,)))


def state_magnitude(equation: VectorEquation, part: Part, case: Case) -> Formula | None:
    """The formula of a part's magnitude, None where it has none."""
    term = part.term
    if term is None:
        return None
    match part.role:
        case "coriolis":
            relative = name_by_role("r", "velocity", number_composition(equation, part, case))
            omega = _find_omega(case, term.frame)
            speed = case.motion.rates[term.rate]
            turned = _take_size(case.naming.omega(term.frame), omega)
            return TWO * turned * _take_size(relative, speed)
        case "absolute" | "transport" | "relative" | "rotation":
            return _state_term_magnitude(equation, part, term, case)
        case _:
            assert_never(part.role)


def _state_term_magnitude(
    equation: VectorEquation, part: Part, term: Term, case: Case
) -> Formula | None:
    """The formula of the magnitude of a term's velocity, or of a part of its acceleration; None
    where it has none.
    """
    match term.kind:
        case "sliding":
            return None
        case "arc" if part.part != "n":
            return None
        case "arc":
            return _name_speed(equation, part, case) ** TWO / name_length(
                part.base, part.point, case
            )
        case "rotation":
            return _state_rotation_magnitude(equation, part, term, case)
        case _:
            assert_never(term.kind)


def _state_rotation_magnitude(
    equation: VectorEquation, part: Part, term: Term, case: Case
) -> Formula:
    """The length times the angular velocity, its square, or the angular acceleration."""
    arm, body = name_length(part.base, part.point, case), term.rate.body
    match part.part:
        case "n":
            return arm.dot(case.naming.omega(body) ** TWO)
        case "" | "t":
            rate = case.naming.turning(body, equation.level)
            value = case.rates(equation.level)[term.rate]
            return arm.dot(rate if part.unknown else _take_size(rate, value))
        case _:
            assert_never(part.part)


def _name_speed(equation: VectorEquation, part: Part, case: Case) -> Formula:
    """The speed on a circular path: v_r, or v_A on a fixed circle."""
    match part.role:
        case "relative":
            return name_by_role("r", "velocity", number_composition(equation, part, case))
        case "absolute" | "transport" | "rotation" | "coriolis":
            return name_point_vector(part.point, "velocity", case)
        case _:
            assert_never(part.role)


def _take_size(symbol: Formula, value: Any) -> Formula:
    """A symbol, between bars where its value is negative."""
    return symbol if float(value) >= 0 else abs(symbol)


def _find_omega(case: Case, body: str) -> Any:
    """A body's angular velocity; zero for the ground."""
    return 0 if body == GROUND else case.motion.rates[make_turning(body)]


def describe_direction(equation: VectorEquation, part: Part, case: Case) -> str:
    """The direction of a part in prose: how it lies; where no line is named, its axis or its angle
    from +x, of an unknown part that of its positive sense.
    """
    heading = find_heading(part)
    how = (
        _find_orientation(equation, part, case)
        or _find_axis(heading)
        or _find_arm(part, heading, case)
    )
    if how:
        return f"${write_row(how)}$"
    angle = case.text(state_bearing(heading, part.term, case))
    return case.write(Message("solution.heading-from-axis", angle=angle))


def _find_arm(part: Part, heading: Vector, case: Case) -> Row:
    """From point to point of a body, where a known vector points so, as the acceleration of a rim
    point towards the centre; nothing where it does not.
    """
    if part.term is not None:
        return ()
    points, scheme = case.motion.points, case.template.scheme
    listed = (body.points for body in scheme.bodies if part.point in body.points)
    for other in dict.fromkeys(name for names in listed for name in names):
        arm = points[other] - points[part.point]
        parallel = abs(double(arm.cross(heading))) < NEGLIGIBLE
        if parallel and other != part.point and is_lettered(other, case):
            ends = (part.point, other) if double(arm.dot(heading)) > 0 else (other, part.point)
            start, end = map(case.naming.letter, ends)
            return (*start.row, Sign(r"\to"), *end.row)
    return ()


def find_heading(part: Part) -> Vector:
    """The vector whose direction a part has: itself, or the positive sense of an unknown one."""
    return part.value if part.coefficient is None else part.coefficient


def _find_orientation(equation: VectorEquation, part: Part, case: Case) -> Row:
    """How a part lies, nothing where only its angle describes it."""
    match part.role:
        case "coriolis":
            number = number_composition(equation, part, case)
            relative = name_by_role("r", "velocity", number, bold=True)
            return _lie_across(relative, _find_omega(case, part.frame))
        case "absolute" | "transport" | "relative" | "rotation":
            return _find_alignment(part, case) or _find_circle(equation, part, case)
        case _:
            assert_never(part.role)


def _find_circle(equation: VectorEquation, part: Part, case: Case) -> Row:
    """The radius to which a velocity is normal that another way gives about a fixed point."""
    term = find_path_term(part.together, case)
    if term is None or term.kind == "sliding" or equation.level != "velocity":
        return ()
    ends = term.base, term.point
    return _turn_about(ends, join_letters(map(case.naming.letter, ends)), part, case)


def _turn_about(ends: tuple[str, str], arm: Formula, part: Part, case: Case) -> Row:
    """Normal to an arm, in the sense in which the part goes round the point that comes first."""
    base, point = (case.motion.points[end] for end in ends)
    return _lie_across(arm, (point - base).cross(find_heading(part)))


def _lie_across(line: Formula, turn: Any) -> Row:
    """Normal to a vector, which has been turned counter-clockwise where `turn` is positive."""
    sense = Sign(r"\curvearrowleft" if double(turn) > 0 else r"\curvearrowright")
    return (Sign(r"\perp"), *line.print(), Sign(","), sense)


def _find_alignment(part: Part, case: Case) -> Row:
    """How a part lies: perpendicular to or along what; nothing where only its angle describes
    it.
    """
    term = part.term
    if term is None:
        return ()
    match part.part:
        case "n":
            point, base = map(case.naming.letter, (part.point, part.base))
            return (*point.row, Sign(r"\to"), *base.row)
        case "" | "t":
            return _align_term(part, term, case)
        case _:
            assert_never(part.part)


def _align_term(part: Part, term: Term, case: Case) -> Row:
    """The line to which a rotating part is perpendicular with the sense in which it turns, or the
    way of a sliding part.
    """
    match term.kind:
        case "rotation" | "arc":
            return _turn_about((part.base, part.point), name_arm(part, case), part, case)
        case "sliding":
            return _find_way(part, case)
        case _:
            assert_never(term.kind)


def _find_way(part: Part, case: Case) -> Row:
    """The direction of a known sliding part, and in which an unknown one counts positive: from
    point to point, or that of an axis.
    """
    heading = find_heading(part)
    ends = find_path_ends(part, case)
    if ends:
        start, end = map(case.naming.letter, ends)
        return (*start.row, Sign(r"\to"), *end.row)
    return _find_axis(heading)


def _find_axis(heading: Vector) -> Row:
    """The axis along which a vector points, with its sign; nothing for a slanting one."""
    x, y = float(heading.x), float(heading.y)
    if min(abs(x), abs(y)) > NEGLIGIBLE:
        return ()
    axis = Letter("x") if abs(y) < NEGLIGIBLE else Letter("y")
    return (Sign("+" if x + y > 0 else "-"), axis)


def find_path_ends(part: Part, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a part slides, in its positive sense; None where no
    two points do.
    """
    return orient_track(part.term, find_heading(part), case) if part.term else None


def orient_track(term: Term, positive: Vector, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a point slides, so that the way from one to the
    other is the `positive` one; None where no two points do.
    """
    ends = find_track_ends(term, case) if term.kind == "sliding" else None
    if ends is None:
        return None
    start, end = (case.motion.points[point] for point in ends)
    return ends if float((end - start).dot(positive)) > 0 else (ends[1], ends[0])


def find_track_ends(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points by which the line is given along which a point slides, None where it is given
    otherwise.
    """
    sentence = case.joint(term)
    if sentence and sentence.on and len(sentence.on.arguments) == 2:
        start, end = sentence.on.arguments
        if isinstance(start, Name) and isinstance(end, Name) and end.name in case.motion.points:
            return start.name, end.name
        if isinstance(start, Name) and _lies_aslant(start.name, term, case):
            return start.name, term.point
    return None


def _lies_aslant(start: str, term: Term, case: Case) -> bool:
    """Whether a line through a point, given by its angle, passes through the point that slides
    along it, and along no axis.
    """
    points, x, y = case.motion.points, *map(abs, map(float, term.vector))
    if start not in points or min(x, y) < NEGLIGIBLE:
        return False
    away = points[term.point] - points[start]
    offset = abs(float(away.cross(term.vector)))
    return offset < NEGLIGIBLE < float(away.squared())
