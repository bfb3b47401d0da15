"""The functions of quantities by name: what they take and give, and how they are worked out."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from typing import Any, Literal, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, walk
from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, Signature
from kinegrade.problem.quantities.measures import MEASURES
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader

QUANTITIES: Mapping[str, Signature] = {
    **CONSTRUCTIONS,
    **{name: function.signature for name, function in MOTION_FUNCTIONS.items()},
    **{name: measure.signature for name, measure in MEASURES.items()},
}


def make_quantities(
    motion: Motion, arithmetic: Arithmetic, names: Collection[str] = QUANTITIES
) -> dict[str, Callable[..., Any]]:
    """The functions of a motion and of its vectors by name, without those that need further
    configurations; of some `names` alone where others are not called.
    """
    reader = MotionReader(motion, arithmetic)
    read = {
        name: partial(function.read, reader)
        for name in names
        if (function := MOTION_FUNCTIONS.get(name)) and function.read is not None
    }
    measured = {
        name: partial(MEASURES[name].read, arithmetic) for name in names if name in MEASURES
    }
    return {**read, **measured}


def needs_configurations(tree: Expression) -> bool:
    """Whether an expression is read off further configurations, so not off one motion alone."""
    return any(MOTION_FUNCTIONS[call.function].read is None for call in find_motion_calls(tree))


def find_motion_calls(tree: Expression) -> Iterator[Call]:
    """The functions of the motion that are called in an expression, outer ones first."""
    return (
        part for part in walk(tree) if isinstance(part, Call) and part.function in MOTION_FUNCTIONS
    )


def find_coordinate(tree: Expression) -> tuple[Literal["x", "y"], str] | None:
    """The axis and the point of a coordinate, `x(B)`; None for anything else."""
    match tree:
        case Call("x" | "y" as axis, (Name(point),)):
            return axis, point
        case Call() | Name() | Number() | Operation():
            return None
        case _:
            assert_never(tree)
