"""The motion of a template is what differences of positions give, found by an independent model."""

from __future__ import annotations

from pathlib import Path
from random import Random

from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.laws.cases import Case, moving_templates, values_between
from tests.laws.differences import hold_against_positions
from tests.laws.position import regularity

WELL_CONDITIONED = 1e-4  # of what the differences of positions keep nine digits


def hold(seed: int, _: Path) -> None:
    """Hold velocities and accelerations at values between the drawable ones."""
    solution = _solution(seed)
    if regularity(solution.assembly.mechanism) > WELL_CONDITIONED:
        case = Case(solution.assembly.mechanism, solution.arithmetic, solution.motion)
        hold_against_positions(case)


def _solution(seed: int) -> Solution:
    names = moving_templates()
    template = load_template(names[seed % len(names)])
    return solve_template(template, values_between(template, Random(seed)), ())
