"""Honest students by every textbook method have full marks, however they round."""

from __future__ import annotations

import pytest

from tests.by_hand.claims import honest
from tests.by_hand.exceptions import ROUNDED_AWAY
from tests.by_hand.school import Exam

SPREAD = 2 / 155  # of the points of a paper
pytestmark = pytest.mark.xdist_group("by_hand")


def test_every_method_agrees_with_the_key(four_figures: Exam) -> None:
    found = honest(four_figures)
    assert found.tried.total() > 0
    assert not found.failed, str(found)


def test_four_figures_in_every_operation_keep_full_marks(four_figures: Exam) -> None:
    found = honest(four_figures, figures=4)
    assert not found.failed, str(found)


def test_three_figures_keep_full_marks_where_tolerances_are_honest(three_figures: Exam) -> None:
    found = honest(three_figures, figures=3)
    assert found.share <= ROUNDED_AWAY, str(found)
    assert found.worst_paper <= SPREAD * three_figures.papers[0].points, str(found)
