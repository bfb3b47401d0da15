"""Values of a template: degrees as numbers or as angles, multiples of pi, and numbers that grow."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from tests.problem.turning_crank import CRANK


@pytest.mark.parametrize(
    ("value", "exact"),
    [
        ("60", "1"),
        ("pi/3", "1"),
        ("2*atan(1/2)", "8/5"),
        ("acos(3/5)", "8/5"),
        ("37", None),
        ("sqrt(2)", None),
        ("180/pi", None),
    ],
)
def test_degrees_may_be_numbers_or_angles(value: str, exact: str | None) -> None:
    text = CRANK.replace("magnitude(velocity(A))", "y(A)*2/sqrt(3)" if exact == "1" else "y(A)*2")
    answer = solve_template(read_template("crank", text, kept=True), {"phi": value, "r": "1"})[
        "v_A"
    ]
    assert answer.exact == exact


def test_lengths_and_rates_with_pi_in_them_are_certified() -> None:
    text = CRANK.replace('A = "polar(O, r, phi)"', 'A = "(r*phi, 0)"').replace(
        'velocity = "omega"', 'velocity = "2*pi*omega/60"'
    )
    answer = solve_template(read_template("crank", text), {"phi": "90"})["v_A"]
    assert not answer.is_exact
    assert abs(answer.value - 3.141592653589793**2 / 30) < 1e-14  # pi/2 * 2 pi 2/60


def test_numbers_that_would_grow_without_end_are_cut_to_certified_balls() -> None:
    lengths = "\n".join(f'l{i + 1} = "l{i}**16 + 1e-9"' for i in range(12))
    text = CRANK.replace('half = "r/2"', f'half = "r/2"\nl0 = "9/10"\n{lengths}').replace(
        "polar(O, half, phi)", "(l12, 0)"
    )
    assert abs(solve_template(read_template("crank", text), {})["v_A"].value - 2) < 1e-15
