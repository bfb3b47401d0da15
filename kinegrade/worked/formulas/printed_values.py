"""What the numbers of a formula amount to as they are printed: what a reader gets who works it out
again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import reduce
from operator import mul

from kinegrade.worked.formulas.atoms import Exact, Measured, Number
from kinegrade.worked.formulas.formula import (
    Formula,
    Function,
    FunctionName,
    Negative,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
)

_FUNCTIONS: Mapping[FunctionName, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
}


def find_printed_value(formula: Formula) -> float:
    """The value of a formula in numbers, by the digits that are printed.

    >>> find_printed_value(Number("0.3333", rounded=True).dot(Number("3")))
    0.9999
    """
    match formula:
        case Number(digits):
            return float(digits)
        case Measured(number, unit):
            value = find_printed_value(number)
            return math.radians(value) if unit == "deg" else value
        case Exact(form):
            return find_printed_value(form)
        case Negative(inner):
            return -find_printed_value(inner)
        case Sum(terms):
            return sum(map(find_printed_value, terms))
        case Product(factors):
            return reduce(mul, map(find_printed_value, factors))
        case Quotient(above, below):
            return find_printed_value(above) / find_printed_value(below)
        case Power(base, exponent):
            return float(find_printed_value(base) ** find_printed_value(exponent))
        case Root(radicand):
            return math.sqrt(find_printed_value(radicand))
        case Function(name, argument):
            return _FUNCTIONS[name](find_printed_value(argument))
        case _:
            raise TypeError(f"{formula!r} is no number")
