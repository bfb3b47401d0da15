"""Whether sentences determine the positions of points: the rank of the conditions that they state.

Positions are determined where the conditions, linearised at the instance, have as many independent
rows as there are coordinates.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import atan2, hypot, sqrt
from typing import Any, assert_never

from kinegrade.description.marks import Mark, find_way
from kinegrade.description.subject import Subject
from kinegrade.errors import KinegradeError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import Expression, Name
from kinegrade.mechanics.geometry import Round, make_constructions
from kinegrade.mechanics.joints import (
    Arc,
    Belt,
    Contact,
    Joint,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.problem.template.hints import Angle as MarkedAngle
from kinegrade.problem.template.hints import Length
from kinegrade.problem.template.sentences import JointSentence
from kinegrade.worked.construction_steps import Step

_Points = Mapping[str, Vector]
Condition = Callable[[_Points], tuple[float, ...]]  # zero where it is met
_STEP = 1e-6  # shares of the size of the mechanism
_INDEPENDENT = 1e-4  # of a row of length 1, what others leave; roundings of differences leave 1e-9


@dataclass
class Rank:
    """The independent rows of conditions, each of length 1 and at right angles to the others."""

    subject: Subject
    rows: list[list[float]] = field(default_factory=list)

    def add(self, condition: Condition) -> bool:
        """Whether a condition says what the others do not; its rows are then among them."""
        before = len(self.rows)
        for row in differentiate(condition, self.subject.doubles):
            left = _remove_known(row, self.rows)
            if left is not None:
                self.rows.append(left)
        return len(self.rows) > before


def _remove_known(row: list[float], rows: list[list[float]]) -> list[float] | None:
    """The part of a row that others do not have, of length 1; None where there is none."""
    size = sqrt(sum(number * number for number in row))
    if size == 0:
        return None
    left = [number / size for number in row]
    for known in rows:
        share = sum(a * b for a, b in zip(left, known, strict=True))
        left = [a - share * b for a, b in zip(left, known, strict=True)]
    rest = sqrt(sum(number * number for number in left))
    return [number / rest for number in left] if rest > _INDEPENDENT else None


def differentiate(condition: Condition, points: _Points) -> list[list[float]]:
    """A row for each number of a condition, with a column for each coordinate of the points."""
    step = _STEP * max(hypot(point.x, point.y) for point in points.values())
    columns = []
    for name, point in points.items():
        for way in (Vector(step, 0.0), Vector(0.0, step)):
            after = condition({**points, name: point + way})
            before = condition({**points, name: point - way})
            columns.append([(a - b) / (2 * step) for a, b in zip(after, before, strict=True)])
    return [list(row) for row in zip(*columns, strict=True)]


def place_condition(step: Step, subject: Subject) -> Condition:
    """That a point is where its construction has it; nothing follows where points moved a little
    have no such point.
    """

    def condition(points: _Points) -> tuple[float, ...]:
        try:
            apart = points[step.point] - _evaluate(step.tree, points, subject)
        except KinegradeError:
            return 0.0, 0.0
        return apart.x, apart.y

    return condition


def _evaluate(tree: Expression, points: _Points, subject: Subject) -> Any:
    arithmetic = Floats()
    functions = {**make_elementary_functions(arithmetic), **make_constructions(arithmetic, points)}
    with arithmetic.context():
        return evaluate(tree, {**subject.values, **points}, functions, arithmetic)


def joint_condition(joint: Joint, sentence: JointSentence, subject: Subject) -> Condition | None:
    """What a joint says of positions; None where it says nothing of them."""
    match joint:
        case Slide(point=point) | Arc(point=point):
            return lambda points: (
                _measure_gap(points[point], 0.0, _evaluate_shape(sentence.on, points, subject)),
            )
        case Contact(circle=circle, inside=inside) | Roll(circle=circle, inside=inside):
            reach = -float(circle.radius) if inside else float(circle.radius)
            return lambda points: _touch(points, circle.centre, reach, sentence, subject)
        case Mesh(circle=circle, inside=inside):
            reach = -float(circle.radius) if inside else float(circle.radius)
            return lambda points: _touch(points, circle.centre, reach, sentence, subject)
        case Pin() | Parallel() | Belt() | Sleeve():
            return None
        case _:
            assert_never(joint)


def _touch(
    points: _Points, centre: str, reach: float, sentence: JointSentence, subject: Subject
) -> tuple[float, ...]:
    shape = _evaluate_shape(sentence.on, points, subject)
    return (_measure_gap(points[centre], reach, shape),)


def _evaluate_shape(shape: Expression | None, points: _Points, subject: Subject) -> Line | Round:
    found: Line | Round = _evaluate(shape or Name(""), points, subject)
    return found


def _measure_gap(point: Vector, reach: float, shape: Line | Round) -> float:
    """How far a circle of that radius about a point is from touching a line or a circle, m; a
    negative one touches it from inside.
    """
    match shape:
        case Line(point=base, direction=direction):
            across = direction.cross(point - base) / sqrt(direction.squared())
            return float(abs(across) - reach if reach else across)
        case Round(centre=centre, radius=radius):
            return float(sqrt((point - centre).squared()) - radius - reach)
        case _:
            assert_never(shape)


def mark_condition(mark: Mark, subject: Subject) -> Condition:
    """What a mark says of positions: that its measure is what it is."""
    measured = _measure(mark, subject.doubles)
    return lambda points: (_measure(mark, points) - measured,)


def _measure(mark: Mark, points: _Points) -> float:
    match mark:
        case Length(start=start, end=end, along=along):
            apart = points[end] - points[start]
            sizes = {None: hypot(apart.x, apart.y), "horizontal": apart.x, "vertical": apart.y}
            return float(sizes[along])
        case MarkedAngle(at=at, start=start, end=end):
            first, second = find_way(at, start, points), find_way(at, end, points)
            return float(atan2(first.cross(second), first.dot(second)))
        case (start, at, end):
            return float((points[start] - points[at]).dot(points[end] - points[at]))
        case _:
            assert_never(mark)
