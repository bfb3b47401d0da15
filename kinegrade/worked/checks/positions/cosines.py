"""Checks of a point that a line through another point and a circle have given: the law of cosines
in the triangle of both and the circle's centre, by what is given alone and what has been found.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import TWO, ZERO, is_negated
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.positions.instance import make_instance
from kinegrade.worked.vectors.summands import PLACES

_RATIOS: dict[AxisName, str] = {"x": "cos", "y": "sin"}


def list_cosine_checks(case: Case) -> Iterator[Check]:
    """The checks of all points on an axis through the origin, from which the centre is placed at a
    given distance and in a given direction.
    """
    placed = {step.point: step.tree for step in case.construction}
    for meeting in _list_meetings(case):
        axis = _find_axis(meeting.point, meeting.base, case)
        match placed.get(meeting.centre):
            case Call("polar", (Name(start), arm, angle)) if start == meeting.base and axis:
                yield _check(meeting, arm, angle, axis, case)
            case Name() | Number() | Operation() | Call() | None:
                continue
            case other:
                assert_never(other)


def list_circles_on_lines(case: Case) -> Iterator[tuple[str, str]]:
    """The points in which a line and a circle meet, each with the centre of the circle."""
    return ((meeting.centre, meeting.point) for meeting in _list_meetings(case))


@dataclass(frozen=True)
class _Meeting:
    """A point in which a line through `base` meets the circle about `centre`."""

    point: str
    base: str
    centre: str
    radius: Expression


def _list_meetings(case: Case) -> Iterator[_Meeting]:
    for step in case.construction:
        match step.tree:
            case Call(
                "meet", (Call("line", (Name(base), *_)), Call("circle", (Name(centre), far)), *_)
            ):
                yield _Meeting(step.point, base, centre, far)
            case Name() | Number() | Operation() | Call():
                continue
            case _:
                assert_never(step.tree)


def _find_axis(point: str, base: str, case: Case) -> AxisName | None:
    """The axis on which a point lies; None where its line leads along none, or not through the
    origin.
    """
    axes = choose_axes(case.construction)
    if any(axes.coordinate(axis, base) != ZERO for axis in AXES):
        return None
    place = case.motion.points[point]
    along = [axis for axis in AXES if double(place[PLACES[axis]])]
    return along[0] if len(along) == 1 else None


def _check(
    meeting: _Meeting, arm: Expression, angle: Expression, axis: AxisName, case: Case
) -> Check:
    """e^2 + y_A^2 - 2 e y_A sin(psi) = r^2."""
    point = meeting.point
    whole = make_instance(case)
    name = whole.free("h")
    letters = name_coordinate(axis, case.naming.letter(point))
    instance = whole.named(name, letters, case.motion.points[point][PLACES[axis]])
    size, turns_back = (angle.right, axis == "y") if is_negated(angle) else (angle, False)
    turned = Operation("*", Name(name), Call(_RATIOS[axis], (size,)))
    mixed = Operation("*", Operation("*", TWO, arm), turned)
    squares = Operation("+", _square(arm), _square(Name(name)))
    trees = Operation("+" if turns_back else "-", squares, mixed), _square(meeting.radius)
    triangle = "".join(map(case.naming.point, (meeting.base, meeting.centre, point)))
    left, right = (
        Side(instance.numbers(tree), instance.value(tree), instance.formula(tree)) for tree in trees
    )
    way = Message("solution.by-law-of-cosines", triangle=triangle)
    return compare(way, left, right, "m^2")


def _square(tree: Expression) -> Expression:
    return Operation("**", tree, TWO)
