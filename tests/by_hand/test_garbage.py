"""Numbers that nobody worked out earn next to nothing, whatever follows from them."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

import pytest

from tests.by_hand.school import Exam, Paper, Question

MEAN, MOST = 0.05, 0.25  # of the points: of all papers, and of the paper that earns most
pytestmark = pytest.mark.xdist_group("by_hand")
Number = Callable[[Random, float], float]


def guess(random: Random, right: float) -> float:
    return float(random.choice((1, -1)) * 10 ** random.uniform(-2, 2))


@pytest.mark.parametrize(
    "number",
    [
        pytest.param(lambda random, right: 1.0, id="one everywhere"),
        pytest.param(lambda random, right: -2.0, id="minus two everywhere"),
        pytest.param(guess, id="random"),
        pytest.param(lambda random, right: 1e4, id="huge"),
        pytest.param(lambda random, right: 1e-4, id="tiny"),
        pytest.param(lambda random, right: 0.02 * right, id="a fiftieth of what is right"),
        pytest.param(lambda random, right: 100 * right, id="a hundred times what is right"),
    ],
)
def test_garbage_earns_next_to_nothing(four_figures: Exam, number: Number) -> None:
    random = Random("garbage")

    def typed(paper: Paper, question: Question) -> dict[str, float]:
        return {ask: number(random, right) for ask, right in question.right.items()}

    earned: dict[str, float] = {}
    for mark in four_figures.mark(typed):
        earned[mark.paper.student] = earned.get(mark.paper.student, 0.0) + mark.points
    shares = [
        earned[paper.student] / sum(sum(each.points.values()) for each in paper.questions)
        for paper in four_figures.papers
    ]
    assert sum(shares) / len(shares) <= MEAN
    assert max(shares) <= MOST
