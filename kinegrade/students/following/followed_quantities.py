"""How an ask is read off a motion into which a student's values are put, and which parts of the
motion it depends on.

`follow_through` uses it. A quantity can be put in where it describes a single moving thing: a body,
a point, a relative motion, a Coriolis or a normal part. The difference of the velocities of two
points of one body is the body's rotation.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from typing import Any, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, walk
from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS, read_normal
from kinegrade.problem.quantities.reader import MotionReader
from kinegrade.students.following.followed_terms import Share

_ROTATION = "rotation_velocity"


def make_functions(
    motion: Motion, arithmetic: Arithmetic, names: Collection[str]
) -> dict[str, Callable[..., Any]]:
    """The functions of a quantity, read off such a motion: those of these names."""
    reader = MotionReader(motion, arithmetic)

    def take_normal(place: Vector, base: Vector, body: Any) -> Vector:
        """The centripetal part of an acceleration, as it is taken."""
        turning, normal = make_turning(reader.body(body)), read_normal(reader, place, base, body)
        return motion.reading.normal(turning, reader.point(place), reader.point(base), normal)

    def rotation(place: Vector, base: Vector, body: Any) -> Vector:
        """Velocity of a point relative to a base point of the same body."""
        velocity: Vector = (place - base).turned() * motion.omega(reader.body(body))
        return velocity

    return {
        **make_quantities(motion, arithmetic, names),
        "normal_acceleration": take_normal,
        _ROTATION: rotation,
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
            return _find_rotation(tree, bodies) or Operation(
                sign, replace_differences(left, bodies), replace_differences(right, bodies)
            )
        case _:
            assert_never(tree)


def _find_rotation(tree: Operation, bodies: Sequence[Body]) -> Call | None:
    """The rotation of a body that a difference of two velocities is; None for anything else."""
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
    body = next(fitting, None)
    if body is None or len(points) != 2:
        return None
    return Call(_ROTATION, (left.arguments[0], right.arguments[0], Name(body)))


def find_calls(tree: Expression) -> Iterator[Call]:
    """The functions of the motion that are called in a tree, and the rotations in it."""
    return (
        part
        for part in walk(tree)
        if isinstance(part, Call)
        and (part.function in MOTION_FUNCTIONS or part.function == _ROTATION)
    )


def find_level(call: Call) -> Level | None:
    """Whether a call gives a velocity or an acceleration; None for a place."""
    if call.function == _ROTATION:
        return "velocity"
    return MOTION_FUNCTIONS[call.function].level


def find_share(call: Call) -> Share | None:
    """The share of the Coriolis or normal part that a call is of."""
    if call.function == _ROTATION:
        return None
    arguments = [find_name(argument) for argument in call.arguments]
    derivation = MOTION_FUNCTIONS[call.function].derivation
    match derivation:
        case "coriolis":
            return Share("coriolis", arguments[0], arguments[2])
        case "normal":
            return Share("normal", arguments[0], arguments[1])
        case "point" | "relative" | "tangential" | "rotation" | "pole" | "centrode" | "value":
            return None
        case _:
            assert_never(derivation)


def find_name(tree: Expression) -> str:
    """The name that a tree is, "" where it is none."""
    return tree.name if isinstance(tree, Name) else ""
