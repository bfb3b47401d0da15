"""The SI unit of a part of the quantity that is asked, by which its number is printed."""

from __future__ import annotations

from fractions import Fraction
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.problem.kinds.dimension import LENGTH, NUMBER, Dimension, find_dimension
from kinegrade.problem.kinds.kinds import Arrow, Scalar
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Template

_OF_ARGUMENT = frozenset({"magnitude", "x", "y", "along", "abs"})
_ANGULAR = frozenset({"angle", "between", "direction", "sin", "cos", "tan"})


def find_unit(tree: Expression, template: Template) -> str:
    """The unit of an expression whose dimensions have been checked: "m", "rad/s", "1"."""
    return _measure(tree, template).unit


def _measure(tree: Expression, template: Template) -> Dimension:
    """The dimension of an expression."""
    match tree:
        case Number():
            return NUMBER
        case Name(name):
            return _measure_named(name, template)
        case Operation():
            return _measure_operation(tree, template)
        case Call():
            return _measure_call(tree, template)
        case _:
            assert_never(tree)


def _measure_named(name: str, template: Template) -> Dimension:
    """The dimension of a given, of a step, or of a named length."""
    given, steps = template.parameters.get(name), template.scheme.steps
    if name == "pi":
        return NUMBER
    if given is not None:
        return find_dimension(given.unit)
    return _measure(steps[name], template) if name in steps else LENGTH


def _measure_operation(tree: Operation, template: Template) -> Dimension:
    """The dimension of a sum, a product, a quotient or a power; a unary minus has a zero before
    it.
    """
    left, right = (_measure(side, template) for side in (tree.left, tree.right))
    match tree.sign:
        case "*":
            return left * right
        case "/":
            return left / right
        case "+" | "-":
            return right if left == NUMBER else left
        case "**":
            return left ** _count(tree.right)
        case _:
            assert_never(tree.sign)


def _count(exponent: Expression) -> Fraction:
    """A written exponent as a number; of any other that of a pure number, which stays one."""
    match exponent:
        case Number(value=value):
            return Fraction(int(value.p), int(value.q))
        case Name() | Call() | Operation():
            return Fraction(1)
        case _:
            assert_never(exponent)


def _measure_call(tree: Call, template: Template) -> Dimension:
    """The dimension of what a function gives: of its vector, of the motion, else a length."""
    if tree.function in MOTION_FUNCTIONS:
        gives = MOTION_FUNCTIONS[tree.function].gives
        return (gives.dimension if isinstance(gives, Scalar | Arrow) else None) or LENGTH
    if tree.function in _OF_ARGUMENT:
        return _measure(tree.arguments[0], template)
    if tree.function == "sqrt":
        return _measure(tree.arguments[0], template) ** Fraction(1, 2)
    return NUMBER if tree.function in _ANGULAR else LENGTH
