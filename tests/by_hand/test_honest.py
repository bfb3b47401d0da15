"""Honest students by every textbook method have full marks, however they round."""

from __future__ import annotations

import pytest

from tests.by_hand.claims import honest
from tests.by_hand.school import Exam

pytestmark = pytest.mark.xdist_group("by_hand")


def test_every_method_agrees_with_the_key(four_figures: Exam) -> None:
    found = honest(four_figures)
    assert found.tried.total() > 0
    assert not found.failed, found


def test_four_figures_in_every_operation_keep_full_marks(four_figures: Exam) -> None:
    found = honest(four_figures, figures=4)
    assert not found.failed, found
