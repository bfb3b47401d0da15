"""The check at the end of a chapter goes by another way than its steps: what it says of rates is no
multiple of one equation that they have solved, and a slip that this equation lets pass shows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import pytest

from kinegrade.language import ENGLISH
from kinegrade.mechanics.rates import Rate
from kinegrade.numbers.number import Number
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.document import WorkedSolution
from kinegrade.worked.findings import Form
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn
from tests.worked.telling import proses
from tests.worked.test_checks import Check, find_checks

PRIMES = (11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53)
FINE = 10**9  # parts of a ratio


def write(solution: Solution) -> WorkedSolution:
    """The solution of what an exam asks."""
    return write_worked_solution(solution, solution.template.asked(), ENGLISH)


def are_multiples(first: Mapping[object, float], second: Mapping[object, float]) -> bool:
    """Whether all products of two coefficients, taken crosswise, are the same; nothing is a
    multiple of anything.
    """
    every = {*first, *second}
    size = max(map(abs, first.values()), default=0) * max(map(abs, second.values()), default=0)
    return all(
        abs(first.get(one, 0) * second.get(other, 0) - first.get(other, 0) * second.get(one, 0))
        <= 1e-9 * size
        for one in every
        for other in every
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_check_says_what_one_step_has_said(name: str) -> None:
    for solution in drawn(name):
        told = write(solution)
        assert len(told.checked) <= len(find_checks(told.blocks)) <= 2
        for checked in told.checked:
            assert [one for one in checked.steps if are_multiples(checked.check, one)] == []


def alter(rates: Mapping[Rate, Number]) -> dict[Rate, Number]:
    """Other values, each off by a share of its own, so that no equation holds but by its letters."""
    names = sorted(rates, key=str)
    return {rate: rates[rate] * prime / 10 for rate, prime in zip(names, PRIMES, strict=False)}


def still_holds(check: Check) -> bool:
    """Whether both sides amount to the same, as far as their numbers tell."""
    left, right = (worth[0] for worth in check.sides)
    return abs(left.value - right.value) <= left.room + right.room


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_check_holds_whatever_the_rates_are(name: str) -> None:
    """What has been found of F by v_F = v_O + omega x OF fulfils this with any v_O and omega."""
    solution = drawn(name)[0]
    motion = solution.motion
    if not write(solution).checked:
        return
    other = replace(motion, rates=alter(motion.rates), changes=alter(motion.changes))
    # By the base point: a pole cannot be drawn for velocities that are not those of a body
    asked = solution.template.asked()
    told = write_worked_solution(replace(solution, motion=other), asked, ENGLISH, "base-point")
    altered = find_checks(told.blocks)
    assert [check.way for check in altered if still_holds(check)] == []


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_solution_has_a_check(name: str) -> None:
    assert find_checks(write(drawn(name)[0]).blocks)


def list_slips(solution: Solution, held: Form, sought: set[Rate]) -> Iterator[Mapping[Rate, float]]:
    """Wrong rates that one equation lets pass: two of them off, so that it holds again."""
    rates, form = solution.motion.rates, held
    bound = sorted((rate for rate in form if abs(form[rate]) > 1e-9 and rate in sought), key=str)
    free = next((rate for rate in sorted(sought, key=str) if rate not in bound), None)
    if free is not None:
        yield {**rates, free: rates[free] * 11 / 10}
    elif len(bound) > 1:
        one, other, *_ = bound
        turned = rates[one] * round(FINE * form[one] / form[other]) / FINE
        yield {**rates, one: rates[one] * 11 / 10, other: rates[other] - turned / 10}


@pytest.mark.parametrize(
    "name",
    [
        "slider-crank",
        "watt-linkage",
        "pole-four-bar-coupler",
        "slotted-link-on-cylinder",
        "slotted-rocker-and-slider-two-drivers",
        "rotary-engine",
    ],
)
def test_a_slip_that_one_step_lets_pass_shows(name: str) -> None:
    solution = drawn(name)[0]
    (checked, *_) = write(solution).checked
    sought = {rate for rate in checked.check if any(one.get(rate) for one in checked.steps)}
    for step in checked.steps:
        for wrong in list_slips(solution, step, sought):
            slipped = replace(solution, motion=replace(solution.motion, rates=wrong))
            check = find_checks(write(slipped).blocks)[0]
            assert not check.agrees


@pytest.mark.parametrize("name", ["hoist-with-gears", "flat-faced-follower-eccentric-circle"])
def test_one_equation_for_one_unknown_is_not_said_twice(name: str) -> None:
    """Two gears in mesh say one thing, seen from the ground or from one of them: turns are counted
    instead, or the height of a follower is differentiated, by coordinates, not by angles.
    """
    solution = write(drawn(name)[0])
    assert solution.checked == ()
    assert len(find_checks(solution.blocks)) == 1


OTHER_LAWS = {
    "belt-driven-bicycle": "counting turns: those of the wheel are to those of the pulley",
    "hoist-with-gears": "counting turns: those of the gear are to those of the pinion",
    "two-stage-belt-drive": "counting turns: those of the shaft are to those of the engine pulley",
    "crossed-belt-drive": "the velocity at the relative pole of pulley I and pulley II",
    "two-link-robot-arm": "composition of motions along the $y$ axis",
    "rolling-wheel-pole-acceleration": "the acceleration of the velocity pole $C$ of the wheel",
    "bent-rod-tangent-disc": "the second time derivative of $y_{B}$, once directly",
    "toggle-press": "half the time derivative of $x_{B}^{2} + (y_{D} - y_{B})^{2} = l^{2}$",
    "flat-faced-follower-curvature-radius": "the second time derivative of $y_{K} - y_{A}$, which",
    "flat-faced-follower-eccentric-circle": "the second time derivative of $y_{C} - y_{A}$, which",
}


@pytest.mark.parametrize("name", OTHER_LAWS)
def test_what_one_equation_gives_is_checked_by_another_law(name: str) -> None:
    """Such solutions ended without a check, or put their own equations into one another."""
    solution = drawn(name)[0]
    (check,) = find_checks(write(solution).blocks)
    assert check.way.startswith(OTHER_LAWS[name])
    assert check.agrees
    motion = solution.motion
    other = replace(motion, rates=alter(motion.rates), changes=alter(motion.changes))
    wrong = find_checks(write(replace(solution, motion=other)).blocks)
    assert [one for one in wrong if not one.agrees]


@pytest.mark.parametrize(
    ("name", "equation"),
    [
        ("rolling-wheel-rim-points", r"v_{A_{1},x} = v_{O} - \omega\,y_{A_{1}}$"),
        (
            "wheel-on-circular-track",
            r"v_{B,x} = -v_{O}\cos\theta - \omega_{\text{wheel}}(y_{B} - y_{O})$",
        ),
        (
            "wheel-inside-circular-track",
            r"v_{B,x} = v_{O}\cos\theta - \omega_{\text{wheel}}(y_{B} - y_{O})$",
        ),
    ],
)
def test_what_the_pole_has_given_is_checked_by_the_base_point(name: str, equation: str) -> None:
    (check,) = [text for text in proses(write(drawn(name)[0]).blocks) if "Check by" in text]
    assert check.startswith("Check by the base point $O$ for the $x$ component of the velocity")
    assert equation in check


def test_a_right_angle_that_is_stated_is_checked_by_coordinates() -> None:
    (check,) = find_checks(write(drawn("triangle-pose-three-frames")[0]).blocks)
    assert check.way == "the right angle at $A$, by the scalar product of $AB$ and $AC$"


def test_what_is_asked_of_points_is_checked() -> None:
    """The speed of D, found from the base point A, goes by B too."""
    solution = solve_template(load_template("elliptic-trammel-end-driven"), {})
    check = find_checks(write(solution).blocks)[0]
    assert check.way.startswith("the projection theorem for $D$ and $B$")


@pytest.mark.parametrize(
    ("name", "way", "left"),
    [
        (
            "guide-tube-rod-fixed-centrode",
            r"$OS \perp OB$, as the point of $BC$ at $O$ moves along $OB$",
            r"(x_{S} - x_{O})\,(x_{B} - x_{O}) = ",
        ),
        (
            "pole-sleeve-slider-rod",
            r"$DS \perp DB$, as the point of the rod $BD$ at $D$ moves along $DB$",
            r"x_{S}\,x_{B} = ",
        ),
    ],
)
def test_a_pole_found_by_a_base_point_lies_on_the_normal_to_the_sleeve(
    name: str, way: str, left: str
) -> None:
    (check,) = find_checks(write(drawn(name)[0]).blocks)
    assert check.way == way
    assert check.left.startswith(left)
