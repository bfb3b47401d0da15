"""How an ask is read off a motion into which a student's values are put, and which parts of the
motion it depends on.

`follow_through` uses it. A quantity can be put in where it describes a single moving thing: a body,
a point, a relative motion, a Coriolis or a normal part. The difference of the velocities of two
points of one body is the body's rotation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.expressions.expression import Call, Expression, Name, Number, Operation
from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.quantities import Quantities, make_quantities
from kinegrade.students.followed_terms import Share

_ROTATION = "rotation_velocity"
LEVELS: Mapping[str, Level] = {
    "velocity": "velocity",
    "omega": "velocity",
    "relative_velocity": "velocity",
    _ROTATION: "velocity",
    "acceleration": "acceleration",
    "alpha": "acceleration",
    "relative_acceleration": "acceleration",
    "tangential_acceleration": "acceleration",
    "coriolis": "acceleration",
    "normal_acceleration": "acceleration",
}
_MOTION = frozenset((*LEVELS, "pole", "circle_of_poles"))


@dataclass(frozen=True)
class _OwnQuantities(Quantities):
    """Reads quantities off a motion into which a student's values are put."""

    def normal(self, place: Vector, base: Vector, body: Any) -> Vector:
        """Centripetal part of the acceleration of a point relative to a base point of the same
        body, as it is taken.
        """
        turning, normal = make_turning(self.body(body)), super().normal(place, base, body)
        return self.motion.reading.normal(turning, self.point(place), self.point(base), normal)

    def rotation(self, place: Vector, base: Vector, body: Any) -> Vector:
        """Velocity of a point relative to a base point of the same body."""
        return (place - base).turned() * self.motion.omega(self.body(body))


def make_functions(motion: Motion, arithmetic: Arithmetic) -> dict[str, Callable[..., Any]]:
    """The functions of a quantity, read off such a motion."""
    reader = _OwnQuantities(motion, arithmetic)
    return {
        **make_quantities(motion, arithmetic),
        "normal_acceleration": reader.normal,
        _ROTATION: reader.rotation,
    }


def replace_differences(tree: Expression, bodies: Sequence[Body]) -> Expression:
    """The tree with each difference of the velocities of two points of one body written as the
    body's rotation.
    """
    match tree:
        case Call(function, arguments):
            return Call(function, tuple(replace_differences(part, bodies) for part in arguments))
        case Number() | Name():
            return tree
        case Operation(sign, left, right):
            body = _find_common_body(tree, bodies)
            if body:
                return Call(_ROTATION, (left.arguments[0], right.arguments[0], Name(body)))  # type: ignore[union-attr]
            return Operation(
                sign, replace_differences(left, bodies), replace_differences(right, bodies)
            )
        case _:
            assert_never(tree)


def _find_common_body(tree: Operation, bodies: Sequence[Body]) -> str | None:
    """The body of which a difference of two velocities is the rotation; None for anything else."""
    left, right = tree.left, tree.right
    if (
        tree.sign != "-"
        or not (isinstance(left, Call) and isinstance(right, Call))
        or {left.function, right.function} != {"velocity"}
    ):
        return None
    points = {find_name(call.arguments[0]) for call in (left, right)}
    said = {find_name(call.arguments[1]) for call in (left, right) if len(call.arguments) > 1}
    fitting = (body.name for body in bodies if points <= set(body.points) and said <= {body.name})
    return next(fitting, None) if len(points) == 2 else None


def find_motion_calls(tree: Expression) -> Iterator[Call]:
    """The functions of the motion that are called in a tree."""
    if isinstance(tree, Operation):
        yield from find_motion_calls(tree.left)
        yield from find_motion_calls(tree.right)
    elif isinstance(tree, Call):
        if tree.function in _MOTION:
            yield tree
        for part in tree.arguments:
            yield from find_motion_calls(part)


def find_share(call: Call) -> Share | None:
    """The share of the Coriolis or normal part that a call is of."""
    arguments = [find_name(argument) for argument in call.arguments]
    if call.function == "coriolis":
        return Share("coriolis", arguments[0], arguments[2])
    return (
        Share("normal", arguments[0], arguments[1])
        if call.function == "normal_acceleration"
        else None
    )


def find_name(tree: Expression) -> str:
    """The name that a tree is, "" where it is none."""
    return tree.name if isinstance(tree, Name) else ""
