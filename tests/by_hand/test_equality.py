"""Papers are alike hard for students who know nothing of how hard they are predicted to be."""

from __future__ import annotations

import pytest

from tests.by_hand.equality import deviations
from tests.by_hand.school import Exam

HALF = 0.5
pytestmark = pytest.mark.xdist_group("by_hand")


def test_papers_differ_half_as_much_as_by_chance(four_figures: Exam) -> None:
    dealt, by_chance = deviations(four_figures)
    assert 0 < dealt <= HALF * by_chance
