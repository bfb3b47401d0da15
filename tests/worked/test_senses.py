"""Senses and directions stand beside values in words, with formulas between them."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.language.math.tree import Number, Text, list_nodes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Display
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import kept
from tests.worked.telling import displayed, proses


@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_angle_of_a_direction_is_a_formula(language: Language) -> None:
    solution = solve_template(load_template("two-rods-driven-ends"), {})
    blocks = write_worked_solution(solution, ("v_C",), language).blocks
    lines = [line for block in blocks if isinstance(block, Display) for line in block.lines]
    nodes = list(list_nodes(lines[-1]))
    assert Number("30") in nodes
    assert not [node for node in nodes if isinstance(node, Text) and "$" in node.text]


def test_a_value_against_its_positive_sense_says_which_way_the_vector_points() -> None:
    told = "".join(displayed(kept("crank-rocker-towed-wheel")))
    assert r"-0.4\,\unit{m/s}\quad\text{(clockwise about }D\text{)}" in told
    assert r"-0.8\,\unit{m/s}\quad\text{(to the left)}" in told


@pytest.mark.parametrize(
    ("language", "convention"),
    [
        ("en", "With the sign convention of the question (positive from $B$ towards $A$):"),
        ("zh", "按题目的符号规定（由 $B$ 指向 $A$ 为正）："),
        # the author has no words in German
        ("de", "Mit der Vorzeichenfestlegung der Aufgabe:"),
    ],
)
def test_an_answer_in_the_opposite_sense_names_the_convention_of_the_question(
    language: Language, convention: str
) -> None:
    """One symbol is not set equal to its own size: v_r = -|v_r|."""
    blocks = kept("slotted-bar-between-two-rods", language=language)
    place = next(number for number, block in enumerate(blocks) if convention in proses([block]))
    value = displayed([blocks[place + 1]])[0].replace("{,}", ".")
    assert value.startswith(r"v_{\mathrm{r}} &= 0.01\,\unit{m/s}")
