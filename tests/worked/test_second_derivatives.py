"""Accelerations are checked by differentiating twice what positions fulfil: no relative velocity
and no Coriolis acceleration of the steps stands in it, so that a wrong one of these shows.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.mechanics.rates import make_turning
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Prose
from kinegrade.worked.solution import write_worked_solution
from tests.worked.test_checks import Check, find_checks

# One of each kind: the body whose angular acceleration is checked
KINDS = {
    "slotted-link-on-cylinder": ("AC", "the second time derivative of the angle "),
    "crank-rod-over-translating-pin": ("AB", "the second time derivative of the angle "),
    "four-bar-parallel-coupler": ("DE", "half the second time derivative of "),
    "bent-coupler-instant-translation": ("ABC", "half the second time derivative of "),
    "guided-rack-and-gear": ("rack", "the second time derivative of the constant "),
    "rod-sliding-on-driven-wheel": ("AB", "the second time derivative of the constant "),
}


def solve(name: str) -> Solution:
    return solve_template(load_template(name), {})


def find_last(solution: Solution) -> Check:
    """The check at the end of the solution of what an exam asks."""
    asked = solution.template.asked()
    *_, last = find_checks(write_worked_solution(solution, asked, ENGLISH).blocks)
    return last


@pytest.mark.parametrize("name", KINDS)
def test_accelerations_are_checked_by_what_positions_fulfil(name: str) -> None:
    check = find_last(solve(name))
    assert check.way.startswith(KINDS[name][1])
    assert check.agrees
    assert r"v_{\mathrm{r}}" not in check.left + check.right


@pytest.mark.parametrize("name", KINDS)
def test_a_wrong_angular_acceleration_shows(name: str) -> None:
    solution = solve(name)
    changes, turning = solution.motion.changes, make_turning(KINDS[name][0])
    wrong = {**changes, turning: changes[turning] * 11 / 10}
    slipped = replace(solution, motion=replace(solution.motion, changes=wrong))
    assert not find_last(slipped).agrees


def test_the_angle_is_printed_that_is_differentiated() -> None:
    check = find_last(solve("slotted-link-on-cylinder"))
    assert check.way == (
        r"the second time derivative of the angle $\arctan\frac{y_{B}}{x_{B}}$ of $AB$, "
        "multiplied by the square of this length"
    )
    assert check.left == "0"
    assert check.right.startswith(r"\alpha_{AC}\,AB^{2} + 2\omega_{AC}\,y_{B}\,v_{")


def test_the_length_is_printed_that_is_differentiated() -> None:
    check = find_last(solve("two-rods-driven-ends"))
    assert check.way == (
        "half the second time derivative of $(x_{C} - x_{B})^{2} + y_{C}^{2} = BC^{2}$"
    )
    assert check.left.startswith(r"(x_{C} - x_{B})\,a_{C,x} + y_{C}\,a_{C,y} = ")


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "der zweiten zeitlichen Ableitung des Winkels"),
        ("zh", "求二阶时间导数"),
    ],
)
def test_other_languages_say_it_too(language: Language, said: str) -> None:
    solution = solve("slotted-link-on-cylinder")
    blocks = write_worked_solution(solution, solution.template.asked(), language).blocks
    assert said in "\n".join(block.text for block in blocks if isinstance(block, Prose))
