"""Whether conditions hold at given values, and which of a template's texts applies there; decided
exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, assert_never

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Operation, find_names
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.assembling.construction import construct
from kinegrade.problem.given_values import find_parameter_values, read_values
from kinegrade.problem.solving import solve_certified
from kinegrade.problem.template.template import Condition, Relation, Template, Wording


def choose_wording(template: Template, name: str, given: Mapping[str, str]) -> Wording | None:
    """The first wording of the text `name` that applies at given values; None where none does."""
    for candidate in template.words.texts[name]:
        if candidate.condition is None or condition_holds(template, candidate.condition, given):
            return candidate
    return None


def condition_holds(template: Template, condition: Condition, given: Mapping[str, str]) -> bool:
    """Whether a condition holds at given values; decided exactly. One that cannot be worked out,
    or names points that cannot be constructed, does not hold.
    """
    trees = read_values(template, given)

    def decide(arithmetic: Arithmetic) -> bool:
        values = find_parameter_values(template, trees, arithmetic)
        room = find_room(template, condition, values, arithmetic)
        sign = arithmetic.sign(_count_half_turns(room) if isinstance(room, Angle) else room)
        return _meets_relation(condition.relation, sign)

    try:
        return solve_certified(decide)
    except (ExpressionError, MechanismError):  # a division by zero, circles that do not meet
        return False


def find_room(
    template: Template, condition: Condition, given: Mapping[str, Any], arithmetic: Arithmetic
) -> Any:
    """By how much the right side of a condition exceeds the left, at `given` (parameters in SI).
    Raises MechanismError, ExpressionError, Inexact.
    """
    room = Operation("-", condition.right, condition.left)
    built = construct(template, given, arithmetic, frozenset(find_names(room)))
    return evaluate(room, built.values, built.functions, arithmetic)


def _meets_relation(relation: Relation, sign: int) -> bool:
    """Whether the sign of right - left is what the relation asks for."""
    match relation:
        case "<":
            return sign > 0
        case "<=":
            return sign >= 0
        case "==":
            return sign == 0
        case "!=":
            return sign != 0
        case _:
            assert_never(relation)


def is_surely_unmet(relation: Relation, room: Any, margin: float) -> Any:
    """Whether doubles show that a relation does not hold, one by one: `room` is the right side less
    the left, and off by less than `margin`.
    """
    match relation:
        case "<" | "<=":
            return room < -margin
        case "==":
            return abs(room) > margin
        case "!=":
            return False  # two doubles alike may stand for different numbers
        case _:
            assert_never(relation)


def _count_half_turns(angle: Angle) -> Any:
    """An angle over pi, as a rational. Raises Inexact where it is not one."""
    if angle.parts:
        raise Inexact  # the sign of an arctangent
    return angle.half_turns
