"""Vectors in the sentences of a worked solution: an arrow, a multiple of one, a pair, or a rotated
vector.
"""

from __future__ import annotations

from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.message import Message, Text
from kinegrade.worked.formulas.formula import Quotient
from kinegrade.worked.positions.algebra import ZERO, is_negated, minus
from kinegrade.worked.positions.instance import Instance


def negate(vector: Expression, instance: Instance) -> Expression:
    """The opposite of a vector; that of a pair and of a difference of points is worked out."""
    pair = instance.axes.pair(vector) if isinstance(vector, Call) and not vector.function else None
    if pair is not None:
        return Call("", (minus(ZERO, pair[0]), minus(ZERO, pair[1])))
    return minus(ZERO, vector)


def write_way(start: Expression, end: Expression, instance: Instance) -> Expression:
    """The vector from one point to another; a vector that is added to the first point is itself the
    result.
    """
    match end:
        case Operation(sign="+", left=same, right=added) if same == start:
            return added
        case Operation(sign="-", left=same, right=taken) if same == start:
            return negate(taken, instance)
        case Number() | Name() | Operation() | Call():
            return Operation("-", end, start)
        case _:
            assert_never(end)


def describe_vector(vector: Expression, instance: Instance) -> Text:
    """A vector in a sentence."""
    if isinstance(vector, Call) and vector.function == "turned":
        turned = describe_vector(vector.arguments[0], instance)
        return Message("solution.displacement-turned", vector=turned)
    if (
        isinstance(vector, Operation)
        and vector.sign == "*"
        and instance.axes.is_vector(vector.left)
    ):
        factor = instance.formula(vector.right)
        if isinstance(factor, Quotient):
            scaled = factor * instance.formula(vector.left)
            return f"${instance.case.text(scaled)}$"
        vector = Operation("*", vector.right, vector.left)
    pair = instance.axes.pair(vector)
    if pair is not None and not _is_plain(vector, instance):
        vector = Call("", pair)
    return f"${instance.text(vector)}$"


def _is_plain(vector: Expression, instance: Instance) -> bool:
    """Whether a vector is printed unchanged: a pair, the vector from point to point, or a multiple
    of one.
    """
    match vector:
        case Call(function=""):
            return True
        case Operation(sign="-", left=Name(), right=Name()):
            return True
        case Operation(sign="*" | "/" | "-", left=left, right=right):
            scalar, other = (left, right) if instance.axes.is_vector(right) else (right, left)
            return (
                not instance.axes.is_vector(scalar)
                and (vector.sign != "-" or is_negated(vector))
                and _is_plain(other, instance)
            )
        case Number() | Name() | Operation() | Call():
            return False
        case _:
            assert_never(vector)
