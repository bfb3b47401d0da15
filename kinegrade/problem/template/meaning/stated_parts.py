"""What each part that a template states must be made of: points of lengths, joints of lines and
circles, inputs of rates or velocities, asks of the dimension of their unit.
"""

from __future__ import annotations

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import SUMS, Expression, Operation, walk
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.kinds.dimension import ACCELERATION, CHANGE, LENGTH, NUMBER, RATE, SPEED
from kinegrade.problem.kinds.kinds import (
    Arrow,
    Ring,
    Scalar,
    Straight,
    Unknown,
    describe_kind,
    require_unit,
    unite_dimensions,
)
from kinegrade.problem.template.meaning.meaning import Scope
from kinegrade.problem.template.meaning.radians import require_no_radians
from kinegrade.problem.template.meaning.required_kinds import (
    list_units,
    require_dimension,
    require_no_number,
    require_number,
)
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import Ask, Condition


def check_point(scope: Scope, tree: Expression) -> None:
    """A point: its coordinates are lengths."""
    kind = scope.kind(tree)
    if not isinstance(kind, Arrow | Unknown):
        raise FieldError(describe_kind(kind), Message("template.point-like"))
    require_dimension(kind, LENGTH, "coordinates")


def check_joint(scope: Scope, sentence: JointSentence) -> None:
    """A joint: its lines and circles."""
    for shape in (sentence.circle, sentence.on):
        kind = scope.kind(shape) if shape is not None else Unknown()
        if not isinstance(kind, Straight | Ring | Unknown):
            raise FieldError(describe_kind(kind), Message("template.a-shape"))


def check_driver(scope: Scope, sentence: DriverSentence) -> None:
    """An input: a rotation in rad/s and rad/s^2, the motion of a point in m/s and m/s^2."""
    velocity, acceleration = (RATE, CHANGE) if sentence.stated.TURNS else (SPEED, ACCELERATION)
    require_dimension(require_number(scope.kind(sentence.velocity)), velocity, "velocity")
    require_dimension(
        require_number(scope.kind(sentence.acceleration)), acceleration, "acceleration"
    )
    if sentence.along is None:
        return
    require_no_radians(sentence.along)
    direction = scope.kind(sentence.along)
    if not isinstance(direction, Scalar | Unknown):
        raise FieldError(
            Message("template.moves-along", kind=describe_kind(direction)),
            Message("template.a-direction"),
        )
    require_dimension(direction, NUMBER, "direction")


def check_condition(scope: Scope, condition: Condition) -> None:
    """A condition: two numbers of one dimension, made of what is known."""
    unite_dimensions(
        Quoted(condition.text),
        require_number(scope.kind(condition.left)),
        require_number(scope.kind(condition.right)),
    )


def check_ask(scope: Scope, ask: Ask) -> None:
    """An ask: a number of the dimension of its unit."""
    kind = scope.kind(ask.quantity)
    if not isinstance(kind, Scalar | Unknown):
        raise FieldError(
            describe_kind(kind), Message("template.a-number"), Message("template.of-a-vector")
        )
    require_unit(kind, ask.unit, list_units)
    for part in walk(ask.quantity):
        if isinstance(part, Operation) and part.sign in SUMS:
            require_no_number(scope, part.left, part.right)
            require_no_number(scope, part.right, part.left)
