"""Where the angle of a line comes from: an isosceles triangle, what is seen in the figure, or the
ratio of two sides.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.expressions.tree import Call, Expression, Name, Operation
from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.functions import Function, FunctionName
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.positions.algebra import make_positive, over
from kinegrade.worked.positions.instance import DEGREE, PURE, make_instance
from kinegrade.worked.positions.isosceles import find_other_leg
from kinegrade.worked.positions.seen_angles import find_seen_acute
from kinegrade.worked.vectors.arms import find_length_tree
from kinegrade.worked.vectors.slopes.derived_angles import is_angle_found, name_acute
from kinegrade.worked.vectors.slopes.directions import find_ends, find_inclination, find_line


def introduce_angle(part: Part, case: Case) -> Iterator[Block]:
    """Where the angle of a part's line comes from, unless that is given or has been said."""
    ends = find_ends(part, case)
    found = find_inclination(part, case)
    if ends is None or found is None or found.angle != name_acute(ends, case):
        return
    if is_angle_found(ends, case):
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
    found = find_line(leg, case)
    angle = case.text(found[0]) if found else ""
    return case.say(Message("solution.isosceles", angle=angle, **names))


def _introduce_acute(ends: tuple[str, str], symbol: Symbol, case: Case) -> Block:
    line = case.text(join_letters(map(case.naming.letter, ends)))
    return case.say(Message("solution.inclination", line=line, angle=case.text(symbol)))
