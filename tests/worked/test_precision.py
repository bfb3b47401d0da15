"""Where digits are lost further down, all numbers of a page print with more of them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Prose
from kinegrade.worked.formulas.equation import Equation, approximate, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import Notation
from kinegrade.worked.formulas.numbers import measure, round_number, state_angle
from kinegrade.worked.formulas.precision import find_more_digits
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.solution import write_worked_solution
from tests.problem.draws import draw_filter, drawn
from tests.prove.draws import seeded_solution
from tests.worked.draws import stated
from tests.worked.telling import displayed, proses
from tests.worked.test_checks import find_checks

NEAR, FAR = 0.720568, 0.712546


def say(numbers: Formula, value: float) -> Equation:
    return Equation(read_symbol("s"), (*equate(numbers), *approximate(measure(value, "m"))))


def test_a_difference_that_is_small_takes_more_digits() -> None:
    difference = say(measure(NEAR, "m") - measure(FAR, "m"), NEAR - FAR)
    assert find_more_digits([difference]) == 2


def test_a_result_that_its_numbers_give_to_four_digits_takes_no_more() -> None:
    product = say(measure(NEAR / 3, "m").dot(measure(3, "m")), NEAR)
    assert find_more_digits([product]) == 0


def test_digits_beyond_the_fourth_need_not_be_those_of_printed_numbers() -> None:
    product = say(measure(NEAR / 3, "m").dot(measure(3, "m")), NEAR)
    difference = say(measure(NEAR, "m") - measure(0.7, "m"), NEAR - 0.7)
    assert find_more_digits([product, difference]) == 1


def test_a_result_told_in_another_unit_too_takes_no_more() -> None:
    """1.571 m/s beside 157.1 cm/s was taken for a loss, and all numbers had seven digits."""
    product = say(measure(NEAR / 3, "m").dot(measure(3, "m")), NEAR)
    told_twice = replace(product, links=(*product.links, *approximate(measure(100 * NEAR, "cm"))))
    assert find_more_digits([told_twice]) == 0


def test_an_angle_is_compared_in_degrees() -> None:
    turned = state_angle(20.123) + state_angle(30.456)
    assert find_more_digits([Equation(turned, approximate(state_angle(50.579)))]) == 0


@pytest.mark.parametrize(
    ("number", "shown"), [(-0.498934567, "-0.498935"), (12345.678, "12346"), (9.99999, "10.0000")]
)
def test_digits_are_counted_from_the_first(number: float, shown: str) -> None:
    more = 1 if number > 10 else 2
    assert round_number(number).show(Notation(more_digits=more)) == shown


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


def test_an_arctangent_of_few_decimals_is_not_about_its_value() -> None:
    """Half of 75 degrees, found by a ratio of sides."""
    told = displayed(stated("bar-pushing-rolling-disc", phi="75"))
    assert r"\psi_{O_{1}C} &= 37.5^\circ" in told


@pytest.mark.parametrize("seed", [50, 51])  # a rod on a disc, and one on an incline
def test_a_check_takes_no_more_digits_than_the_page_has_without_it(seed: int) -> None:
    """Where its terms nearly cancel, all numbers of the page had five to seven digits. It says as
    many as both sides give, and they agree.
    """
    solution = seeded_solution(seed)
    blocks = write_worked_solution(solution, solution.template.asked(), "en").blocks
    assert "4 significant" in " ".join(each.text for each in blocks if isinstance(each, Prose))
    checks = find_checks(blocks)
    assert checks
    assert [check for check in checks if not check.agrees] == []


def test_a_check_with_fewer_digits_than_its_page_says_with_how_many() -> None:
    """The page said four digits, and the check had three."""
    template = load_template("slider-crank-relative-rotation-driver")
    solution = drawn(draw_filter(template, "w2-en"), 1)[0].solution
    told = " ".join(proses(write_worked_solution(solution, template.asked(), "en").blocks))
    assert "4 significant digits (any" in told
    [check] = [each for each in told.split("Check by ") if r"-0.593\,\unit{m^2/s}" in each]
    assert "they agree to 3 significant digits." in check
