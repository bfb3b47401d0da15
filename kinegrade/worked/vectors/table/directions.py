"""The direction of each vector of an equation, as the table below it states it."""

from __future__ import annotations

from typing import Any, assert_never

from kinegrade.language.math.tree import Letter, Row, Sign
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import NEGLIGIBLE, double
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.positions.stated_angles import state_bearing
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.known_vectors import find_path_term
from kinegrade.worked.vectors.table.tracks import find_heading, find_path_ends
from kinegrade.worked.vectors.vectors import name_arm, name_by_role, number_composition


def find_omega(case: Case, body: str) -> Any:
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


def _find_orientation(equation: VectorEquation, part: Part, case: Case) -> Row:
    """How a part lies, nothing where only its angle describes it."""
    match part.role:
        case "coriolis":
            number = number_composition(equation, part, case)
            relative = name_by_role("r", "velocity", number, bold=True)
            return _lie_across(relative, find_omega(case, part.frame))
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
