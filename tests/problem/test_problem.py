"""A problem as a Python user meets it."""

from __future__ import annotations

import pytest

from kinegrade.choosing.choice import make_entry
from kinegrade.choosing.describing import describe_template
from kinegrade.errors import TemplateError
from kinegrade.public.problem import Problem, template
from tests.problem.crank import crank


def test_values_are_numbers_or_exact_texts_and_the_rest_takes_its_default() -> None:
    problem = Problem(crank())
    assert problem.solve(r=0.5, h="3/10")["v_y"].exact == "4/5"
    assert problem.solve(r=5, h=3, omega="sqrt(2)")["v_y"].exact == "4*sqrt(2)"
    solution = problem.solve(h="1/2")
    assert [quantity.exact for quantity in solution.parameters.values()] == ["1", "1/2", "2"]
    assert [answer.exact for answer in solution.answers.values()] == ["-1", "sqrt(3)"]


@pytest.mark.parametrize("value", [float("nan"), float("inf"), "", "r", "h/2"])
def test_what_is_no_number_is_refused(value: float | str) -> None:
    with pytest.raises(TemplateError, match="crank: h"):
        Problem(crank()).solve(h=value)


def test_a_description_tells_domains_points_and_conventions() -> None:
    text = describe_template(make_entry(crank()), "en")
    assert "1, 2 (2)" in text
    assert "0, 1/2, 3 (3)" in text
    assert "2 points" in text
    assert "on request" in text
    assert "曲柄的长度" in describe_template(make_entry(crank()), "zh")
    with pytest.raises(TemplateError, match="the parameter h is not given to the student"):
        describe_template(make_entry(crank(("{{ h.value }} above", "above"))), "en")


def test_a_negative_length_is_refused_and_a_negative_coordinate_is_not() -> None:
    with pytest.raises(
        TemplateError, match="slider-crank: r: a negative length: give zero or more"
    ):
        template("slider-crank").solve(r="-sqrt(2)")
    assert template("pole-sleeve-slider-rod").solve(x_B="-1/2")["x_S"].exact == "-1/2"


def test_a_parameter_named_like_a_word_of_python_is_refused_like_any_other() -> None:
    with pytest.raises(TemplateError, match='crank: no parameter "self": known here: h, omega, r'):
        Problem(crank()).solve(self=1)
