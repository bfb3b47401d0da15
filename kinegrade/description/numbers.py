"""Lengths that a template writes as plain numbers, in metres: a reader is told them with a unit,
that of the givens.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from operator import add, mul, sub, truediv
from typing import Any, assert_never

from kinegrade.expressions.tree import (
    Call,
    Expression,
    Mark,
    Name,
    Number,
    Operation,
    find_names,
)
from kinegrade.numbers.units import Unit
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, Slot
from kinegrade.problem.template.template import Template
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.positions.instance import METRE, Instance

_METRES = " m"  # ends names that no template may use: 3/20 m
_WORKED_OUT: Mapping[Mark, Callable[[Any, Any], Any]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
}
_PURE = frozenset({"sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "direction"})


@dataclass(frozen=True)
class NumberLengths:
    """The numbers of a template that are lengths, written in the `unit` of its givens."""

    template: Template

    @property
    def unit(self) -> Unit:
        """The unit in which most of the given lengths are printed; the metre where none is."""
        units = [each.unit for each in self.template.parameters.values() if each.unit.is_length]
        return Counter(units).most_common(1)[0][0] if units else METRE

    def name(self, tree: Expression) -> Expression:
        """A length, a vector or a shape with names in place of the numbers that are lengths."""
        value = _work_out(tree)
        if value is not None:
            return Name(f"{value}{_METRES}") if value else tree
        match tree:
            case Name() | Number():
                return tree
            case Operation():
                return self._name_in_operation(tree)
            case Call():
                return self.name_in_call(tree)
            case _:
                assert_never(tree)

    def name_in_call(self, tree: Call) -> Call:
        """The same of a construction."""
        if tree.function in _PURE or tree.function not in CONSTRUCTIONS:
            return tree
        slots = CONSTRUCTIONS[tree.function].slots
        return Call(tree.function, tuple(map(self._name_in_slot, tree.arguments, slots)))

    def tell(self, instance: Instance, tree: Expression) -> Instance:
        """The instance with those names of a tree, and how they are printed."""
        names = {*find_names(self.name(tree))}
        for name in sorted(each for each in names if each.endswith(_METRES)):
            above, below = map(instance.arithmetic.number, _read_name(name))
            value = above / below
            written = state_quantity(instance.quantity(value, self.unit))[0].right
            symbol = Symbol(written.print(instance.case.notation))
            instance = instance.named(name, symbol, value)
        return instance

    def _name_in_slot(self, tree: Expression, slot: Slot) -> Expression:
        match slot:
            case "ANGLE" | "RATIO" | "SIDE" | "POINT" | "BODY" | "PARAMETER":
                return tree
            case "PLACE|ANGLE" if not self._has_lengths(tree):
                return tree
            case _:
                return self.name(tree)

    def _name_in_operation(self, tree: Operation) -> Expression:
        """In all terms of a sum, in that factor of a product which is the length."""
        match tree.sign:
            case "+" | "-":
                return Operation(tree.sign, self.name(tree.left), self.name(tree.right))
            case "*" if self._is_factor(tree.left, tree.right):
                return Operation("*", tree.left, self.name(tree.right))
            case "*" | "/":
                return Operation(tree.sign, self.name(tree.left), tree.right)
            case "**":
                return tree
            case _:
                assert_never(tree.sign)

    def _is_factor(self, left: Expression, right: Expression) -> bool:
        """Whether what stands on the right of a product is its length."""
        if self._has_lengths(left):
            return False
        if _is_unit_vector(right) and _has_number(left):
            return False
        return self._has_lengths(right) or _work_out(left) is None

    def _has_lengths(self, tree: Expression) -> bool:
        """Whether a point or a given length is named, so that numbers beside it are factors."""
        scheme = self.template.scheme
        lengths = {name for name, given in scheme.parameters.items() if given.unit.is_length}
        named = {*scheme.points, *scheme.lengths, *lengths}
        return not named.isdisjoint(find_names(tree))


def _work_out(tree: Expression) -> Any:
    """The number that a tree of numbers is, None of any other."""
    match tree:
        case Number(value=value):
            return value
        case Operation(sign="+" | "-" | "*" | "/" as sign, left=left, right=right):
            numbers = _work_out(left), _work_out(right)
            return None if None in numbers else _WORKED_OUT[sign](*numbers)
        case Operation() | Name() | Call():
            return None
        case _:
            assert_never(tree)


def _is_unit_vector(tree: Expression) -> bool:
    """Whether a tree is a direction: (1, 0), (cos(phi), sin(phi))."""
    match tree:
        case Call(function="", arguments=parts):
            return not any(map(_has_number, parts))
        case Call() | Name() | Number() | Operation():
            return False
        case _:
            assert_never(tree)


def _has_number(tree: Expression) -> bool:
    """Whether a factor of a tree is a number other than 0, 1 and -1, and so may be its length."""
    match tree:
        case Number(value=value):
            return not (value == 0 or value * value == 1)
        case Operation(left=left, right=right):
            return _has_number(left) or _has_number(right)
        case Name() | Call():
            return False
        case _:
            assert_never(tree)


def _read_name(name: str) -> tuple[int, int]:
    """The numerator and the denominator of a number that has a name."""
    number = Fraction(name.removesuffix(_METRES))
    return number.numerator, number.denominator
