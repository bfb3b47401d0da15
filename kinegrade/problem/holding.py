"""Whether conditions hold at given values, and which of a template's texts applies there; decided
exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, assert_never

from kinegrade.errors import ExpressionError
from kinegrade.exact.angle import Angle, Inexact
from kinegrade.expression import Operation, elementary, evaluate
from kinegrade.problem.solving import certified, parameter_values, read_values
from kinegrade.problem.template import Condition, Relation, Template, Wording


def wording(template: Template, name: str, given: Mapping[str, str]) -> Wording | None:
    """The first wording of the text `name` that applies at given values; None where none does."""
    for candidate in template.words.texts[name]:
        if candidate.condition is None or holds(template, candidate.condition, given):
            return candidate
    return None


def holds(template: Template, condition: Condition, given: Mapping[str, str]) -> bool:
    """Whether a condition holds at given values; decided exactly. One that cannot be worked out
    does not hold.
    """
    trees = read_values(template, given)

    def decide(arithmetic: Any) -> bool:
        values = {**parameter_values(template, trees, arithmetic), "pi": arithmetic.turns(1)}
        room = evaluate(
            Operation("-", condition.right, condition.left),
            values,
            elementary(arithmetic),
            arithmetic,
        )
        sign = arithmetic.sign(half_turns(room) if isinstance(room, Angle) else room)
        return meets(condition.relation, sign)

    try:
        return certified(decide)
    except ExpressionError:  # a division by zero or the root of a negative number
        return False


def meets(relation: Relation, sign: int) -> bool:
    """Whether the sign of right - left is what the relation asks for."""
    match relation:
        case "<":
            return sign > 0
        case "<=":
            return sign >= 0
        case "==":
            return sign == 0
        case _:
            assert_never(relation)


def half_turns(angle: Angle) -> Any:
    """An angle over pi, as a rational. Raises Inexact where it is not one."""
    if angle.parts:
        raise Inexact("the sign of an arctangent")
    return angle.half_turns
