"""Senses and directions stand beside values in words, with formulas between them."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.language.math.tree import Number, Text, list_nodes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Display
from kinegrade.worked.solution import write_worked_solution


@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_angle_of_a_direction_is_a_formula(language: Language) -> None:
    solution = solve_template(load_template("two-rods-driven-ends"), {})
    blocks = write_worked_solution(solution, ("v_C",), language).blocks
    lines = [line for block in blocks if isinstance(block, Display) for line in block.lines]
    nodes = list(list_nodes(lines[-1]))
    assert Number("30") in nodes
    assert not [node for node in nodes if isinstance(node, Text) and "$" in node.text]
