"""Lengths and coordinates of a solution are derived before a check takes them, and once."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept, stated
from tests.worked.telling import displayed, lines
from tests.worked.test_checks import read_checks

ROCKER = "slider-crank-relative-rotation-driver"
COORDINATE = re.compile(r"[xy]_\{[A-Z][0-9_{}']*\}")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_check_takes_coordinates_that_the_page_has(name: str) -> None:
    _assert_derived(name)


def test_so_does_one_of_a_length_that_does_not_change() -> None:
    sides = "".join(check.left + check.right for check in read_checks(ROCKER))
    assert COORDINATE.search(sides)
    _assert_derived(ROCKER)


def _assert_derived(name: str) -> None:
    """A side has the letters of its numbers, and no product of vectors instead of them."""
    for place in (0, 1):
        derived = {line.partition(" &=")[0] for line in displayed(kept(name, place))}
        for check in read_checks(name, place):
            sides = check.left + check.right
            assert r"\overrightarrow" not in sides
            assert set(COORDINATE.findall(sides)) <= derived


def test_a_length_that_givens_fix_is_derived_once_with_its_reason() -> None:
    told = tuple(lines(kept(ROCKER)))
    (place,) = (number for number, line in enumerate(told) if "both lie on the guide" in line)
    assert told[place].endswith(r"obeys $l_{OA}\sin\theta = l\sin\psi$:")
    assert told[place + 1].startswith(r"    l_{OA} &= \frac{l\sin\psi}{\sin\theta} = ")
    assert [line.count(r"{\sin\theta}") for line in told].count(1) == 1


def test_a_named_length_that_is_asked_is_not_worked_out_again() -> None:
    (asked,) = (line for line in displayed(kept(ROCKER)) if line.startswith("l_{2}"))
    assert asked.startswith(r"l_{2} &= l_{OA} = ")


LEVEL = re.compile(r"\b([A-Z](?:_\{\d\})?)([A-Z](?:_\{\d\})?) &?= (-?)([xy])_\{[^}]*\} - [xy]_\{")

ON_A_LEVEL = ("guided-rack-and-gear", "stone-crusher")  # have such a length as published


@pytest.mark.sampled(12, first=1, also=ON_A_LEVEL)
@pytest.mark.parametrize("name", find_template_names())
def test_a_distance_by_one_coordinate_stands_after_the_other_ones_are_equal(name: str) -> None:
    """DB = x_D - x_B stood there, and nothing said that D and B have the same height."""
    seen = False
    for place in range(len(drawn(name))):
        told = "\n".join(lines(kept(name, place), boxes=False))
        for first, second, _, axis in LEVEL.findall(told):
            seen = True
            across = "y" if axis == "x" else "x"
            letters = re.escape(f"{across}_{{{first}}}"), re.escape(f"{across}_{{{second}}}")
            level = rf"^ *({letters[0]} - {letters[1]}|{letters[0]}|{letters[1]}) &= .*0$"
            equal = (
                rf"^ *({letters[0]} &= {letters[1]}|{letters[1]} &= {letters[0]})( =| \\approx|$)"
            )
            assert re.search(rf"{level}|{equal}", told, re.MULTILINE), f"{first}{second}"
    assert seen or name not in ON_A_LEVEL


def test_it_does_so_where_points_are_level_at_this_instant_alone() -> None:
    given = {"theta": "60", "beta": "60", "R": "0.8", "r": "0.3", "omega": "-4", "alpha": "10"}
    solution = solve_template(load_template("wheel-on-circular-track"), given)
    answers = {name: solution.answers[name] for name in ("v_O", "v_B")}
    blocks = write_worked_solution(replace(solution, answers=answers), answers, "en").blocks
    told = displayed(blocks)
    assert any(line.startswith("y_{D} - y_{B} &= ") for line in told), told


@pytest.mark.parametrize("beta", ["45", "50"])
def test_half_a_right_angle_does_not_exchange_sine_and_cosine(beta: str) -> None:
    """DE stands across CD, which makes beta with the x axis; at 45 degrees it went by the cosine,
    which gives the right number there alone.
    """
    solution = solve_template(load_template("crank-rocker-towed-wheel"), {"beta": beta})
    told = "\n".join(lines(write_worked_solution(solution, ("v_E",), "en").blocks))
    assert r"DE = \frac{x_{E} - x_{D}}{\sin\beta}" in told


def test_a_length_is_derived_by_a_given_one_where_both_are_one_step() -> None:
    """OA was x_A/cos(phi), about 1.6 m: l/sin(phi) is 1.6 m, and takes no rounded coordinate."""
    told = "\n".join(lines(stated("bar-through-swivelling-sleeve", phi="150", l="0.8")))
    given = r"OA = \frac{l}{\sin\varphi} = \frac{0.8\,\unit{m}}{\sin 150^\circ} = 1.6\,\unit{m}"
    assert given in told


def test_a_pole_beside_a_point_that_moves_along_an_axis_is_on_the_normal_there() -> None:
    """SB = y_B - y_S stood there, and nothing said that S is below B."""
    solution = solve_template(load_template("pole-sleeve-slider-rod"), {})
    told = "\n".join(lines(write_worked_solution(solution, solution.template.asked(), "en").blocks))
    assert (
        "As $B$ moves horizontally, the velocity pole $S$ of the rod $BD$ lies on the vertical"
        in told
    )
