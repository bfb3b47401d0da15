"""The parameters of a template in SI, from expressions in their units."""

from __future__ import annotations

from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import Expression
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.template.template import Parameter


def read_parameter(parameter: Parameter, tree: Expression, arithmetic: Arithmetic) -> Any:
    """A parameter in SI from an expression in its unit; degrees may also be given as an angle like
    atan(3/4).

    Raises ExpressionError for what is not a number, Inexact where no exact field contains it.
    """
    value = evaluate(
        tree, {"pi": arithmetic.turns(1)}, make_elementary_functions(arithmetic), arithmetic
    )
    angular = is_angle(tree, frozenset())
    if parameter.unit.degrees:
        return value if angular else arithmetic.turns(value / 180)
    if parameter.unit.text == "rad":
        return value if angular or not arithmetic.exact else _read_radians(value)
    if isinstance(value, Vector):
        raise ExpressionError(Message("template.number-expected"))
    if isinstance(value, Angle):
        raise Inexact  # a number with pi in it
    return value * arithmetic.scale(parameter.unit.scale)


def _read_radians(value: Any) -> Any:
    """A number of radians as an exact angle: only zero is one."""
    if value == 0:
        return Angle(value)
    raise Inexact  # a rational number of radians
