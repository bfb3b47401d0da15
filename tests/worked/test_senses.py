"""Senses and directions stand beside values in words, with formulas between them."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.language.math.tree import Letter, Text, list_nodes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Display
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import kept, stated, told
from tests.worked.reader.laws import find_faults
from tests.worked.telling import displayed, lines, proses


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_letter_in_a_direction_is_a_formula(language: Language) -> None:
    solution = solve_template(load_template("crossed-belt-drive"), {})
    blocks = write_worked_solution(solution, ("v_B",), language).blocks
    lines = [line for block in blocks if isinstance(block, Display) for line in block.lines]
    (speed,) = (line for line in lines if write_row(line).startswith("v_{A} "))
    nodes = list(list_nodes(speed))
    assert Letter("O") in nodes[-3:]
    assert not [node for node in nodes if isinstance(node, Text) and "$" in node.text]


def test_a_value_against_its_positive_sense_says_which_way_the_vector_points() -> None:
    told = "".join(displayed(kept("crank-rocker-towed-wheel")))
    assert r"-0.4\,\unit{m/s}\quad\text{(clockwise about }D\text{)}" in told
    assert r"-0.8\,\unit{m/s}\quad\text{(to the left)}" in told


def test_a_given_motion_along_a_line_of_two_points_is_told_from_point_to_point() -> None:
    told = "".join(displayed(stated("two-rods-driven-ends", gamma="75")))
    assert r"v_{A} &= 0.2\,\unit{m/s}\quad(\text{from }O\text{ to }A)" in told


@pytest.mark.parametrize(
    ("language", "convention"),
    [
        ("en", "Counted as asked for (positive in the direction of $-x$):"),
        ("zh", "按题中规定的正方向（沿 $x$ 轴负向为正）："),
        # the author has no words in German
        ("de", "Mit dem Vorzeichen der Frage:"),
    ],
)
def test_an_answer_in_the_opposite_sense_names_the_sign_that_is_asked_for(
    language: Language, convention: str
) -> None:
    """One symbol has one value, here the size of the Coriolis acceleration."""
    blocks = stated("pin-in-disc-slot-and-rod", language)
    place = next(number for number, block in enumerate(blocks) if convention in proses([block]))
    value = displayed([blocks[place + 1]])[0].replace("{,}", ".")
    assert value.startswith(r"-a_{\mathrm{Cor}1} &= -14.4\,\unit{m/s^2}")


@pytest.mark.parametrize(
    ("name", "given", "told"),
    [
        (
            "rolling-wheel-rim-points",
            {"a_O": "-8"},
            r"a_{O} &= 8\,\unit{m/s^2}\quad\text{(to the left)}",
        ),
        (
            "two-wheels-on-cylinder",
            {"v_A": "2"},
            r"v_{A} &= 2\,\unit{m/s}\quad\text{(clockwise about }O\text{)}",
        ),
    ],
)
def test_a_given_speed_is_the_size_that_the_statement_prints(
    name: str, given: dict[str, str], told: str
) -> None:
    """One symbol was the size in the statement and a negative number in the solution."""
    lines = displayed(stated(name, "en", **given))
    assert told in lines
    letter = told.partition(" &=")[0]
    assert [line for line in lines if f"\\left|{letter}\\right|" in line] == []


@pytest.mark.parametrize(
    ("name", "given"),
    [
        # the tangential acceleration of the centre is found by its size, then rolling takes it
        (
            "ring-gear-planet-relative-spin",
            {"R1": "0.4", "R2": "0.1", "phi_3": "255", "omega_3": "5", "alpha_3": "-20"},
        ),
        # v_r is positive by the step and negative in the sense of the question
        (
            "slotted-bar-between-two-rods",
            {"l_AB": "120", "theta": "60", "v_A": "30", "a_A": "20", "v_B": "-40", "a_B": "40"},
        ),
    ],
)
def test_a_symbol_keeps_the_sign_with_which_it_has_been_told(
    name: str, given: dict[str, str]
) -> None:
    solution = solve_template(load_template(name), given)
    assert [one.line for one in find_faults(told(solution), solution) if one.law == "equal"] == []


def test_a_point_about_a_fixed_axis_has_a_normal_and_a_tangential_acceleration_told_once() -> None:
    blocks = kept("ring-gear-planet-relative-spin", 1)
    starts = [line.partition(" &=")[0] for line in displayed(blocks)]
    assert starts.count(r"a_{O_{2}}^{\mathrm{n}}") == 1
    assert starts.count(r"a_{O_{2}}^{\mathrm{t}}") == 1
    assert [
        text for text in proses(blocks) if text.startswith("$O_{2}$ belongs to both bodies")
    ] == []


#: Answers against the letter of a Coriolis acceleration, which a page gives by its size, or of a
#: rotation
COUNTED_AGAIN = {
    "belt-driven-bicycle",
    "pin-in-disc-slot-and-rod",
    "rocker-driven-by-two-slider-link",
}


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_symbol_has_one_sense_on_a_page(name: str) -> None:
    turned = any("Counted as asked" in line for line in lines(kept(name, 1)))
    assert turned == (name in COUNTED_AGAIN)


def test_an_angular_acceleration_against_the_motion_has_its_own_letter_in_the_statement() -> None:
    """The statement said alpha_AB = 10 rad/s^2, and the solution -10."""
    solution = solve_template(load_template("four-bar-parallel-coupler"), {"alpha_AB": "-10"})
    blocks = told(solution)
    assert [one.line for one in find_faults(blocks, solution) if one.law == "given"] == []
    assert any(line.startswith(r"\alpha_{AB} &= -\alpha = -10\,") for line in displayed(blocks))
