"""Joints and drivers from their sentences, at an instance's values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.geometry import Constructions, Round
from kinegrade.mechanics.joints import Circle, Joint, Line
from kinegrade.mechanics.sentence import DriverParts, JointParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.measures import require_measure
from kinegrade.problem.template.sentences import DriverSentence, JointSentence


@dataclass(frozen=True)
class Parts:
    """Makes joints and drivers from their sentences at an instance's values."""

    values: Mapping[str, Any]
    functions: Mapping[str, Callable[..., Any]]
    points: Mapping[str, Vector]
    arithmetic: Arithmetic

    def value(self, tree: Expression) -> Any:
        """The value of an expression, which may name points."""
        return evaluate(tree, self.values, self.functions, self.arithmetic)

    def shape(self, tree: Call | None) -> Any:
        """A line as a value, a circle with its centre by name; None where the sentence has no such
        shape.
        """
        if tree is None:
            return None
        if tree.function == "circle" and isinstance(tree.arguments[0], Name):
            return Circle(tree.arguments[0].name, require_measure(self.value(tree.arguments[1])))
        line = self.value(tree)
        if not isinstance(line, Line):
            raise ExpressionError(Message("template.shape-expected"))
        return line

    def joint(self, sentence: JointSentence) -> Joint:
        """The joint that a sentence states."""
        parts = JointParts(
            sentence.point,
            sentence.body,
            sentence.of,
            sentence.bodies,
            self.shape(sentence.circle),
            self.shape(sentence.on),
            sentence.carrier,
            sentence.options,
        )
        return sentence.stated.make(parts)

    def driver(self, sentence: DriverSentence) -> Driver:
        """The driver that a sentence states."""
        parts = DriverParts(
            sentence.point,
            sentence.body,
            sentence.of,
            self.direction(sentence.along) if sentence.along is not None else Vector(0, 0),
            sentence.centre,
            require_measure(self.value(sentence.velocity)),
            require_measure(self.value(sentence.acceleration)),
        )
        return sentence.stated.make(parts)

    def direction(self, tree: Expression) -> Vector:
        """The unit vector of an angle. Raises ExpressionError for what is not an angle."""
        value = self.value(tree)
        if isinstance(value, (Vector, Line, Round, str)):
            raise ExpressionError(Message("template.direction-expected"))
        return Constructions(self.arithmetic, self.points).unit(value)
