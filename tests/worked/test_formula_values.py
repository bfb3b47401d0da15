"""Formulas are values: what is printed of them reads back as the same value, with signs and
brackets as a textbook sets them.
"""

from __future__ import annotations

import math
import operator
from functools import reduce

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.case import write_row
from kinegrade.worked.formulas.atoms import Exact, Measured, Number, Symbol, add_squares
from kinegrade.worked.formulas.equation import Equation, approximate, drop_repetition, equate
from kinegrade.worked.formulas.formula import (
    Absolute,
    Formula,
    Negative,
    Power,
    Product,
    Quotient,
    Sum,
)
from kinegrade.worked.formulas.functions import Function, Root
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.numbers import round_number
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.solution import write_worked_solution
from tests.worked.latex_value import value_of
from tests.worked.telling import displayed, tidy

A, B, C = (read_symbol(letter) for letter in ("v_{1}", "v_{2}", "v_{3}"))
VALUES = {"v_{1}": 0.7, "v_{2}": 1.3, "v_{3}": 2.1}
TWO, MINUS_TWO = Number("2"), Number("-2")


def shown(formula: Formula, mark: str = ".") -> str:
    return write_row(formula.print(Notation(mark)))


def value(formula: Formula) -> float:
    """The value of a formula by what it says, not by how it is printed."""
    match formula:
        case Number(digits):
            return float(digits)
        case Symbol():
            return VALUES[shown(formula)]
        case Negative(inner):
            return -value(inner)
        case Exact(form):
            return value(form)
        case Sum(terms):
            return sum(map(value, terms))
        case Product(factors):
            return math.prod(map(value, factors))
        case Quotient(above, below):
            return value(above) / value(below)
        case Power(base, exponent):
            return float(value(base) ** value(exponent))
        case Root(radicand):
            return math.sqrt(value(radicand))
        case Absolute(inner):
            return abs(value(inner))
        case Function(name, argument):
            return float(getattr(math, name)(value(argument)))
    raise AssertionError(formula)


ATOMS = st.sampled_from([A, B, C, TWO, MINUS_TWO, Number("0.5"), Number("1"), Number("-1.5")])
FORMULAS = st.recursive(
    ATOMS,
    lambda inner: (
        st.builds(operator.neg, inner)
        | st.builds(lambda first, second: first + second, inner, inner)
        | st.builds(lambda first, second: first - second, inner, inner)
        | st.builds(lambda first, second: first * second, inner, inner)
        | st.builds(lambda first, second: first.dot(second), inner, inner)
        | st.builds(lambda first, second: first / second, inner, inner)
        | st.builds(lambda base: base**TWO, inner)
        | st.builds(Exact, inner)
        | st.builds(Absolute, inner)
        | st.builds(lambda argument: Function("cos", argument), inner)
    ),
    max_leaves=9,
)


def measurable(formula: Formula) -> float:
    try:
        found = value(formula)
    except (ArithmeticError, ValueError):
        assume(False)
        raise
    assume(math.isfinite(found) and abs(found) < 1e6)
    return found


@given(FORMULAS)
def test_what_is_printed_reads_back_as_the_same_value(formula: Formula) -> None:
    found = measurable(formula)
    assert value_of(shown(formula), VALUES) == pytest.approx(found, rel=1e-6, abs=1e-6)


@given(FORMULAS)
def test_a_formula_and_its_opposite_add_to_nothing(formula: Formula) -> None:
    found = measurable(formula)
    opposite = -formula
    assert value_of(shown(opposite), VALUES) == pytest.approx(-found, rel=1e-6, abs=1e-6)
    assert (-opposite).looks_like(formula)


@given(FORMULAS)
def test_a_sign_and_a_size_make_the_formula(formula: Formula) -> None:
    found = measurable(formula)
    assert formula.sign * value(formula.size) == pytest.approx(found)


@given(FORMULAS, FORMULAS)
def test_no_two_signs_stand_side_by_side(first: Formula, second: Formula) -> None:
    for formula in (first + second, first - second, first * second, -first):
        text = shown(formula).replace(" ", "")
        assert [pair for pair in ("--", "+-", "-+", "\\cdot-") if pair in text] == []


@pytest.mark.parametrize(
    ("formula", "latex"),
    [
        (A * (B - C), "v_{1}(v_{2} - v_{3})"),
        (TWO * A * Absolute(B), r"2 v_{1}\left|v_{2}\right|"),
        (A * (B - C) * (B + C), r"v_{1}(v_{2} - v_{3})\,(v_{2} + v_{3})"),
        (A - (B + C), "v_{1} - (v_{2} + v_{3})"),
        (A + (B - C), "v_{1} + v_{2} - v_{3}"),
        (A - (-B), "v_{1} + v_{2}"),
        (-Negative(A), "v_{1}"),
        (Function("cos", MINUS_TWO**TWO), r"\cos((-2)^{2})"),
        (-MINUS_TWO, "-(-2)"),
        (A + MINUS_TWO, "v_{1} + (-2)"),
        (A * -B, r"v_{1}(-v_{2})"),
        (MINUS_TWO.dot(Number("-1.5")), r"-2 \cdot (-1.5)"),
        (A - MINUS_TWO.dot(B), r"v_{1} - (-2) \cdot v_{2}"),
        ((A + B) * C, r"(v_{1} + v_{2})\,v_{3}"),
        ((A + B) / (A - B), r"\frac{v_{1} + v_{2}}{v_{1} - v_{2}}"),
        (A / B / C, r"\frac{\frac{v_{1}}{v_{2}}}{v_{3}}"),
        ((A / B) ** TWO, r"\left(\frac{v_{1}}{v_{2}}\right)^{2}"),
        (MINUS_TWO**TWO, "(-2)^{2}"),
        (add_squares((A, MINUS_TWO)), r"\sqrt{v_{1}^{2} + (-2)^{2}}"),
        (Function("cos", -A), r"\cos(-v_{1})"),
        (A * Function("cos", Measured(Number("30"), "deg")), r"v_{1}\cos 30^\circ"),
        (Number("1.5e-8"), r"1.5 \cdot 10^{-8}"),
        (Measured(A + B, "m"), r"(v_{1} + v_{2})\,\unit{m}"),
    ],
)
def test_signs_and_brackets_stand_as_in_a_textbook(formula: Formula, latex: str) -> None:
    assert shown(formula) == tidy(latex)


def test_decimals_have_the_mark_of_their_language() -> None:
    assert shown(Number("-0.25") + Number("1.5"), ",") == "-0{,}25 + 1{,}5"


def test_an_exact_value_and_its_decimal_stay_on_one_line() -> None:
    long = reduce(lambda total, term: total + term, [A] * 30)
    value = (*equate(Root(TWO) / TWO), *approximate(Number("0.7071")))
    lines = Equation(A, (*equate(long), *value)).break_lines(PLAIN)
    assert [write_row(line) for line in lines][1:] == [
        tidy(r"&= \frac{\sqrt{2}}{2} \approx 0.7071")
    ]


def test_a_number_is_not_said_again_with_its_unit_alone() -> None:
    value = equate(Measured(Number("-0.3"), "m"))
    assert drop_repetition(equate(-A, -Number("0.3")), value) == (*equate(-A), *value)


def test_a_small_double_is_printed_with_digits_and_no_letter_e() -> None:
    assert round_number(0.00005) == Number("0.00005")
    assert round_number(12345.6) == Number("12350")


def test_a_coordinate_of_the_pole_is_given_once() -> None:
    template = load_template("crank-slider-in-floating-link")
    blocks = write_worked_solution(solve_template(template, {}), template.asks, "en").blocks
    assert not [line for line in displayed(blocks) if line.startswith("x_{P} & = x_{P} =")]
    assert len([line for line in displayed(blocks) if line.startswith("x_{P} &")]) == 1


def test_a_numbered_pole_has_its_number_below() -> None:
    template = load_template("stone-crusher")
    blocks = write_worked_solution(solve_template(template, {}), template.asks, "en").blocks
    assert "C_{1}E" in "\n".join(displayed(blocks))
    assert [line for line in displayed(blocks) if "C1" in line] == []
