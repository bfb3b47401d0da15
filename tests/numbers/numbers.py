"""Random exact numbers with their decimals, and exact numbers as decimals of 60 digits."""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq
from hypothesis import strategies as st
from mpmath import mp, mpf, sqrt

from kinegrade.numbers.surd import Surd, enclose

rationals = st.builds(fmpq, st.integers(-20, 20), st.integers(1, 9))
Recipe = Any


def towers() -> st.SearchStrategy[Recipe]:
    """Recipes of numbers: a rational, or two recipes under + - * /, or the root of a recipe's
    size.
    """
    leaves = st.one_of(rationals, st.sampled_from([2, 3, 5, 6]).map(lambda n: ("sqrt", fmpq(n))))
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.tuples(st.sampled_from("+-*/"), inner, inner), st.tuples(st.just("sqrt"), inner)
        ),
        max_leaves=4,
    )


def build(recipe: Recipe, field: Any) -> tuple[Any, Any]:
    """The number in a field, and its decimal; roots that would make the field too large are left
    out.
    """
    with mp.workdps(60):
        if not isinstance(recipe, tuple):
            return recipe, mpf(int(recipe.p)) / int(recipe.q)
        if recipe[0] == "sqrt":
            number, decimal = build(recipe[1], field)
            number, decimal = (-number, -decimal) if field.sign(number) < 0 else (number, decimal)
            return (
                (number, decimal)
                if len(field.roots) > 3
                else (field.sqrt(number), sqrt(max(decimal, 0)))
            )
        (a, x), (b, y) = build(recipe[1], field), build(recipe[2], field)
        if recipe[0] == "/" and b == 0:
            return a, x
        return {
            "+": (lambda: (a + b, x + y)),
            "-": (lambda: (a - b, x - y)),
            "*": (lambda: (a * b, x * y)),
            "/": (lambda: (a / b, x / y)),
        }[recipe[0]]()


def digits(number: Any) -> Any:
    """An exact number or a ball's midpoint as an mpf of 60 digits."""
    with mp.workdps(60):
        if isinstance(number, Surd):
            number = enclose(number, 320)
        if isinstance(number, arb):
            mantissa, exponent = number.mid().man_exp()
            return mpf(int(mantissa)) * mpf(2) ** int(exponent)
        return mpf(int(number.p)) / int(number.q)
