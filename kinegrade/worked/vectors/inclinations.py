"""Directions by named angles: what a direction makes with the x axis, by an angle of the statement
or by one that is derived from the coordinates of two points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Operation
from kinegrade.language.message import Message
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.document import Block, Display
from kinegrade.worked.findings import Stated
from kinegrade.worked.formulas.atoms import TWO, Symbol, add_terms, list_summands
from kinegrade.worked.formulas.formula import Formula, Function, FunctionName, Sum
from kinegrade.worked.formulas.measures import bearing, double, tidy
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.formulas.symbols import index_letter, join_letters
from kinegrade.worked.positions.algebra import make_positive, over
from kinegrade.worked.positions.instance import DEGREE, PURE, make_instance
from kinegrade.worked.positions.isosceles import find_mirrored_angle, find_other_leg
from kinegrade.worked.positions.marked_angles import measure_given
from kinegrade.worked.positions.seen_angles import find_seen_acute
from kinegrade.worked.positions.stated_angles import find_stated_angle, find_track_angle
from kinegrade.worked.vectors.arms import find_length_tree
from kinegrade.worked.vectors.known_vectors import find_path_term
from kinegrade.worked.vectors.magnitudes import find_heading, find_track_ends

_RIGHT = 90.0
_CLOSE = 1e-6  # degrees
_ACUTE = "psi"  # the letter of a derived angle
_Ratio: TypeAlias = Literal["sin", "cos"]
_TURNED: tuple[tuple[int, _Ratio], ...] = ((1, "cos"), (-1, "sin"), (-1, "cos"), (1, "sin"))


@dataclass(frozen=True)
class Inclination:
    """A direction as sign times a named angle plus right angles, counter-clockwise from +x.

    `angle` is None for a direction along an axis; `value` is that of the angle, in degrees.
    """

    sign: int
    angle: Formula | None
    value: float
    quarters: int


@dataclass(frozen=True)
class Cosine:
    """The cosine of the angle between two directions, as a sine or cosine of named angles;
    `summands` are those of its angle in degrees, with their signs, where it is a sum.
    """

    sign: int
    function: _Ratio
    angle: Formula
    value: float
    summands: tuple[float, ...] = ()

    def state(self, in_numbers: bool) -> Formula:
        """The function without its sign, of the angle in symbols or in degrees."""
        return Function(self.function, state_angle(self.value) if in_numbers else self.angle)


def find_cosine(heading: Inclination, axis: Inclination) -> Cosine | None:
    """The cosine of the angle between two directions; None where that is a right angle or none."""
    terms = sorted(
        (
            (sign, one)
            for sign, one in ((heading.sign, heading), (-axis.sign, axis))
            if one.angle is not None
        ),
        key=lambda term: _rank(*term),
    )
    value = tidy(sum(sign * one.value for sign, one in terms))
    angle = _add_angles([(sign, one.angle) for sign, one in terms if one.angle is not None])
    if angle is None:
        return None
    if value < 0 or (value == 0 and angle.sign < 0):
        return find_cosine(_mirror(heading), _mirror(axis))
    sign, function = _TURNED[(heading.quarters - axis.quarters) % 4]
    values = sorted((sign * one.value for sign, one in terms), key=lambda each: each < 0)
    summands = tuple(values) if len(values) > 1 and isinstance(angle, Sum) else ()
    return Cosine(sign, function, angle, value, summands)


def _rank(sign: int, one: Inclination) -> tuple[int, bool, str]:
    """The place of an angle in a sum: the same in every sum, given angles before derived ones."""
    letters = "" if one.angle is None else write_row(one.angle.print())
    return -sign, rf"\{_ACUTE}_" in letters, letters


def _mirror(one: Inclination) -> Inclination:
    """The direction reflected in the x axis, whose cosines are the same."""
    return Inclination(-one.sign, one.angle, one.value, -one.quarters)


def _add_angles(terms: list[tuple[int, Formula]]) -> Formula | None:
    """A sum of angles, those that count positive first; None where nothing is left."""
    if len(terms) == 2 and terms[0][1] == terms[1][1]:
        same = terms[0][0] == terms[1][0]
        return (TWO * terms[0][1]).signed(terms[0][0]) if same else None
    summands = [one for sign, angle in terms for one in list_summands(angle.signed(sign))]
    left: list[Formula] = []
    for one in summands:
        if -one in left:
            left.remove(-one)
        else:
            left.append(one)
    ordered = sorted(left, key=lambda one: -one.sign)
    return add_terms(ordered) if left else None


def find_inclination(part: Part, case: Case) -> Inclination | None:
    """The direction of a part, its positive one where it is unknown; None where no angle is
    named.
    """
    return name_direction(bearing(find_heading(part)), part, case)


def name_direction(direction: float, part: Part, case: Case) -> Inclination | None:
    """A direction along or normal to the line that belongs to a part."""
    ends = find_ends(part, case)
    if ends is not None:
        return name_along(direction, ends, case)
    track = find_track_angle(part.term, case) if part.term else None
    return name_axis(direction) or (relate(direction, track) if track else None)


def name_along(direction: float, ends: tuple[str, str], case: Case) -> Inclination | None:
    """A direction along or normal to the line through two points; None for any other."""
    axis = name_axis(direction)
    if axis is not None:
        return axis
    line = _find_line(ends, case)
    return relate(direction, line) if line else None


def relate(direction: float, line: Stated) -> Inclination | None:
    """A direction by the angle of a line along or normal to which it is; None for any other."""
    angle, sign, value = line
    quarters = (direction - sign * value) / _RIGHT
    if abs(quarters - round(quarters)) > _CLOSE:
        return None
    return Inclination(sign, angle, value, round(quarters))


def name_axis(direction: float) -> Inclination | None:
    """A direction along an axis, in degrees from +x; None for an oblique one."""
    quarters = round(direction / _RIGHT)
    along = abs(direction / _RIGHT - quarters) < _CLOSE
    return Inclination(1, None, 0.0, quarters) if along else None


def find_ends(part: Part, case: Case) -> tuple[str, str] | None:
    """The two points of the line along or normal to which a part lies."""
    term = part.term or find_path_term(part.together, case)
    return find_term_ends(term, case) if term else None


def find_term_ends(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points of the line along or normal to which a term lies."""
    match term.kind:
        case "sliding":
            return find_track_ends(term, case)
        case "rotation" | "arc":
            return (term.base, term.point)
        case _:
            assert_never(term.kind)


def _find_line(ends: tuple[str, str], case: Case) -> tuple[Formula, int, float] | None:
    """The named angle of a line, the sign with which it counts, and its value."""
    if not set(ends) <= set(case.motion.points):
        return None
    start, end = (case.motion.points[point] for point in ends)
    value = bearing(end - start)
    stated = find_stated_angle(ends, case) or find_mirrored_angle(ends, case)
    if stated is not None:
        return stated
    acute = min(value % 180, 180 - value % 180)
    return name_acute(ends, case), 1 if value % 180 < _RIGHT else -1, tidy(acute)


def name_acute(ends: tuple[str, str], case: Case) -> Symbol:
    """The acute angle between a line and the x axis, psi_AB; psi_BA, or psi_CB of the same line,
    where that has been found.
    """
    order = _find_same_line(ends, case) or ends
    return index_letter(_ACUTE, join_letters(map(case.naming.letter, order)).row)


def _find_same_line(ends: tuple[str, str], case: Case) -> tuple[str, str] | None:
    """Two points of the line through `ends` whose angle has been found, `ends` first."""
    for order in (ends, ends[::-1]):
        if order in case.findings.inclined:
            return order
    points = case.motion.points
    start, way = points[ends[0]], points[ends[1]] - points[ends[0]]

    def lies(point: str) -> bool:
        return not double(way.cross(points[point] - start))

    found = (pair for pair in case.findings.inclined if all(map(lies, pair)))
    return min(found, default=None)


def is_direction_told(part: Part, case: Case) -> bool:
    """Whether a part's direction is along an axis, or by an angle that is given or that the
    solution has found, of its own line or of one parallel to it.
    """
    ends, found = find_ends(part, case), find_inclination(part, case)
    if found is None or found.angle is None:
        return found is not None
    known = ends is None or is_inclination_known(found, ends, case)
    return known or is_line_found(found.value, case)


def is_inclination_known(found: Inclination, ends: tuple[str, str], case: Case) -> bool:
    """Whether the angle of a line is given or has been introduced."""
    return found.angle != name_acute(ends, case) or _is_found(ends, case)


def _is_found(ends: tuple[str, str], case: Case) -> bool:
    """Whether the acute angle of the line through two points has been found."""
    return _find_same_line(ends, case) is not None


def is_line_found(angle: float, case: Case) -> bool:
    """Whether an acute angle, in degrees, is that of a line with x which has been introduced, or is
    given.
    """
    points = case.motion.points
    lines = (bearing(points[end] - points[start]) % 180 for start, end in case.findings.inclined)
    found = (min(line, 180 - line) for line in lines)
    given = (measure_given(name, case) for name in case.template.angles)
    return any(abs(one - angle) < _CLOSE for one in (*found, *given))


def introduce_angle(part: Part, case: Case) -> Iterator[Block]:
    """Where the angle of a part's line comes from, unless that is given or has been said."""
    ends = find_ends(part, case)
    found = find_inclination(part, case)
    if ends is None or found is None or found.angle != name_acute(ends, case):
        return
    if _is_found(ends, case):
        return
    leg = find_other_leg(ends, case)
    if leg is not None:
        case.findings.legs[frozenset(ends)] = leg
        yield _explain_legs(ends, leg, case)
        return
    case.findings.inclined.add(ends)
    instance = make_instance(case)
    pair = instance.axes.pair(Operation("-", Name(ends[1]), Name(ends[0])))
    if pair is None:
        return
    symbol = name_acute(ends, case)
    yield _introduce_acute(ends, symbol, case)
    seen = find_seen_acute(ends, instance)
    if seen is not None:
        tree, named = seen
        yield Display(named.equation(symbol, tree, DEGREE))
        return
    rise, run = (make_positive(one, instance.sign(one)) for one in (pair[1], pair[0]))
    name, size = instance.free("inclination"), find_length_tree(*ends, case)
    steep = double(instance.value(rise)) > double(instance.value(run))
    function, inverse, ratio = _choose_ratio(rise, run, size, steep)
    further = instance.named(name, symbol, instance.value(Call(inverse, (ratio,))))
    yield Display(
        (
            *instance.equation(Function(function, symbol), ratio, PURE),
            *further.equation(symbol, Name(name), DEGREE),
        )
    )


def _choose_ratio(
    rise: Expression, run: Expression, size: Expression | None, steep: bool
) -> tuple[FunctionName, str, Expression]:
    """The ratio that gives an angle: to the length of the line where that is given, of the shorter
    side, which tells the angle more exactly; else of its sides.
    """
    if size is None:
        return "tan", "atan", over(rise, run)
    return ("cos", "acos", over(run, size)) if steep else ("sin", "asin", over(rise, size))


def _explain_legs(ends: tuple[str, str], leg: tuple[str, str], case: Case) -> Block:
    """That a triangle is isosceles, and which angle its second leg has for that reason."""
    foot, apex = leg
    other = next(end for end in ends if end != apex)
    corners = zip(("first", "second", "apex"), (foot, other, apex), strict=True)
    names = {name: case.naming.point(corner) for name, corner in corners}
    found = _find_line(leg, case)
    angle = case.text(found[0]) if found else ""
    return case.say(Message("solution.isosceles", angle=angle, **names))


def _introduce_acute(ends: tuple[str, str], symbol: Symbol, case: Case) -> Block:
    line = case.text(join_letters(map(case.naming.letter, ends)))
    return case.say(Message("solution.inclination", line=line, angle=case.text(symbol)))
