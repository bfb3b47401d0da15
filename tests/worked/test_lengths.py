"""Printed solutions are short: a sample of what `make prove` holds for every template."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kinegrade.exam.printing.pages import QuestionPlace
from kinegrade.exam.printing.solution_pages import work_question
from kinegrade.figure.sketch import sketch
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.figure.clear import symbols
from tests.worked.lengths import measure_length


@pytest.mark.parametrize(
    ("name", "language"),
    [
        ("slider-crank", "en"),
        ("five-bar-two-driven-cranks", "zh"),
        ("rolling-wheel-rim-points", "en"),
        ("pin-in-two-rings", "zh"),
        ("square-on-two-fixed-points", "zh"),
    ],
)
def test_an_ordinary_problem_takes_two_pages(name: str, language: str) -> None:
    length = measure_length(name, language)
    assert length.pages <= 2
    assert length.filled[-1] > 0.25


def test_a_solution_shows_the_figure_of_the_paper_with_the_axes_it_names() -> None:
    template = load_template("slider-crank")
    solution = solve_template(template, {})
    question = work_question(QuestionPlace(1, "q1"), solution, ("v_B",), "en")
    mechanism = solution.assembly.mechanism.map(float)
    hints = mark_question(template, ("v_B",))
    assert question.figure == sketch(mechanism, replace(hints, axes="aside"))


def test_axes_that_a_solution_names_stand_in_its_figure_only() -> None:
    template = load_template("two-wheels-on-cylinder")
    solution = solve_template(template, {})
    asks = template.asked()
    on_paper = sketch(solution.assembly.mechanism.map(float), mark_question(template, asks))
    assert "x" not in symbols(on_paper)
    question = work_question(QuestionPlace(1, "q1"), solution, asks, "en")
    assert question.figure is not None
    assert symbols(question.figure) == sorted([*symbols(on_paper), "x", "y"])
