"""Sheets that nobody worked for earn next to nothing, and little by follow-through."""

from __future__ import annotations

import pytest

from tests.by_hand.adversaries import Earned, earn, list_patterns, too_much
from tests.by_hand.school import Exam

SHEETS = 1  # of each pattern; 3 in `make prove`
pytestmark = pytest.mark.xdist_group("by_hand")


def test_sheets_without_work_earn_next_to_nothing(four_figures: Exam) -> None:
    found = earn(four_figures, SHEETS)
    assert found.keys() == list_patterns(four_figures).keys()
    assert too_much(found) == {}


def test_right_answers_are_no_sheet_without_work() -> None:
    honest, lucky = [Earned(1.0, 1.0)], [Earned(0.0, 0.0), Earned(0.09, 0.0)]
    followed = [Earned(0.0, 0.0)] * 9 + [Earned(0.12, 0.01)]
    found = {"honest": honest, "lucky": lucky, "followed": followed}
    assert too_much(found).keys() == {"honest", "followed"}
