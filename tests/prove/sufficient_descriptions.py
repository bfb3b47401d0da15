"""Whoever has the description of a figure alone finds the key: a reader that shares nothing with
its writer sets the mechanism up from the sentences, and solves it in plain floats.
"""

from __future__ import annotations

from pathlib import Path

from tests.description.questions import list_differences, write_question
from tests.description.reader import solve
from tests.prove.draws import seeded_solution


def hold(seed: int, _: Path) -> None:
    """Read the description of the instance of a seed, with all that is asked by default."""
    solution = seeded_solution(seed)
    asks = solution.template.asked()
    found = solve(dict(write_question(solution, asks)))
    wrong = list_differences(solution, asks, found)
    assert not wrong, f"{solution.template.name}: {wrong}"
