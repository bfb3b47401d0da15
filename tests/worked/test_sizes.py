"""Sizes and roots of what moves, as an author asks for them, in worked solutions."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.solution import write_worked_solution
from tests.worked.telling import displayed

SLIDER = load_template("slider-crank").file.text


def state_asked(quantity: str, unit: str) -> str:
    """The last line of the worked solution of the slider-crank of which this alone is asked."""
    ask = f'd = {{ quantity = "{quantity}", unit = "{unit}", sign = "magnitude", means = "size" }}'
    template = read_template("asked", SLIDER.replace("[asks]\n", f"[asks]\n{ask}\n"))
    solution = solve_template(template, {"alpha": "2"})
    return displayed(write_worked_solution(solution, ["d"], "en").blocks)[-1]


@pytest.mark.parametrize(
    ("quantity", "unit", "formula"),
    [
        ("abs(omega(AB))", "rad/s", r"\left|\omega_{AB}\right|"),
        ("abs(x(acceleration(B)))", "m/s^2", r"\left|a_{B}\right|"),
        ("sqrt(omega(AB)**2)", "rad/s", r"\sqrt{\omega_{AB}^{2}}"),
        (
            "magnitude(velocity(A))**2/abs(along(acceleration(A), turned(velocity(A))))",
            "m",
            r"\frac{v_{A}^{2}}",
        ),
    ],
)
def test_a_size_is_that_of_what_the_page_has_found(quantity: str, unit: str, formula: str) -> None:
    """The page had the code of the template: |along(acceleration(A), turned(velocity(A)))|."""
    line = state_asked(quantity, unit)
    assert formula in line
    assert "acceleration" not in line
    assert "omega(" not in line
