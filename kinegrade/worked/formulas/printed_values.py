"""What the numbers of a formula amount to as they are printed: what a reader gets who works it out
again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import reduce
from operator import mul

from kinegrade.worked.formulas.atoms import Exact, Measured, Number, Symbol
from kinegrade.worked.formulas.formula import Formula, Negative, Power, Product, Quotient, Sum
from kinegrade.worked.formulas.functions import Function, FunctionName, Root
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.symbols import PI

_FUNCTIONS: Mapping[FunctionName, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
}


def find_printed_value(formula: Formula, notation: Notation = PLAIN) -> float:
    """The value of a formula in numbers, by the digits that are printed.

    >>> find_printed_value(Number("0.3333", rounded=True).dot(Number("3")))
    0.9999
    """
    match formula:
        case Number():
            return float(formula.show(notation))
        case Measured(number, unit):
            value = find_printed_value(number, notation)
            return math.radians(value) if unit == "deg" else value
        case Exact(form):
            return find_printed_value(form, notation)
        case Negative(inner):
            return -find_printed_value(inner, notation)
        case Sum(terms):
            return sum(find_printed_value(one, notation) for one in terms)
        case Product(factors):
            return reduce(mul, (find_printed_value(one, notation) for one in factors))
        case Quotient(above, below):
            return find_printed_value(above, notation) / find_printed_value(below, notation)
        case Power(base, exponent):
            return _raise(*(find_printed_value(one, notation) for one in (base, exponent)))
        case Root(radicand):
            return math.sqrt(find_printed_value(radicand, notation))
        case Symbol() if formula == PI:
            return math.pi
        case Function(name, argument):
            return _FUNCTIONS[name](find_printed_value(argument, notation))
        case _:
            raise TypeError(f"{formula!r} is no number")


def _raise(base: float, exponent: float) -> float:
    """A power, infinite where it is too large for a double."""
    try:
        return float(base**exponent)
    except OverflowError:
        return math.inf
