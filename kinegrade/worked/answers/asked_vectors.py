"""The vectors that an answer refers to, each found before it is used: of points, relative,
Coriolis, about a base point.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, list_parts
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.kinds.kinds import Arrow
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.worked.answers.point_vectors import Found, explain_point_vector, keep_fact
from kinegrade.worked.answers.relative_vectors import (
    explain_coriolis,
    explain_normal,
    explain_relative,
    explain_tangential,
)
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.vectors.components import add_components
from kinegrade.worked.vectors.relatives import Relative


def is_vector_call(tree: Expression) -> bool:
    """Whether an expression is a vector of the motion: a velocity or an acceleration, or a sum of
    such.
    """
    if isinstance(tree, Operation) and tree.sign in "+-":
        return is_vector_call(tree.right)
    if not isinstance(tree, Call) or tree.function not in MOTION_FUNCTIONS:
        return False
    function = MOTION_FUNCTIONS[tree.function]
    return function.level is not None and isinstance(function.gives, Arrow)


def is_rotation_call(tree: Call) -> bool:
    """Whether a call gives an angular velocity or acceleration."""
    function = tree.function
    return function in MOTION_FUNCTIONS and MOTION_FUNCTIONS[function].derivation == "rotation"


def find_fact(tree: Expression, case: Case) -> Fact:
    """A vector that the solution has already found."""
    for _ in explain_vector(tree, case):
        pass
    return case.findings.answered[tree]


def explain_vector(tree: Expression, case: Case) -> Found:
    """The vector of an expression, with the blocks that show how it is found unless they have been
    written before.
    """
    return (yield from keep_fact(tree, _find_vector(tree, case), case))


def _find_vector(tree: Expression, case: Case) -> Found:
    match tree:
        case Operation():
            return (yield from _explain_difference(tree, case))
        case Call():
            return (yield from _find_called(tree, case))
        case Number() | Name():
            raise TypeError("a number or a name is not a vector of the motion")
        case _:
            assert_never(tree)


def _find_called(tree: Call, case: Case) -> Found:
    """The vector that a function of the motion gives."""
    names = [argument.name for argument in tree.arguments if isinstance(argument, Name)]
    derivation, level = MOTION_FUNCTIONS[tree.function].derivation, find_level(tree)
    match derivation:
        case "point":
            body = names[1] if len(names) > 1 else case.reader.owner(names[0], None)
            return (yield from explain_point_vector(names[0], body, level, case))
        case "relative":
            return (yield from explain_relative(Relative(*names), level, case))
        case "coriolis":
            return (yield from explain_coriolis(Relative(*names), case))
        case "normal":
            return (yield from explain_normal(names[0], names[1], names[2], case))
        case "tangential":
            return (yield from explain_tangential(names[0], names[1], names[2], case))
        case "rotation" | "pole" | "centrode" | "value":
            raise TypeError(f"{tree.function} is not derived as a vector of the motion")
        case _:
            assert_never(derivation)


def _explain_difference(tree: Operation, case: Case) -> Found:
    """The sum or difference of two vectors, by components."""
    left = yield from explain_vector(tree.left, case)
    right = yield from explain_vector(tree.right, case)
    match tree.sign:
        case "+" | "-" as sign:
            value = {"+": left.value + right.value, "-": left.value - right.value}[sign]
        case "*" | "/" | "**":
            raise TypeError(
                "only sums and differences of vectors of the motion are vectors of the motion"
            )
        case _:
            assert_never(tree.sign)
    name = replace(left.symbol, lower=(*left.symbol.lower, *right.symbol.lower))
    yield case.show(*(add_components(axis, name, (left, right), case, sign) for axis in AXES))
    return Fact(name, value, True)


def find_level(tree: Expression) -> Level:
    """Whether a vector of the motion is a velocity or an acceleration; a sum is what its last
    summand is.
    """
    match tree:
        case Call(function=function):
            level = MOTION_FUNCTIONS[function].level
            if level is None:
                raise TypeError(f"{function} is neither a velocity nor an acceleration")
            return level
        case Operation(right=right):
            return find_level(right)
        case Number() | Name():
            raise TypeError("a number or a name is not a vector of the motion")
        case _:
            assert_never(tree)


def explain_prerequisites(tree: Expression, case: Case) -> Iterator[Block]:
    """How every vector in an expression is found."""
    if is_vector_call(tree):
        yield from explain_vector(tree, case)
        return
    for part in list_parts(tree):
        yield from explain_prerequisites(part, case)
