"""An honest student: works rightly, writes every intermediate value down rounded, and gets full
marks.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import isclose, radians

import pytest

from kinegrade.draws.examining import Refused, examine
from kinegrade.numbers.rounding import Rounded, Sparing
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check, choose_drawable
from kinegrade.students.rounding.honest_rounding import (
    Stray,
    find_stray,
    work_by_arms,
    work_by_coordinates,
    work_honestly,
)
from kinegrade.students.rounding.targets import Target, find_nearest_turn, find_target
from tests.problem.crank import crank
from tests.problem.draws import dealt, draw_filter, drawn
from tests.said import all_said, said

DIFFERENCE = (
    'quantity = "x(velocity(A))"',
    'quantity = "x(velocity(A)) + omega*r"',
)  # omega (r - h)


def solved(template: Template, **values: str) -> Solution:
    return solve_template(template, {"r": "2", "h": "1/2", "omega": "2", **values})


def tolerance(
    relative: str, absolute: str = "0", figures: int | None = None
) -> dict[str, Tolerance]:
    return {"v_x": Tolerance(Fraction(relative), Fraction(absolute), figures)}


def test_by_coordinates_the_point_is_written_down_and_used_further() -> None:
    found = work_by_coordinates(solved(crank(), h="1.2345", omega="1"), Rounded(3))
    assert found["v_x"] == -1.23  # A is put down at y = 1.23
    assert found["v_y"] == 1.58  # and at x = sqrt(4 - 1.23 squared) = 1.577


def test_by_arms_the_point_stays_in_the_calculator() -> None:
    solution = solved(crank(), h="1.2345", omega="1")
    found = work_by_arms(solution, solution.motion.map(float), Rounded(3))
    assert found == {"v_x": -1.23, "v_y": 1.57}  # sqrt(4 - 1.2345 squared) = 1.5735


def test_sparingly_only_the_solved_rate_is_written_down() -> None:
    solution = solved(crank(), h="1.2345", omega="1.2345")
    found = work_by_arms(solution, solution.motion.map(float), Sparing(3))
    assert found["v_x"] == pytest.approx(-1.23 * 1.2345, rel=1e-14)


def test_a_small_difference_of_written_values_strays() -> None:
    solution = solved(crank(DIFFERENCE), h="1.9", omega="1.77")
    found = find_stray(solution, {})
    assert found is not None
    assert (found.ask, found.figures) == ("v_x", 3)
    assert found.answer == pytest.approx(3.54 - 3.36)  # 1.77 (2 - 1.9) = 0.177
    assert said(found.said()) == "v_x: comes out as 0.18 when 3 significant figures are carried"


def test_what_cannot_be_found_strays_too() -> None:
    # A is put down at y = 1.01: the crank does not reach it
    solution = solved(crank(), r="1.0065", h="1.006")
    assert find_stray(solution, {}) == Stray("v_x", 3, None)
    assert (
        said(Stray("v_x", 3, None).said())
        == "v_x: cannot be found when 3 significant figures are carried"
    )


@pytest.mark.parametrize(
    ("rules", "h", "omega", "figures"),
    [
        (tolerance("1/50"), "1.9", "1.77", None),  # 0.18 instead of 0.177 is 1.7 % off
        (tolerance("1/60"), "1.9", "1.77", 3),
        (tolerance("0", "0.0031"), "1.9", "1.77", None),
        (tolerance("0", "0.0029"), "1.9", "1.77", 3),
        (
            tolerance("1/200"),
            "1.9",
            "1.77",
            None,
        ),  # so strict a rule wants four figures: 3.540 - 3.363
        (tolerance("0", figures=3), "1.9", "1.77", None),
        (
            tolerance("0", figures=3),
            "1.97",
            "1.7777",
            4,
        ),  # 3.5554 - 1.778 * 1.97 = 0.0524 instead of 0.0533
    ],
)
def test_the_tolerance_of_the_ask_decides(
    rules: dict[str, Tolerance], h: str, omega: str, figures: int | None
) -> None:
    found = find_stray(
        solve_template(crank(DIFFERENCE), {"r": "2", "h": h, "omega": omega}, ["v_x"]), rules
    )
    assert (found and found.figures) == figures


@pytest.mark.parametrize(
    ("worked", "right"),
    [
        (1.005, True),
        (0.995, True),
        (1.00501, False),
        (None, False),
        (1.0006, True),  # both as it came out and as it is written, 1.001
    ],
)
def test_the_bounds_are_right(worked: float | None, right: bool) -> None:
    assert Target(0.995, 1.005, 1.0, 0.0, 4).met(worked, 4) is right


def test_an_answer_may_be_typed_with_more_figures_than_were_carried() -> None:
    aim = Target(1.0, 1.03449, 1.01, 0.0, 3)
    assert aim.met(1.03444, 3)  # 1.03, 1.034, 1.0344
    assert not aim.met(1.034486, 3)  # 1.03 is right, and so is all of it, but not 1.0345
    assert not aim.met(1.0351, 3)


def test_angles_are_compared_without_full_turns() -> None:
    assert find_nearest_turn(-179.9, 180.0, 360.0) == pytest.approx(180.1)
    assert find_nearest_turn(radians(3), radians(1), 0.0) == radians(3)
    assert find_nearest_turn(725.0, 4.0, 360.0) == 5.0


def test_a_centrode_is_known_in_closed_form() -> None:
    solution = solve_template(load_template("rod-ground-incline-fixed-centrode"), {}, ["rho"])
    assert work_by_coordinates(solution, Rounded(3)) == {"rho": solution["rho"].value}


def test_what_an_honest_student_would_get_wrong_is_not_dealt() -> None:
    heights = tuple(f"1.{digits}" for digits in range(500, 900))
    fixed = {"r": ("2",), "h": heights, "omega": ("1.77",)}
    narrow = draw_filter(crank(DIFFERENCE), fixed=fixed, asks=("v_x",))
    wide = replace(narrow, tolerances=tolerance("1/2"))
    for one in drawn(narrow, 12):
        exact = one.solution["v_x"].value
        honest = work_by_coordinates(one.solution, Rounded(3))["v_x"]
        assert abs(honest - exact) <= exact / 100
    refused, fewer = (dealt(each, 12).refused.get("rounding", 0) for each in (narrow, wide))
    assert refused > fewer


def test_the_refusal_says_which_answer_strays() -> None:
    with pytest.raises(
        Refused, match=r"^v_x: comes out as 0\.18 when 3 significant figures are carried$"
    ) as caught:
        examine(crank(DIFFERENCE), {"r": "2", "h": "1.9", "omega": "1.77"}, ("v_x",))
    assert (caught.value.reason, caught.value.ask) == ("rounding", "v_x")


def test_check_tells_the_author_which_answer_often_strays() -> None:
    narrow = ('draw = [0, "1/2", 3]', 'draw = "1.90 .. 1.99 step 0.01"')
    report = check(
        crank(
            DIFFERENCE,
            narrow,
            ("draw = [1, 2]", "draw = [2]"),
            ("draw = [2, 1000000, 20000000]", 'draw = "1.71 .. 1.79 step 0.01"'),
        ),
        sample=60,
    )
    (remark,) = [remark for remark in all_said(report.remarks) if "significant" in remark]
    assert remark.startswith(
        f"v_x is off by more than 1 % in {report.refused['rounding']} of 60 instances when every"
    )


@pytest.mark.parametrize("name", find_template_names())
def test_whoever_rounds_nothing_finds_the_exact_answers(name: str) -> None:
    """The work of the honest student is the mechanics of the key, in other arithmetic and from
    rounded terms.
    """
    template, all_figures = load_template(name), Rounded(14)
    for values in choose_drawable(template, 40)[:3]:
        try:
            solution = examine(
                template,
                values,
                template.asks,
                None,
                {ask: Tolerance(Fraction(10**6), Fraction(10**9)) for ask in template.asks},
            )
        except Refused:
            continue
        motion = solution.motion.map(float)
        for worked in (
            work_by_coordinates(solution, all_figures),
            work_by_arms(solution, motion, all_figures),
        ):
            for ask, answer in solution.answers.items():
                aim = find_target(template.asks[ask], answer, ONE_PER_CENT, motion)
                assert isclose(
                    find_nearest_turn(worked[ask], aim.exact, aim.turn),
                    aim.exact,
                    rel_tol=1e-7,
                    abs_tol=1e-7,
                )


def test_accepted_draws_leave_every_honest_student_right() -> None:
    template = load_template("slotted-bar-between-two-rods")
    for solution in (one.solution for one in drawn(draw_filter(template), 12)):
        motion = solution.motion.map(float)
        aims = {
            ask: find_target(template.asks[ask], answer, ONE_PER_CENT, motion)
            for ask, answer in solution.answers.items()
        }
        for worked in work_honestly(solution, motion, 3, every=True):
            assert all(aims[ask].met(number, 3) for ask, number in worked.items())
            assert worked.keys() == aims.keys()
