"""Expressions of templates as textbook formulas, with symbols or with an instance's numbers.

    l*sin(theta)*cos(psi)/sin(psi)     \\frac{l \\sin\\theta \\cos\\psi}{\\sin\\psi}
    x(A) + k*r*cos(phi + pi/2)         x_{A} + k\\,r \\cos(\\varphi + 90^\\circ)

A leaf is whatever stands as a symbol or a number; `Formulation` is given the leaves and takes
everything else apart: sums, fractions, roots, and where a minus sign belongs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import prod
from typing import assert_never

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, Expression, Name, Operation, is_literal_zero
from kinegrade.expressions.tree import Number as Literal
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.problem.quantity import is_short_decimal
from kinegrade.worked.formulas.atoms import ZERO, Number, add_terms, multiply_factors
from kinegrade.worked.formulas.formula import Absolute, Formula
from kinegrade.worked.formulas.functions import Function, FunctionName, Root
from kinegrade.worked.formulas.symbols import name_quantity
from kinegrade.worked.formulas.tuples import Tuple

_ONE = read_expression("1")
TRIGONOMETRY: Mapping[str, FunctionName] = {"sin": "sin", "cos": "cos", "tan": "tan"}
INVERSE: Mapping[str, FunctionName] = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}
STRUCTURAL = frozenset({*TRIGONOMETRY, *INVERSE, "sqrt", "abs"})
Leaf = Callable[[Expression, bool], Formula | None]


@dataclass(frozen=True)
class Formulation:
    """Makes formulas of expressions; `leaf` gives the formula for whatever stands whole, or None
    for an expression to be taken apart.

    `angular` says that the expression is an angle, to be stated in degrees.
    """

    leaf: Leaf

    def state(self, tree: Expression, angular: bool = False) -> Formula:
        """The formula of an expression."""
        found = self.leaf(tree, angular)
        return self._take_apart(tree, angular) if found is None else found

    def _take_apart(self, tree: Expression, angular: bool) -> Formula:
        """The formula of an expression that is no leaf."""
        match tree:
            case Literal():
                return _state_literal(tree)
            case Name(name):
                return name_quantity(name)
            case Call():
                return self._state_call(tree)
            case Operation():
                return self._state_operation(tree, angular)
            case _:
                assert_never(tree)

    def _state_operation(self, tree: Operation, angular: bool) -> Formula:
        """A power, a product or a quotient, a sum or a difference."""
        match tree.sign:
            case "**":
                return self.state(tree.left) ** self.state(tree.right)
            case "*" | "/":
                return self._state_product(tree, angular)
            case "+" | "-":
                terms = self._split_sum(tree, angular)
                return add_terms(term for term in terms if term.size != ZERO)
            case _:
                assert_never(tree.sign)

    def _list_terms(self, tree: Expression, angular: bool) -> Iterator[Formula]:
        """The terms of what may be a sum; brackets after a plus are dropped."""
        found = self.leaf(tree, angular)
        if found is not None:
            yield found
        elif isinstance(tree, Operation) and tree.sign in ("+", "-"):
            yield from self._split_sum(tree, angular)
        else:
            yield self._take_apart(tree, angular)

    def _split_sum(self, tree: Operation, angular: bool) -> Iterator[Formula]:
        """The terms of a sum or a difference; a unary minus belongs to the term after it."""
        yield from () if is_literal_zero(tree) else self._list_terms(tree.left, angular)
        if tree.sign == "+":
            yield from self._list_terms(tree.right, angular)
        else:
            yield -self.state(tree.right, angular)

    def _state_product(self, tree: Operation, angular: bool) -> Formula:
        """Factors side by side, over the divisors if there are any, with all signs in front."""
        above, below = self._split_product(tree, angular)
        formula = multiply_factors(factor.size for factor in above)
        if below:
            formula = formula / multiply_factors(factor.size for factor in below)
        return formula.signed(prod(factor.sign for factor in (*above, *below)))

    def _list_factors(self, tree: Expression, angular: bool) -> tuple[list[Formula], list[Formula]]:
        """The factors of the numerator and of the denominator."""
        found = self.leaf(tree, angular)
        if found is not None:
            return [found], []
        if not isinstance(tree, Operation):
            return [self._take_apart(tree, angular)], []
        return self._split_product(tree, angular)

    def _split_product(self, tree: Operation, angular: bool) -> tuple[list[Formula], list[Formula]]:
        """The same of an operation that is no leaf."""
        match tree.sign:
            case "-" if is_literal_zero(tree):
                (first, *more), below = self._list_factors(tree.right, angular)
                return [-first, *more], below
            case "+" | "-" | "**":
                return [self._take_apart(tree, angular)], []
            case "*":
                if tree.left == _ONE:
                    return self._list_factors(tree.right, angular)
                above, below = self._list_factors(tree.left, angular)
                more, under = self._list_factors(tree.right, angular)
                return above + more, below + under
            case "/":
                above, below = self._list_factors(tree.left, angular)
                more, under = self._list_factors(tree.right, angular)
                divisor = [self.state(tree.right, angular)] if under else more
                return above, below + divisor
            case _:
                assert_never(tree.sign)

    def _state_call(self, tree: Call) -> Formula:
        """A function of its arguments."""
        name = tree.function
        if name in TRIGONOMETRY:
            return Function(TRIGONOMETRY[name], self.state(tree.arguments[0], True))
        parts = tuple(self.state(part) for part in tree.arguments)
        if name in INVERSE:
            return Function(INVERSE[name], parts[0])
        if name == "sqrt" and len(parts) == 1:
            return Root(parts[0])
        if name == "abs" and len(parts) == 1:
            return Absolute(parts[0])
        return Tuple(parts, name)


def _state_literal(tree: Literal) -> Formula:
    """A number as it stands in a template: a short decimal, or a fraction."""
    size = abs(tree.value)
    if is_short_decimal(size):
        formula: Formula = Number(write_decimal(size, 12))
    else:
        formula = Number(str(size.p)) / Number(str(size.q))
    return -formula if tree.value < 0 else formula
