"""Lengths and coordinates in the formula of an answer, with the letters of velocity poles."""

from __future__ import annotations

from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.symbols import collect_symbols, name_point
from kinegrade.worked.steps.poles import name_pole


def state_place(tree: Expression, case: Case) -> Formula:
    """A length, coordinate or constant in symbols, poles by their letters."""
    letters = {name: name_point(name) for name in case.findings.poles.values()}
    symbols = {**collect_symbols(case.template), **letters}
    points = (*case.motion.points, *letters)
    return formulate(symbols, points).state(_name_poles(tree, case))


def _name_poles(tree: Expression, case: Case) -> Expression:
    """The expression with every velocity pole as a named point."""
    match tree:
        case Call(function="pole", arguments=(Name(body), *_)):
            return Name(name_pole(body, case))
        case Call(function=function, arguments=arguments):
            return Call(function, tuple(_name_poles(argument, case) for argument in arguments))
        case Operation(sign=sign, left=left, right=right):
            return Operation(sign, _name_poles(left, case), _name_poles(right, case))
        case Number() | Name():
            return tree
        case _:
            assert_never(tree)
