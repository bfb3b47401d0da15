"""A worked solution is written in the letters of the statement: what the statement prints without a
minus is positive there too, and everything else follows from it as before.
"""

from __future__ import annotations

import math

import pytest

from kinegrade.language import ENGLISH
from kinegrade.numbers.angle import Angle
from kinegrade.problem.as_stated import restate
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.solution import write_worked_solution
from tests.problem.crank import crank
from tests.worked.telling import displayed

NEGATIVE = {
    "bent-coupler-instant-translation": {"alpha": "-5"},
    "eccentric-cam-offset-follower": {"phi": "-30", "alpha": "-10"},
    "crossed-belt-drive": {"phi": "345"},
    "five-bar-two-driven-cranks": {"gamma": "-15", "psi_2": "210", "omega_1": "-2", "eps_2": "-4"},
    "flat-faced-follower-curvature-radius": {"theta": "-15", "omega": "-3"},
    "planetary-gear-external-rim-accelerations": {"phi": "210"},
    "planetary-gear-external-rim-velocities": {"phi": "330"},
    "pose-cam-tappet": {"psi": "285"},
    "ring-gear-planet-relative-spin": {"phi_3": "195"},
}


@pytest.mark.parametrize("name", NEGATIVE)
def test_the_restated_template_at_positive_values_has_the_same_answers(name: str) -> None:
    solution = solve_template(load_template(name), NEGATIVE[name])
    stated = restate(solution)
    given = {name: quantity.exact or "" for name, quantity in stated.parameters.items()}
    assert [name for name in NEGATIVE[name] if stated.parameters[name].is_reversed] == []
    assert dict(solve_template(stated.template, given)) == dict(solution)


def test_a_restated_angle_goes_with_pi_where_no_field_holds_the_instance() -> None:
    solution = solve_template(load_template("oscillating-flat-faced-follower"), {"phi": "-45"})
    assert not solution.arithmetic.exact  # by the pi of 60 r/min
    values = restate(solution).assembly.values
    assert float(values["phi"] + values["pi"]) == pytest.approx(1.25 * math.pi)


def test_a_driven_rate_is_taken_from_zero_where_its_sense_is_in_words() -> None:
    said = ("turns with {{ omega }};", "{{ OA.turning }};")
    for changes, expected in (((said,), r"= -\omega = -2"), ((), r"= \omega = -2")):
        solution = solve_template(crank(*changes), {"omega": "-2", "h": "1/2"})
        lines = displayed(write_worked_solution(solution, ("v_x",), ENGLISH).blocks)
        assert any(expected in line for line in lines), lines


def test_nothing_is_restated_where_all_that_is_printed_is_positive() -> None:
    solution = solve_template(crank(), {"omega": "-2", "h": "1/2"})
    assert restate(solution) is solution


def test_an_angle_beyond_half_a_turn_is_worked_with_as_it_is_printed() -> None:
    """The statement says 165 degrees, clockwise; 165 - 15 is 150, and 180 - 165 is not 375."""
    given = {"psi_2": "195", "theta": "15", "gamma": "-15", "psi_1": "105"}
    solution = solve_template(load_template("five-bar-two-driven-cranks"), given)
    lines = displayed(write_worked_solution(solution, ("v_C",), ENGLISH).blocks)
    assert any(r"\cos(\psi_{2} - \theta)" in line for line in lines), lines
    assert any(r"\cos 150^\circ" in line for line in lines), lines
    assert [line for line in lines if "375" in line] == []


def test_so_it_is_where_no_field_holds_the_instance() -> None:
    """The statement says 40 degrees, clockwise; the solution took the cosine of -320."""
    given = {"psi": "320", "r": "0.46", "e": "0.22"}
    solution = solve_template(load_template("pose-cam-tappet"), given)
    assert not isinstance(solution.assembly.values["psi"], Angle)
    lines = displayed(write_worked_solution(solution, ("y_A",), ENGLISH).blocks)
    assert any(r"\cos 40^\circ" in line for line in lines), lines
    assert [line for line in lines if "320" in line] == []
