"""How the expressions of positions are evaluated: exactly, or by certified enclosures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import Expression
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls, is_ball


@dataclass(frozen=True)
class Evaluation:
    """How expressions are evaluated in one arithmetic: the values of names, and functions."""

    values: Mapping[str, Any]
    functions: Mapping[str, Callable[..., Any]]
    arithmetic: Any

    @staticmethod
    def of(values: Mapping[str, Any], arithmetic: Any) -> Evaluation:
        """The evaluation with elementary functions, and constructions of the points."""
        points = {name: value for name, value in values.items() if isinstance(value, Vector)}
        functions: dict[str, Callable[..., Any]] = {
            **make_elementary_functions(arithmetic),
            **make_constructions(arithmetic, points),
        }
        return Evaluation(values, functions, arithmetic)

    def evaluate(self, tree: Expression) -> Any:
        """The value of an expression."""
        return evaluate(tree, self.values, self.functions, self.arithmetic)


def has_ball(value: Any) -> bool:
    """Whether a number is an enclosure, or a coordinate of a point is."""
    parts = (value.x, value.y) if isinstance(value, Vector) else (value,)
    return any(map(is_ball, parts))


def enclose(value: Any, balls: Balls) -> Any:
    """An exact value as an enclosure; an enclosure as it is."""
    if isinstance(value, Vector):
        return Vector(enclose(value.x, balls), enclose(value.y, balls))
    if isinstance(value, Angle):
        return value.ball()
    return value if isinstance(value, str) or is_ball(value) else balls.number(value)
