"""Numbers that lose digits further down print with more of them, and those that lead to them."""

from __future__ import annotations

from kinegrade.worked.formulas.equation import Equation, approximate, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import measure, state_angle
from kinegrade.worked.formulas.precision import find_finer
from kinegrade.worked.formulas.symbols import read_symbol
from tests.worked.draws import stated
from tests.worked.telling import displayed

NEAR, FAR = 0.720568, 0.712546


def say(numbers: Formula, value: float) -> Equation:
    return Equation(read_symbol("s"), (*equate(numbers), *approximate(measure(value, "m"))))


def test_both_numbers_of_a_difference_that_is_small_have_another_digit() -> None:
    difference = say(measure(NEAR, "m") - measure(FAR, "m"), NEAR - FAR)
    assert dict(find_finer([difference])) == {"0.720568": 2, "0.712546": 2}


def test_what_leads_to_a_finer_number_is_finer_too() -> None:
    difference = say(measure(NEAR, "m") - measure(0.7, "m"), NEAR - 0.7)
    before = say(measure(NEAR / 3, "m").dot(measure(3, "m")), NEAR)
    assert find_finer([before]) == {}
    assert set(find_finer([before, difference])) == {"0.720568", "0.240189333"}


def test_an_angle_is_compared_in_degrees() -> None:
    turned = state_angle(20.123) + state_angle(30.456)
    assert find_finer([Equation(turned, approximate(state_angle(50.579)))]) == {}


def test_rounded_numbers_that_miss_zero_stand_before_zero() -> None:
    """They were left out: why v_{C,x} vanishes had no numbers. They stand for all their digits, and
    the sum is 0, not about 0.
    """
    page = displayed(stated("rod-sliding-on-driven-wheel"))
    (line,) = (one for one in page if one.startswith("v_{B,y}"))
    assert line.startswith(r"v_{B,y} &= -v_{A}\cos\beta + \omega_{AB}\,x_{B} = ")
    assert line.endswith(r"\cdot (-0.4\,\unit{m}) = 0")


def test_the_opposite_of_a_coordinate_has_its_square() -> None:
    (line,) = (
        one
        for one in displayed(stated("guide-tube-rod-fixed-centrode"))
        if one.startswith("AS &= ") and "sqrt" in one
    )
    assert line.startswith(r"AS &= \sqrt{x_{S}^{2} + y_{S}^{2}} = \sqrt{(-0.05\,\unit{m})^{2} + ")
