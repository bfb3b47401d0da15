"""Typed sums, products and quotients with signs, brackets, roots and powers of ten are worth what
sympy makes of them, operator by operator from left to right.
"""

from __future__ import annotations

from math import isclose

import sympy
from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.grading.typed.answers import read

Term = tuple[str, str]  # as a student types it, and as sympy reads it

MINUS = st.sampled_from(["-", "−", "–"])
FACTORS = st.one_of(
    st.integers(1, 60).map(lambda number: (f"√{number}", f"sqrt({number})")),
    st.integers(2, 9).map(lambda number: (f"{number}√3", f"{number}*sqrt(3)")),
    st.just(("π", "pi")),
)
NUMBERS = st.integers(1, 99).map(lambda number: (f"{number}", f"{number}"))
POWERS = st.integers(-4, 6).map(lambda power: (f"10^{power}", f"10**{power}"))


@st.composite
def products(draw: st.DrawFn) -> Term:
    """A factor with a root or pi, perhaps divided, perhaps times a power of ten."""
    typed, meant = draw(FACTORS)
    if draw(st.booleans()):
        below = draw(st.integers(2, 12))
        typed, meant = f"{typed}/{below}", f"{meant}/{below}"
    if draw(st.booleans()):
        power, value = draw(POWERS)
        times = draw(st.sampled_from(["*", "·", "×", " · "]))
        typed, meant = f"{typed}{times}{power}", f"{meant}*{value}"
    return typed, meant


@st.composite
def sums(draw: st.DrawFn, inner: st.SearchStrategy[Term]) -> Term:
    """Two or three terms, the first perhaps with a sign."""
    typed, meant = draw(st.one_of(products(), NUMBERS))
    if draw(st.booleans()):
        typed, meant = f"{draw(MINUS)}{typed}", f"-{meant}"
    for _ in range(draw(st.integers(1, 2))):
        term, value = draw(inner)
        sign = draw(st.sampled_from(["+", "-"]))
        typed, meant = f"{typed}{sign}{term}", f"{meant}{sign}{value}"
    return typed, meant


@st.composite
def in_brackets(draw: st.DrawFn) -> Term:
    """A sum in brackets with a factor before it or a divisor behind it."""
    typed, meant = draw(sums(products()))
    factor, below = draw(st.integers(2, 9)), draw(st.integers(2, 9))
    ways = [
        (f"{factor}({typed})", f"{factor}*({meant})"),
        (f"({typed})/{below}", f"({meant})/{below}"),
        (f"√3·({typed})", f"sqrt(3)*({meant})"),
    ]
    return draw(st.sampled_from(ways))


@given(st.one_of(sums(products()), sums(in_brackets()), in_brackets()))
@example(("-1-20√3", "-1-20*sqrt(3)"))
@example(("5√3/2·10^3", "5*sqrt(3)/2*10**3"))
@example(("π/6*10^-2+√2", "pi/6*10**-2+sqrt(2)"))
def test_what_is_typed_is_worth_what_sympy_makes_of_it(term: Term) -> None:
    typed, meant = term
    found = read(typed, "m")
    assert found.value is not None, found.reason
    expected = float(sympy.sympify(meant, rational=True))
    assert isclose(float(found.value), expected, rel_tol=1e-9, abs_tol=1e-9)
