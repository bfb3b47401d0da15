"""Whether a number is exact, or rounded numbers have been put into it."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.worked.formulas.atoms import Exact, Measured, Number
from kinegrade.worked.formulas.formula import Formula, Negative, Power, Product, Quotient, Sum
from kinegrade.worked.formulas.functions import Function, Root
from kinegrade.worked.formulas.symbols import PI

_NUMERIC = (Number, Measured, Exact, Negative, Sum, Product, Quotient, Power, Root, Function)


def is_exact(formula: Formula) -> bool:
    """Whether a formula is a number with roots and fractions, with or without a unit.

    >>> is_exact(Measured(Exact(Number("2")), "m")), is_exact(Number("2"))
    (True, False)
    """
    number = formula.number if isinstance(formula, Measured) else formula
    return isinstance(number.size, Exact)


def is_rounded(formula: Formula) -> bool:
    """Whether a number in a formula shows fewer digits than it has.

    >>> third = Number("0.3333", rounded=True)
    >>> is_rounded(Number("3") * third), is_rounded(Number("3") * Number("2"))
    (True, False)
    """
    return any(isinstance(part, Number) and part.rounded for part in list_parts(formula))


def is_numeric(formula: Formula) -> bool:
    """Whether a formula has a value: it holds no symbol but pi.

    >>> is_numeric(Number("3") * Number("2"))
    True
    """
    return all(isinstance(part, _NUMERIC) or part == PI for part in list_parts(formula))


def list_parts(formula: Formula) -> Iterator[Formula]:
    """A formula and all that it is made of."""
    yield formula
    for name in getattr(formula, "__match_args__", ()):  # the fields of a dataclass
        inner = getattr(formula, name)
        for part in inner if isinstance(inner, tuple) else (inner,):
            if isinstance(part, Formula):
                yield from list_parts(part)
