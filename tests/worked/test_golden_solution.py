"""Worked solutions as text, read by a person once and held since; `pytest --regenerate-golden`
writes them anew.
"""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Method
from kinegrade.worked.solution import write_worked_solution
from tests.golden_files import Hold
from tests.worked.telling import lines


@pytest.mark.parametrize(
    ("name", "language", "method"),
    [
        ("slider-crank", "en", None),
        ("slider-crank", "en", "pole"),
        ("bar-through-swivelling-sleeve", "zh", None),
    ],
)
def test_a_worked_solution_as_text(
    name: str, language: Language, method: Method | None, hold: Hold
) -> None:
    template = load_template(name)
    told = write_worked_solution(solve_template(template, {}), template.asked(), language, method)
    kind = f"-{method}" if method else ""
    hold(f"{name}{kind}-{language}.solution.txt", "\n".join(lines(told.blocks)) + "\n")
