"""Where a pole lies by coordinates follows from its velocity, which is zero."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.solution import write_worked_solution
from tests.worked.telling import displayed, proses


@pytest.mark.parametrize(
    ("name", "vanishing"),
    [
        (
            "guide-tube-rod-fixed-centrode",
            [
                r"-v_{\mathrm{a}}\sin\theta - \omega_{BC}(y_{S} - y_{B}) &= 0",
                r"v_{\mathrm{a}}\cos\theta + \omega_{BC}(x_{S} - x_{B}) &= 0",
            ],
        ),
        # on the vertical through B, so that x_S = x_B
        ("pole-sleeve-slider-rod", [r"v_{\mathrm{a}} - \omega_{2}(y_{S} - y_{B}) &= 0"]),
    ],
)
def test_the_velocity_of_a_pole_is_zero_before_its_place_is_told(
    name: str, vanishing: list[str]
) -> None:
    """The coordinates stood there without a reason."""
    template = load_template(name)
    solution = solve_template(template, {})
    told = displayed(write_worked_solution(solution, template.asked(), "en").blocks)
    first = told.index(vanishing[0])
    assert told[first : first + len(vanishing)] == vanishing
    assert told[first + len(vanishing)].partition(" &=")[0] in ("x_{S}", "y_{S}")


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "of the base point $B$ and that of the rotation about $B$ add up to zero"),
        ("de", "Geschwindigkeit des Bezugspunkts $B$ und die infolge der Drehung um $B$"),
        ("zh", "以 $B$ 为基点，$BC$ 的速度瞬心 $S$ 的速度为零"),
    ],
)
def test_it_names_its_base_point(language: Language, said: str) -> None:
    template = load_template("guide-tube-rod-fixed-centrode")
    solution = solve_template(template, {})
    told = proses(write_worked_solution(solution, template.asked(), language).blocks)
    assert said in "\n".join(told)
