"""Exact numbers: a field that grows by square roots, against 60 digits of mpmath and against known
values.
"""

from __future__ import annotations

from typing import Any

import pytest
import sympy
from flint import fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp, mpf

from kinegrade.numbers.elimination import Contradiction
from kinegrade.numbers.field import MAX_LEVEL, Field
from kinegrade.numbers.refusals import Inexact, NegativeRoot
from kinegrade.numbers.square_roots import split_radicand, split_square
from kinegrade.numbers.surd import Surd, height
from kinegrade.numbers.surd import sign as surd_sign
from kinegrade.numbers.text import write_exact
from tests.numbers.numbers import build, digits, rationals, towers

Q = fmpq


@given(st.data())
def test_sums_products_quotients_and_roots_are_what_mpmath_gives(data: st.DataObject) -> None:
    field = Field()
    recipe = data.draw(towers())
    number, decimal = build(recipe, field)
    with mp.workdps(60):
        assert abs(digits(number) - decimal) <= mpf(10) ** -40 * max(1, abs(decimal))


@given(towers(), towers(), towers())
def test_the_laws_of_a_field_hold(first: Any, second: Any, third: Any) -> None:
    field = Field()
    try:
        a, b, c = (build(recipe, field)[0] for recipe in (first, second, third))
    except Inexact:
        assume(False)
        raise
    assert a + b == b + a
    assert a * b == b * a
    assert (a + b) + c == a + (b + c)
    assert (a * b) * c == a * (b * c)
    assert a * (b + c) == a * b + a * c
    assert a - a == 0
    assert a + 0 == a
    assert a * 1 == a
    assert -a == 0 - a == a * -1
    if b != 0:
        assert a / b * b == a
        assert b / b == 1
        assert 1 / (1 / b) == b


@given(towers())
def test_a_number_is_equal_to_another_exactly_when_their_difference_vanishes(recipe: Any) -> None:
    field = Field()
    a = build(recipe, field)[0]
    b = a + Q(1, 10**30)
    assert a != b
    assert b - a == Q(1, 10**30)
    assert hash(a) == hash(b - Q(1, 10**30))
    assert field.sign(b - a) == 1
    assert field.sign(a - b) == -1
    assert field.sign(a - a) == 0


@given(towers(), towers())
def test_order_and_sign_are_those_of_the_decimals(first: Any, second: Any) -> None:
    field = Field()
    try:
        (a, x), (b, y) = build(first, field), build(second, field)
    except Inexact:
        assume(False)
        raise
    with mp.workdps(60):
        assume(a == b or abs(x - y) > mpf(10) ** -30)
        assert (a < b) == (a != b and x < y)
        assert (a >= b) == (a == b or x > y)
        assert field.sign(a) == (0 if a == 0 else 1 if x > 0 else -1)
        assert digits(abs(a)) >= 0


@given(towers())
def test_the_root_of_a_square_is_found_inside_the_field(recipe: Any) -> None:
    field = Field()
    a = build(recipe, field)[0]
    storeys = len(field.roots)
    assert field.sqrt(a * a) == abs(a)
    assert len(field.roots) == storeys


@given(towers(), st.integers(0, 7))
def test_whole_powers_are_repeated_products(recipe: Any, exponent: int) -> None:
    a = build(recipe, Field())[0]
    product: Any = Q(1)
    for _ in range(exponent):
        product = product * a
    assert a**exponent == product
    if a != 0:
        assert a**-exponent == 1 / product


@given(rationals, rationals, st.sampled_from([2, 3, 5, 6]), st.sampled_from([2, 3, 7]))
def test_sympy_agrees(a: Any, b: Any, first: int, second: int) -> None:
    field = Field()
    number = (
        (a + field.sqrt(Q(first)))
        * (b + field.sqrt(Q(second)))
        / (1 + field.sqrt(Q(first * second)))
    )
    peer = (
        (sympy.Rational(int(a.p), int(a.q)) + sympy.sqrt(first))
        * (sympy.Rational(int(b.p), int(b.q)) + sympy.sqrt(second))
        / (1 + sympy.sqrt(first * second))
    )
    assert abs(sympy.N(sympy.sympify(write_exact(number)) - peer, 50)) < sympy.Float("1e-40")


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (lambda f: f.sqrt(Q(12)), "2*sqrt(3)"),
        (lambda f: 2 / f.sqrt(Q(3)), "2*sqrt(3)/3"),
        (lambda f: f.sqrt(Q(9, 4)), "3/2"),
        (lambda f: f.sqrt(Q(2)) * f.sqrt(Q(8)), "4"),
        (lambda f: f.sqrt(Q(2)) * f.sqrt(Q(3)) - f.sqrt(Q(6)), "0"),
        (lambda f: f.sqrt(3 + 2 * f.sqrt(Q(2))), "1 + sqrt(2)"),  # (1 + sqrt 2)^2 = 3 + 2 sqrt 2
        (
            lambda f: f.sqrt(5 - 2 * f.sqrt(Q(6))),
            "sqrt(3) - sqrt(2)",
        ),  # (sqrt 3 - sqrt 2)^2 = 5 - 2 sqrt 6
        (lambda f: f.sqrt(2 + f.sqrt(Q(3))), "sqrt(2)/2 + sqrt(6)/2"),  # twice cos 15 degrees
        (lambda f: 1 / (1 + f.sqrt(Q(2)) + f.sqrt(Q(3))), "1/2 + sqrt(2)/4 - sqrt(6)/4"),
        (lambda f: f.cos(f.turns(Q(5, 12))), "sqrt(6)/4 - sqrt(2)/4"),  # cos 75 degrees
        (lambda f: f.sin(f.turns(Q(1, 10))), "sqrt(5)/4 - 1/4"),  # sin 18 degrees
        (
            lambda f: f.sqrt(4 - f.sin(f.turns(Q(5, 12))) ** 2),
            "sqrt(14 - sqrt(3))/2",
        ),  # the rod's reach at 75 degrees
        (lambda f: f.sqrt(Q(0)), "0"),
    ],
)
def test_known_numbers_print_as_in_a_book(given: Any, text: str) -> None:
    assert write_exact(given(Field())) == text


def test_sqrt_six_beside_sqrt_two_adds_sqrt_three_alone() -> None:
    field = Field()
    two, six = field.sqrt(Q(2)), field.sqrt(Q(6))
    assert len(field.roots) == 2
    assert field.sqrt(Q(3)) * two == six
    assert len(field.roots) == 2


def test_the_root_of_a_negative_number_is_refused() -> None:
    with pytest.raises(NegativeRoot):
        Field().sqrt(1 - Field().sqrt(Q(2)))


def test_a_field_of_more_than_five_storeys_is_left_to_balls() -> None:
    field = Field()
    for prime in (2, 3, 5, 7, 11)[:MAX_LEVEL]:
        field.sqrt(Q(prime))
    with pytest.raises(Inexact):
        field.sqrt(Q(13))
    assert field.sqrt(Q(2310)) ** 2 == 2310  # the product of the five is there already


def test_numbers_of_two_towers_are_not_mixed() -> None:
    with pytest.raises(ArithmeticError, match="two different fields"):
        Field().sqrt(Q(2)) + Field().sqrt(Q(3))


def test_a_fork_grows_alone_and_holds_the_same_numbers() -> None:
    field = Field()
    two = field.sqrt(Q(2))
    branch = field.fork()
    assert branch.sqrt(Q(3)) * two == branch.sqrt(Q(6))
    assert len(field.roots) == 1
    assert len(branch.roots) == 2


def test_numbers_lie_as_low_in_the_tower_as_they_can() -> None:
    field = Field()
    two, three = field.sqrt(Q(2)), field.sqrt(Q(3))
    product = (two + three) * (three - two)
    assert product == 1
    assert not isinstance(product, Surd)
    assert (two + three - three) == two
    assert height(two + Q(1, 1024)) == 11
    assert surd_sign(three - two - Q(3178, 10000)) == 1


def test_squares_are_drawn_out_of_the_radicand() -> None:
    assert split_square(2**4 * 3**3 * 1009**2) == (
        4 * 3,
        3 * 1009**2,
    )  # only squares of small primes are looked for
    assert split_square(1009**2) == (1009, 1)
    factor, radicand = split_radicand(Q(50, 27))  # sqrt(50/27) = 5/9 sqrt 6
    assert factor**2 * radicand == Q(50, 27)
    assert radicand == 6


def test_a_surplus_equation_must_hold_exactly() -> None:
    Field().require_zero(Q(0))
    with pytest.raises(Contradiction):
        Field().require_zero(Q(1, 10**50))


def test_the_turn_of_an_irrational_part_is_left_to_balls() -> None:
    with pytest.raises(Inexact):
        Field().turns(Field().sqrt(Q(2)))
    with pytest.raises(Inexact):
        Field().sin(Q(1))
    assert Field().sin(Q(0)) == 0
