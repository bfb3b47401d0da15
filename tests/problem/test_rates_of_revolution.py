"""Rates given and asked in revolutions and degrees: exact, with pi in them, printed as given."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check
from kinegrade.students.mistaking.mistake_kinds import find_candidates
from kinegrade.worked.solution import write_worked_solution
from tests.problem.turning_crank import changed
from tests.said import all_said
from tests.worked.telling import displayed

RATE = ('unit = "rad/s", draw = [2]', 'unit = "r/min", draw = [100]')
ASKED = ("[asks]\n", '[asks]\nomega_A = { quantity = "omega(OA)", unit = "%s", means = "rate" }\n')
SPEED = 'gives = { v_A = "omega*r" }'


def turning(asked: str, given: str = "r/min", speed: str = "omega*r*pi/30") -> Template:
    """The crank driven at 100 of a unit, its rate asked in another one."""
    return read_template(
        "crank",
        changed(
            (RATE[0], RATE[1].replace("r/min", given)),
            (ASKED[0], ASKED[1] % asked),
            (SPEED, f'gives = {{ v_A = "{speed}" }}'),
        ),
    )


def list_faults(speed: str) -> list[str]:
    """What `check` calls faults of the crank with a published speed."""
    return all_said(check(turning("rad/s", speed=speed), sample=4).faults)


@pytest.mark.parametrize(
    ("given", "asked", "exact"),
    [
        ("r/min", "rad/s", "10*pi/3"),
        ("rpm", "rad/s", "10*pi/3"),
        ("r/min", "r/s", "5/3"),
        ("r/min", "deg/s", "600"),
        ("deg/s", "r/min", "50/3"),
        ("deg/s", "rad/s", "5*pi/9"),
        ("rad/s", "r/min", "3000/pi"),
    ],
)
def test_an_answer_in_another_unit_of_rates_is_exact(given: str, asked: str, exact: str) -> None:
    solution = solve_template(turning(asked, given), {"r": "3/2"})
    assert solution["omega_A"].exact == exact


def test_speeds_and_statements_keep_pi_and_the_unit() -> None:
    solution = solve_template(turning("rad/s"), {"r": "3/2"})
    assert solution["v_A"].exact == "5*pi"
    assert solution["v_A"].value == pytest.approx(15.707963267948966, rel=1e-15)
    assert str(solution.parameters["omega"]) == "omega = 100 r/min"


@pytest.mark.parametrize(
    "speed", ["omega*r*pi/30", "omega*r*2*pi/60", "sqrt(3)*pi*omega*r/(30*sqrt(3))"]
)
def test_a_published_result_with_pi_is_proved(speed: str) -> None:
    assert [fault for fault in list_faults(speed) if "engine gives" in fault] == []


def test_a_wrong_published_result_with_pi_is_a_fault() -> None:
    faults = list_faults("omega*r*pi/60")
    told = "v_A = omega*r*pi/60, but the engine gives 10.47197551 (10*pi/3)"
    assert any(told in fault for fault in faults), faults


def test_a_worked_solution_shows_the_given_unit_before_si() -> None:
    template = read_template("crank", changed(RATE, (SPEED, 'gives = { v_A = "r*omega*pi/30" }')))
    solution = solve_template(template, {"r": "3/2"})
    told = displayed(write_worked_solution(solution, ["v_A"], "en").blocks)
    assert any(
        r"100\,\unit{r/min} = \frac{10\pi}{3}\,\unit{rad/s} \approx 10.47\,\unit{rad/s}" in line
        for line in told
    ), told


def test_a_rate_in_revolutions_may_be_taken_for_radians() -> None:
    template = turning("rad/s")
    names = {mistake.identifier for mistake in find_candidates(template, template.asks)}
    assert "rpm-not-converted" in names
